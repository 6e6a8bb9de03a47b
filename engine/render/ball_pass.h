// Draws the balls and their shadows on the ground. A ball is one square that faces the eye; each of
// its pixels meets the sphere exactly, so that a ball is round at any size and costs four vertices.
// (Meshes of 80 triangles a ball took 7 times as long at 10,000 balls.)
//
// The square's own depth stands for the sphere's. Of two spheres that don't overlap, the one whose
// chord on a line of sight has the nearer middle hides the other, and the square lies within
// radius^2 / distance of that middle. Writing each pixel's exact depth instead would keep the
// rasteriser from skipping hidden pixels before it shades them: four times as long for a heap
// seen from near.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "render/camera.h"
#include "render/gl.h"
#include "render/openness.h"
#include "render/view.h"

namespace wells {

class BallPass {
 public:
  BallPass();

  /// Takes over the balls of `view`. Throws std::invalid_argument when its arrays don't match.
  void set(const View& view, const Camera& camera);

  /// All of each ball but the pixels that it covers in part; writes depth.
  void drawInsides() const;
  /// On the ground, where no ball is before it.
  void drawShadows() const;
  /// The pixels covered in part, mixed with what is behind them: after all that is opaque.
  void drawEdges() const;

 private:
  struct Instance {
    float x, y, z, radius;  // m, relative to the arena's centre
    std::uint8_t red, green, blue, unused;
    std::uint8_t sky, key, unusedToo[2];  // see Openness
  };

  void draw(GLuint program) const;

  GLuint insideProgram_ = 0;
  GLuint edgeProgram_ = 0;
  GLuint shadowProgram_ = 0;
  GLuint vertexArray_ = 0;
  GLuint buffer_ = 0;
  std::vector<Instance> instances_;                     // nearest first
  std::vector<std::pair<float, std::uint32_t>> order_;  // depth along the axis of view, ball
  std::vector<Openness> openness_;
};

}  // namespace wells
