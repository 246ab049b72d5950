#include "render/gl/window.hpp"

// GLEW before anything else of OpenGL.
#include <GL/glew.h>
#include <fmt/format.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkVersion.h>

#include <cstdlib>
#include <memory>

#include "render/gl/gl_context.hpp"
#include "render/outputs.hpp"

#define SEICHE_STOCK_OSMESA (VTK_MAJOR_VERSION > 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 4))

namespace seiche::render {
namespace {

#if !SEICHE_STOCK_OSMESA
/// VTK's window with OSMesa's context under it, which a VTK built for GLX doesn't have.
class OsmesaWindow : public vtkOpenGLRenderWindow {
 public:
  static OsmesaWindow* New();
  vtkTypeMacro(OsmesaWindow, vtkOpenGLRenderWindow);

  void Initialize() override {
    if (!context_) CreateAWindow();
  }
  void Finalize() override {
    if (context_) DestroyWindow();
  }
  void MakeCurrent() override {
    if (context_) context_->make_current();
  }
  bool IsCurrent() override { return context_ && context_->is_current(); }
  // What is drawn is read where it is drawn: nobody needs VTK's copy for a display.
  void Frame() override {}
  vtkTypeBool IsDirect() override { return 0; }
  void* GetGenericDisplayId() override { return nullptr; }
  void* GetGenericWindowId() override { return nullptr; }
  void* GetGenericParentId() override { return nullptr; }
  void* GetGenericContext() override { return context_.get(); }
  void* GetGenericDrawable() override { return nullptr; }

  // GLEW built for GLX returns an error after it has resolved every function: what counts is the version it found.
  void OpenGLInitContext() override {
    if (Initialized) return;
    glewExperimental = GL_TRUE;
    glewInit();
    if (!GLEW_VERSION_3_2)
      throw NoGl("OpenGL 3.2 is missing; install Debian's packages libosmesa6 and libgl1-mesa-dri");
    GlewInitValid = true;
    Initialized = true;
  }

 protected:
  OsmesaWindow() = default;
  ~OsmesaWindow() override { Finalize(); }

  void CreateAWindow() override {
    context_ = std::make_unique<gl::Context>();
    MakeCurrent();
    Mapped = 1;
    OpenGLInit();
  }
  void DestroyWindow() override {
    MakeCurrent();
    ReleaseGraphicsResources(this);
    context_.reset();
    Mapped = 0;
    Initialized = false;
  }

 private:
  std::unique_ptr<gl::Context> context_;
};

vtkStandardNewMacro(OsmesaWindow);
#endif

}  // namespace

vtkSmartPointer<vtkRenderWindow> make_window(int width, int height) {
#if SEICHE_STOCK_OSMESA
  setenv("VTK_DEFAULT_OPENGL_WINDOW", "vtkOSOpenGLRenderWindow", 0);
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
#else
  vtkSmartPointer<vtkRenderWindow> window = vtkSmartPointer<OsmesaWindow>::New();
#endif
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  static_cast<vtkOpenGLRenderWindow*>(window.Get())->Initialize();
  return window;
}

std::string gl_description() {
  const auto window = make_window(8, 8);
  window->MakeCurrent();
  const auto text = [](GLenum what) { return reinterpret_cast<const char*>(glGetString(what)); };
  return fmt::format("{}, OpenGL {}, through OSMesa", text(GL_RENDERER), text(GL_VERSION));
}

std::string vtk_version() { return vtkVersion::GetVTKVersion(); }

}  // namespace seiche::render
