// An OpenGL core context that draws into memory: Mesa's software rasteriser, no display, no
// graphics card. OpenGL objects made while it is current die with it, so their makers don't delete
// them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "render/image.h"

struct osmesa_context;

namespace wells {

class Context {
 public:
  /// Makes it current in the calling thread, the only one that may use it. Throws
  /// std::runtime_error when Mesa cannot make such a context.
  Context(int width, int height);

  /// For a thread with several contexts.
  void makeCurrent();

  /// Waits until all is drawn and copies it; resizes `out` as needed.
  void copyTo(Image& out);

  int width() const { return width_; }
  int height() const { return height_; }

 private:
  struct Destroy {
    void operator()(osmesa_context* context) const;
  };

  int width_;
  int height_;
  std::vector<std::uint8_t> rgba_;  // what Mesa draws into; must outlive the context
  std::unique_ptr<osmesa_context, Destroy> context_;
};

}  // namespace wells
