#include "render/ball_pass.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "render/palette.h"
#include "render/program.h"

namespace wells {
namespace {

// The square stands at the sphere's centre across the line of sight, as large as the cone of sight
// that touches the sphere. On it, at offset q from the centre, with d the eye's distance, the ray
// passes the centre at d |q| / sqrt(d^2 + |q|^2). Written in q, nothing cancels, unlike in the
// usual quadratic with the eye as origin.
const char* const kBallVertex = R"(
layout(location = 0) in vec4 sphere;  // centre, radius
layout(location = 1) in vec3 tint;
layout(location = 2) in vec2 openness;  // to the sky, to the key light

flat out vec3 ball;  // radius, distance of the eye, width of a pixel there
flat out vec3 albedo;
flat out vec3 sideways, upwards, backwards;  // backwards: towards the eye
flat out vec3 seen;                          // height of the centre, openness
out vec2 offset;

void main() {
  vec3 toEye = eye.xyz - sphere.xyz;
  float distance = length(toEye);
  float pixel = eye.w * distance;
  float radius = max(sphere.w, 1.5 * pixel);  // far balls remain visible as dots
  backwards = toEye / distance;
  sideways = normalize(cross(up.xyz, backwards));
  upwards = cross(backwards, sideways);
  ball = vec3(radius, distance, pixel);
  albedo = toLinear(tint);
  seen = vec3(sphere.y, openness);

  float halfWidth = radius / sqrt(max(1.0 - radius * radius / (distance * distance), 0.01)) + pixel;
  offset = corner() * halfWidth;
  gl_Position = viewProjection * vec4(sphere.xyz + offset.x * sideways + offset.y * upwards, 1.0);
  if (distance <= radius) gl_Position = vec4(0.0, 0.0, 0.0, -1.0);  // the eye is inside: cut
}
)";

const char* const kBallFragment = R"(
flat in vec3 ball;
flat in vec3 albedo;
flat in vec3 sideways, upwards, backwards;
flat in vec3 seen;
in vec2 offset;
out vec4 color;

void main() {
  float radius = ball.x, distance = ball.y;
  float q2 = dot(offset, offset);
  float d2 = distance * distance;
  float along = d2 / (d2 + q2);  // foot of the perpendicular from the centre on the ray
  float passing2 = q2 * along;
  float cover = clamp((radius - sqrt(passing2)) / ball.z + 0.5, 0.0, 1.0);
  if (kEdges ? cover <= 0.0 || cover >= 1.0 : cover < 1.0) discard;

  float halfChord = sqrt(max(radius * radius - passing2, 0.0));
  float towardsEye = halfChord * inversesqrt(d2 + q2);
  vec2 hitAcross = offset * (along - towardsEye);
  float hitBack = distance * (q2 / (d2 + q2) + towardsEye);
  vec3 hit = hitAcross.x * sideways + hitAcross.y * upwards + hitBack * backwards;
  vec3 normal = hit / radius;
  vec3 toEye = normalize(backwards * distance - hit);

  float key = clamp(dot(normal, light.xyz), 0.0, 1.0) * seen.z;
  float skyward = 0.5 + 0.5 * normal.y;
  // The ground takes the light from what is close above it.
  float nearGround = (1.0 - skyward) / (1.0 + max(seen.x + hit.y, 0.0) / radius);
  vec3 ambient = mix(vec3(0.075, 0.075, 0.08), vec3(0.36, 0.40, 0.48), skyward * skyward);
  vec3 incoming = key * vec3(0.96, 0.93, 0.86) + (1.0 - 0.6 * nearGround) * seen.y * ambient;

  float aligned = clamp(dot(normal, normalize(light.xyz + toEye)), 0.0, 1.0);
  float shine = aligned * aligned;
  shine *= shine;
  shine *= shine;
  shine *= shine;
  shine *= shine * shine;  // the 48th power
  float edge = 1.0 - clamp(dot(normal, toEye), 0.0, 1.0);
  float white = 0.30 * shine * seen.z + 0.10 * edge * edge * edge * skyward * seen.y;
  color = vec4(toScreen(albedo * incoming + white), cover);
}
)";

