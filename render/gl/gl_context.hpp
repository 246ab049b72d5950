#pragma once

// OSMesa behind plain types, so that its header never meets GLEW's.
namespace seiche::render::gl {

/// A context of OpenGL 3.2 (core) or later that draws in memory, without a display.
class Context {
 public:
  Context();  ///< throws NoGl when OSMesa can't give one
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  void make_current();
  bool is_current() const;

 private:
  void* context_;
  // VTK draws to frame buffer objects of its own; OSMesa asks for a default one all the same.
  static constexpr int side = 8;
  unsigned char buffer_[side * side * 4] = {};
};

}  // namespace seiche::render::gl
