#include "render/ground_pass.h"

#include <cmath>

#include "render/program.h"

namespace wells {
namespace {

const char* const kVertex = R"(
out vec3 ray;
void main() {
  vec2 position = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0;  // one big triangle
  ray = forward.xyz + position.x * right.w * right.xyz + position.y * up.w * up.xyz;
  gl_Position = onGround(vec4(position, 0.0, 1.0));
}
)";

const char* const kFragment = R"(
uniform float gridSpacing;
in vec3 ray;
out vec4 color;

// How much of the pixel a line of the grid covers. Lines are never thinner than a pixel; where they
// come closer than a few pixels they fade into their mean instead of making moire patterns.
float grid(vec2 at, float spacing, float width) {
  vec2 scaled = at / spacing;
  vec2 pixel = fwidth(scaled);
  vec2 drawn = max(vec2(width / spacing), pixel);
  vec2 toLine = abs(fract(scaled - 0.5) - 0.5);
  vec2 cover = clamp((0.5 * drawn - toLine) / pixel + 0.5, 0.0, 1.0) *
               clamp(width / spacing / pixel + 0.35, 0.0, 1.0);
  cover = mix(cover, vec2(width / spacing), smoothstep(0.12, 0.35, pixel));
  return max(cover.x, cover.y);
}

void main() {
  float t = -eye.y / ray.y;
  vec2 at = eye.xz + t * ray.xz;
  float distance = length(at);
  float radius = light.w;
  float pixel = fwidth(distance);
  vec3 sky = skyColor(ray);
  if (ray.y >= 0.0 || eye.y <= 0.0) {
    color = vec4(sky, 1.0);
    return;
  }

  float inside = clamp((radius - distance) / pixel + 0.5, 0.0, 1.0);
  // The key light falls a little more on the side that it comes from.
  float lit = 1.0 + 0.16 * dot(at / radius, normalize(light.xz)) * inside;
  vec3 floorColor = vec3(0.305, 0.335, 0.385) * lit * (1.05 - 0.16 * distance * distance / (radius * radius));
  vec3 outside = vec3(0.165, 0.187, 0.225);
  // The rim's soft shade on the ground outside.
  outside *= 1.0 - 0.35 * exp(-max(distance - radius, 0.0) / (0.06 * radius));
  vec3 ground = mix(outside, floorColor, inside);

  float lines = max(0.45 * grid(at, gridSpacing, 0.012 * gridSpacing),
                    grid(at, 5.0 * gridSpacing, 0.022 * gridSpacing));
  ground = mix(ground, mix(vec3(0.25, 0.28, 0.33), vec3(0.47, 0.51, 0.57), inside), 0.6 * lines);

  // The foot of the wall.
  float foot = clamp(1.2 - abs(distance - radius) / pixel, 0.0, 1.0);
  ground = mix(ground, vec3(0.70, 0.76, 0.84), 0.45 * foot);

  float haze = smoothstep(1.3 * radius, 4.5 * radius, distance);
  color = vec4(mix(ground, sky, haze), 1.0);
}
)";

}  // namespace

GroundPass::GroundPass() : program_(makeProgram("ground", kVertex, kFragment)) {
  gridSpacing_ = glGetUniformLocation(program_, "gridSpacing");
  glGenVertexArrays(1, &vertexArray_);
}

void GroundPass::draw(double gridSpacing) const {
  glUseProgram(program_);
  glUniform1f(gridSpacing_, static_cast<float>(gridSpacing));
  glBindVertexArray(vertexArray_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

double gridSpacingFor(double arenaRadius) {
  const double wanted = arenaRadius / 16;
  const double power = std::pow(10, std::floor(std::log10(wanted)));
  const double leading = wanted / power;
  return power * (leading < 2 ? 1 : leading < 5 ? 2 : 5);
}

}  // namespace wells
