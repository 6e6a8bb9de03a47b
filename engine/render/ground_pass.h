// Draws the sky and the ground with its grid over the whole picture, wherever no ball has
// been drawn.
#pragma once

#include "render/gl.h"

namespace wells {

class GroundPass {
 public:
  GroundPass();
  /// gridSpacing: m between the grid's fine lines; every fifth is a strong one.
  void draw(double gridSpacing) const;

 private:
  GLuint program_ = 0;
  GLuint vertexArray_ = 0;
  GLint gridSpacing_ = -1;
};

/// A round number of metres (1, 2 or 5 times a power of ten) for a grid under an arena of this
/// radius (m).
double gridSpacingFor(double arenaRadius);

}  // namespace wells
