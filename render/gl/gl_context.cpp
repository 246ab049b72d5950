#include "render/gl/gl_context.hpp"

#include <GL/osmesa.h>

#include "render/outputs.hpp"

// GLEW (built for GLX) looks functions up by this name; the program's own definition comes before libGLX's.
extern "C" __attribute__((visibility("default"))) void (*glXGetProcAddressARB(const unsigned char* name))(void) {
  return OSMesaGetProcAddress(reinterpret_cast<const char*>(name));
}

namespace seiche::render::gl {

Context::Context() {
  const int wanted[] = {OSMESA_FORMAT,
                        OSMESA_RGBA,
                        OSMESA_DEPTH_BITS,
                        24,
                        OSMESA_STENCIL_BITS,
                        8,
                        OSMESA_PROFILE,
                        OSMESA_CORE_PROFILE,
                        OSMESA_CONTEXT_MAJOR_VERSION,
                        3,
                        OSMESA_CONTEXT_MINOR_VERSION,
                        2,
                        0};
  context_ = OSMesaCreateContextAttribs(wanted, nullptr);
  if (!context_)
    throw NoGl("OSMesa gives no OpenGL 3.2 context; install Debian's packages libosmesa6 and libgl1-mesa-dri");
}

Context::~Context() { OSMesaDestroyContext(static_cast<OSMesaContext>(context_)); }

void Context::make_current() {
  if (!OSMesaMakeCurrent(static_cast<OSMesaContext>(context_), buffer_, GL_UNSIGNED_BYTE, side, side))
    throw NoGl("OSMesa can't make its OpenGL context current; install Debian's package libosmesa6 anew");
}

bool Context::is_current() const { return OSMesaGetCurrentContext() == context_; }

}  // namespace seiche::render::gl
