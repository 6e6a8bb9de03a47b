#include "render/well_pass.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/palette.h"
#include "render/program.h"

namespace wells {
namespace {

struct Instance {
  float x, y, z;     // m, relative to the arena's centre
  float markRadius;  // m
  float top;         // m, of the beam
  float sign;        // of the strength: 1 attracts, -1 repels, 0 is off
  std::uint8_t red, green, blue, unused;
};

const char* const kInstance = R"(
layout(location = 0) in vec4 well;   // position, radius of the mark
layout(location = 1) in vec2 shape;  // top of the beam, sign
layout(location = 2) in vec3 tint;
flat out vec3 glow;
flat out float sign_;
)";

const char* const kMarkVertex = R"(
out vec2 at;  // in radii of the mark
void main() {
  glow = mix(tint, vec3(1.0), 0.15);
  sign_ = shape.y;
  at = corner() * 1.05;
  gl_Position = onGround(viewProjection * vec4(well.x + well.w * at.x, 0.0, well.z + well.w * at.y, 1.0));
}
)";

const char* const kMarkFragment = R"(
flat in vec3 glow;
flat in float sign_;
in vec2 at;
out vec4 color;

float ring(float from, float radius, float width, float pixel) {
  return clamp((0.5 * max(width, pixel) - abs(from - radius)) / pixel + 0.5, 0.0, 1.0);
}

void main() {
  float from = length(at);
  float pixel = max(fwidth(at.x), fwidth(at.y));
  float alpha = ring(from, 0.98, 0.02, pixel) * (sign_ == 0.0 ? 0.5 : 0.8);
  if (sign_ != 0.0) {
    alpha = max(alpha, ring(from, 0.5, 0.02, pixel) * 0.8);
    // Eight arrow heads between the rings.
    float turn = radians(45.0);
    float sideways = abs(mod(atan(at.y, at.x) + 0.5 * turn, turn) - 0.5 * turn) * from;
    float fromTip = sign_ > 0.0 ? from - 0.64 : 0.84 - from;
    float arrow = min(0.6 * fromTip - sideways, 0.20 - fromTip);
    alpha = max(alpha, clamp(arrow / pixel + 0.5, 0.0, 1.0) * 0.85);
    // What attracts is bright in the middle, what repels is bright at the edge.
    float fill = sign_ > 0.0 ? exp(-5.0 * from * from) : 0.7 * from * from * from;
    alpha = max(alpha, 0.6 * fill * clamp((0.98 - from) / pixel + 0.5, 0.0, 1.0));
  }
  color = vec4(glow, alpha);
}
)";

const char* const kBeamVertex = R"(
out vec2 at;
out float height;
void main() {
  glow = mix(tint, vec3(1.0), 0.25);
  sign_ = shape.y;
  vec2 c = corner();
  vec3 base = vec3(well.x, 0.0, well.z);
  vec3 position = base + vec3(0.0, shape.x * (0.5 + 0.5 * c.y), 0.0);
  float width = max(0.011 * light.w, 3.5 * eye.w * length(eye.xyz - base));
  vec3 across = normalize(cross(vec3(0.0, 1.0, 0.0), eye.xyz - base));
  at = vec2(c.x, 0.5 + 0.5 * c.y);
  height = position.y / light.w;
  if (sign_ == 0.0) position = base;
  gl_Position = viewProjection * vec4(position + across * width * c.x, 1.0);
}
)";

const char* const kBeamFragment = R"(
flat in vec3 glow;
flat in float sign_;
in vec2 at;
in float height;
out vec4 color;
void main() {
  float core = exp(-14.0 * at.x * at.x) * 0.9 + exp(-3.5 * at.x * at.x) * 0.35;
  // Dashes for what repels.
  float dash = sign_ > 0.0 ? 1.0 : smoothstep(0.25, 0.35, abs(fract(height * 32.0) - 0.5) * 1.4);
  color = vec4(glow, core * (1.0 - at.x * at.x) * dash * (0.95 - 0.55 * at.y));
}
)";

const char* const kGlowVertex = R"(
out vec2 at;
void main() {
  glow = mix(tint, vec3(1.0), 0.35);
  sign_ = shape.y;
  at = corner();
  float radius = sign_ == 0.0 ? 0.0 : max(0.055 * light.w, 10.0 * eye.w * length(eye.xyz - well.xyz));
  gl_Position = viewProjection * vec4(well.xyz + radius * (at.x * right.xyz + at.y * up.xyz), 1.0);
}
)";

const char* const kGlowFragment = R"(
flat in vec3 glow;
in vec2 at;
out vec4 color;
void main() {
  float from2 = dot(at, at);
  color = vec4(glow, max(0.0, exp(-4.5 * from2) - 0.0112) * 0.55 + exp(-60.0 * from2) * 0.6);
}
)";

}  // namespace

WellPass::WellPass()
    : markProgram_(makeProgram("well's mark", std::string(kInstance) + kMarkVertex, kMarkFragment)),
      beamProgram_(makeProgram("well's beam", std::string(kInstance) + kBeamVertex, kBeamFragment)),
      glowProgram_(
          makeProgram("well's glow", std::string(kInstance) + kGlowVertex, kGlowFragment)) {
  glGenVertexArrays(1, &vertexArray_);
  glBindVertexArray(vertexArray_);
  glGenBuffers(1, &buffer_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  const auto at = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Instance), at(offsetof(Instance, x)));
  glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(Instance), at(offsetof(Instance, top)));
  glVertexAttribPointer(2, 3, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Instance),
                        at(offsetof(Instance, red)));
  for (const GLuint attribute : {0u, 1u, 2u}) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribDivisor(attribute, 1);
  }
}

Vec3 beamTop(const Arena& arena, const ViewWell& well) {
  const double usual = arena.center.y() + 0.2 * arena.radius;
  const double above = well.position.y() + 0.05 * arena.radius;
  return {well.position.x(), std::max(usual, above), well.position.z()};
}

void WellPass::set(const View& view) {
  std::vector<Instance> instances;
  for (const ViewWell& well : view.wells) {
    const Eigen::Vector3f at = (well.position - view.arena.center).cast<float>();
    const Color color = peerColor(well.peer);
    const double markRadius =
        std::clamp(3 * well.softening, 0.10 * view.arena.radius, 0.3 * view.arena.radius);
    const double top = beamTop(view.arena, well).y() - view.arena.center.y();
    const float sign = well.strength > 0 ? 1.f : well.strength < 0 ? -1.f : 0.f;
    instances.push_back({at.x(), at.y(), at.z(), static_cast<float>(markRadius),
                         static_cast<float>(top), sign, color.red, color.green, color.blue, 0});
  }
  count_ = static_cast<GLsizei>(instances.size());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)),
               instances.data(), GL_STREAM_DRAW);
}

void WellPass::draw(GLuint program) const {
  glUseProgram(program);
  glBindVertexArray(vertexArray_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

void WellPass::drawMarks() const {
  draw(markProgram_);
}

void WellPass::drawBeams() const {
  draw(beamProgram_);
  draw(glowProgram_);
}

}  // namespace wells
