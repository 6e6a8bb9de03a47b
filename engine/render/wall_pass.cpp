#include "render/wall_pass.h"

#include "render/program.h"

namespace wells {
namespace {

constexpr int kSegments = 256;  // as in the shaders; the chords are within 1e-4 of the radius

const char* const kGlassVertex = R"(
const float kSegments = 256.0;
out float height;            // in rims
out float seenFromOutside;   // 0 or 1

void main() {
  float angle = radians(360.0) * float(gl_VertexID >> 1) / kSegments;
  vec2 outwards = vec2(cos(angle), sin(angle));
  height = float(gl_VertexID & 1);
  vec3 position = vec3(light.w * outwards.x, height * arena.x, light.w * outwards.y);
  seenFromOutside = step(0.0, dot(eye.xz - position.xz, outwards));
  gl_Position = viewProjection * vec4(position, 1.0);
}
)";

const char* const kGlassFragment = R"(
in float height;
in float seenFromOutside;
out vec4 color;

void main() {
  float glass = mix(mix(0.30, 0.14, height), mix(0.10, 0.04, height), seenFromOutside);
  color = vec4(0.62, 0.70, 0.80, glass);
}
)";

// The upper edge: a line of constant width on the screen, so that it is smooth all round.
const char* const kEdgeVertex = R"(
const float kSegments = 256.0;
out float across;  // pixels from the middle of the line

vec4 atAngle(float angle) {
  return viewProjection * vec4(light.w * cos(angle), arena.x, light.w * sin(angle), 1.0);
}

void main() {
  vec2 pixel = eye.w / vec2(right.w, up.w);  // of the picture's -1 .. 1
  float angle = radians(360.0) * float(gl_VertexID >> 1) / kSegments;
  vec4 here = atAngle(angle), next = atAngle(angle + 0.01);
  vec2 along = normalize((next.xy / next.w - here.xy / here.w) / pixel);
  across = (gl_VertexID & 1) == 0 ? -2.5 : 2.5;
  gl_Position = here + vec4(across * vec2(-along.y, along.x) * pixel * here.w, 0.0, 0.0);
}
)";

const char* const kEdgeFragment = R"(
in float across;
out vec4 color;
void main() { color = vec4(0.84, 0.88, 0.93, 0.75 * clamp(1.4 - abs(across), 0.0, 1.0)); }
)";

}  // namespace

WallPass::WallPass()
    : glassProgram_(makeProgram("wall", kGlassVertex, kGlassFragment)),
      edgeProgram_(makeProgram("edge of the wall", kEdgeVertex, kEdgeFragment)) {
  glGenVertexArrays(1, &vertexArray_);
}

void WallPass::draw() const {
  constexpr int kVertices = 2 * (kSegments + 1);
  glBindVertexArray(vertexArray_);
  glUseProgram(glassProgram_);
  // The far side first: the near one is seen through.
  glEnable(GL_CULL_FACE);
  for (const GLenum hidden : {GL_FRONT, GL_BACK}) {
    glCullFace(hidden);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, kVertices);
  }
  glDisable(GL_CULL_FACE);
  glUseProgram(edgeProgram_);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, kVertices);
}

}  // namespace wells