// The shadow of a sphere in parallel light on a plane is an ellipse; the higher the ball, the
// softer and fainter, so that a ball's height shows.
const char* const kShadowVertex = R"(
layout(location = 0) in vec4 sphere;
flat out vec2 shape;  // width of the soft edge, darkness; in radii
out vec2 offset;      // in radii, across and along the light

void main() {
  float height = max(sphere.y, 0.0);
  float soft = 0.28 + 0.22 * height / sphere.w;
  shape = vec2(soft, 0.78 / (1.0 + 0.05 * height / sphere.w));
  vec2 along = normalize(light.xz);
  vec2 across = vec2(-along.y, along.x);
  offset = corner() * (1.0 + 0.5 * soft);
  vec2 at = sphere.xz - light.xz / light.y * height +
            sphere.w * (offset.x * across + offset.y / light.y * along);
  gl_Position = onGround(viewProjection * vec4(at.x, 0.0, at.y, 1.0));
}
)";

const char* const kShadowFragment = R"(
flat in vec2 shape;
in vec2 offset;
out vec4 color;

void main() {
  float edge = 0.5 * shape.x;
  float inside = 1.0 - smoothstep(1.0 - min(edge, 1.0), 1.0 + edge, length(offset));
  color = vec4(0.02, 0.03, 0.05, shape.y * inside);
}
)";

void checkSizes(const View& view) {
  const std::size_t count = view.position.size();
  const bool good = (view.radius.size() == count || view.radius.size() == 1 || count == 0) &&
                    (view.owner.size() == count || view.owner.empty());
  if (!good) {
    throw std::invalid_argument("a view of " + std::to_string(count) + " balls has " +
                                std::to_string(view.radius.size()) + " radii and " +
                                std::to_string(view.owner.size()) + " owners");
  }
}

}  // namespace

BallPass::BallPass()
    : insideProgram_(makeProgram("inside of a ball", kBallVertex,
                                 std::string("const bool kEdges = false;") + kBallFragment)),
      edgeProgram_(makeProgram("edge of a ball", kBallVertex,
                               std::string("const bool kEdges = true;") + kBallFragment)),
      shadowProgram_(makeProgram("shadow", kShadowVertex, kShadowFragment)) {
  glGenVertexArrays(1, &vertexArray_);
  glBindVertexArray(vertexArray_);
  glGenBuffers(1, &buffer_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Instance), nullptr);
  glVertexAttribPointer(1, 3, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Instance),
                        reinterpret_cast<const void*>(offsetof(Instance, red)));
  glVertexAttribPointer(2, 2, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Instance),
                        reinterpret_cast<const void*>(offsetof(Instance, sky)));
  for (const GLuint attribute : {0u, 1u, 2u}) {
    glEnableVertexAttribArray(attribute);
    glVertexAttribDivisor(attribute, 1);
  }
}

void BallPass::set(const View& view, const Camera& camera) {
  checkSizes(view);
  const std::size_t count = view.position.size();

  // The depth buffer does the hiding; nearest first, it also saves the shading of what is hidden.
  const Vec3 forward = cameraAxes(camera).forward;
  order_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    order_[i] = {static_cast<float>(dot(view.position[i] - camera.eye, forward)),
                 static_cast<std::uint32_t>(i)};
  }
  std::sort(order_.begin(), order_.end());
  findOpenness(view, kKeyLight, openness_);

  instances_.resize(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = order_[k].second;
    const Eigen::Vector3f at = (view.position[i] - view.arena.center).cast<float>();
    const double radius = view.radius.size() == 1 ? view.radius[0] : view.radius[i];
    const Color color = peerColor(view.owner.empty() ? 0 : view.owner[i]);
    instances_[k] = {at.x(),           at.y(),           at.z(),     static_cast<float>(radius),
                     color.red,        color.green,      color.blue, 0,
                     openness_[i].sky, openness_[i].key, {}};
  }
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * sizeof(Instance)),
               instances_.data(), GL_STREAM_DRAW);
}

void BallPass::draw(GLuint program) const {
  glUseProgram(program);
  glBindVertexArray(vertexArray_);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances_.size()));
}

void BallPass::drawInsides() const {
  draw(insideProgram_);
}
void BallPass::drawShadows() const {
  draw(shadowProgram_);
}
void BallPass::drawEdges() const {
  draw(edgeProgram_);
}

}  // namespace wells
