#include "render/renderer.h"

#include "render/ball_pass.h"
#include "render/context.h"
#include "render/font.h"
#include "render/ground_pass.h"
#include "render/overlay.h"
#include "render/program.h"
#include "render/wall_pass.h"
#include "render/well_pass.h"

namespace wells {

struct Renderer::Parts {
  Parts(int width, int height) : context(width, height), font(textSizeFor(height)) {}

  Context context;  // first: the passes need it
  FrameUniforms uniforms;
  GroundPass ground;
  WellPass wells;
  BallPass balls;
  WallPass wall;
  Font font;
};

Renderer::Renderer(int width, int height) : parts_(std::make_unique<Parts>(width, height)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::draw(const View& view, const Camera& camera, Image& out) {
  Parts& p = *parts_;
  p.context.makeCurrent();
  glViewport(0, 0, p.context.width(), p.context.height());
  p.uniforms.set(camera, view.arena, p.context.width(), p.context.height());
  p.balls.set(view, camera);
  p.wells.set(view);

  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  p.balls.drawInsides();

  // The rest hides nothing: it lies below the balls or is seen through.
  glDepthMask(GL_FALSE);
  p.ground.draw(gridSpacingFor(view.arena.radius));
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  p.balls.drawShadows();
  p.wells.drawMarks();
  p.balls.drawEdges();
  p.wall.draw();
  glBlendFunc(GL_SRC_ALPHA, GL_ONE);
  p.wells.drawBeams();

  p.context.copyTo(out);
  drawWellLabels(out, view, camera, p.font);
  drawLegend(out, view, p.font);
}

}  // namespace wells
