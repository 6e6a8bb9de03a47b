// Draws frames of the world in memory: no window, no display. Knows nothing of files.
#pragma once

#include <memory>

#include "render/camera.h"
#include "render/image.h"
#include "render/view.h"

namespace wells {

class Renderer {
 public:
  /// Pictures of width x height pixels. Use a Renderer only in the thread that made it. Throws
  /// std::runtime_error when OSMesa or the font is missing, or the size is not possible.
  Renderer(int width, int height);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Throws std::invalid_argument when the arrays of `view` don't match in size.
  void draw(const View& view, const Camera& camera, Image& out);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace wells
