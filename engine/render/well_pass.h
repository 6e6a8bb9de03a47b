// Draws the wells: rings with arrows on the ground (inwards: attracts, outwards: repels, one faint
// ring: off), a glow at the well itself and a beam that stands out of a heap of balls.
#pragma once

#include "render/gl.h"
#include "render/view.h"

namespace wells {

class WellPass {
 public:
  WellPass();
  void set(const View& view);

  /// The rings, flat on the ground: after the shadows, before the balls.
  void drawMarks() const;
  /// Glow and beam: after the balls, which hide what is behind them.
  void drawBeams() const;

 private:
  void draw(GLuint program) const;

  GLuint markProgram_ = 0;
  GLuint beamProgram_ = 0;
  GLuint glowProgram_ = 0;
  GLuint vertexArray_ = 0;
  GLuint buffer_ = 0;
  GLsizei count_ = 0;
};

/// m; where the beam of a well ends and its label stands.
Vec3 beamTop(const Arena& arena, const ViewWell& well);

}  // namespace wells
