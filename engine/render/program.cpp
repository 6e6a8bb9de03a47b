#include "render/program.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace wells {
namespace {

constexpr GLuint kFrameBinding = 0;

const std::string kShared = R"(#version 330 core
layout(std140) uniform Frame {
  mat4 viewProjection;
  vec4 eye;      // w: width of a pixel at distance 1
  vec4 right;    // w: tangent of half the horizontal field of view
  vec4 up;       // w: tangent of half the vertical field of view
  vec4 forward;  // w: near distance
  vec4 light;    // towards the key light; w: the arena's radius
  vec4 arena;    // x: height of the rim
};

// A gamma of 2 is near enough to sRGB for a look, and a square root costs a tenth of a power.
vec3 toLinear(vec3 screen) { return screen * screen; }
vec3 toScreen(vec3 linear) { return sqrt(linear); }

// Screen colour of the sky in the direction `ray`.
vec3 skyColor(vec3 ray) {
  float height = clamp(normalize(ray).y * 1.6 + 0.1, 0.0, 1.0);
  return mix(vec3(0.150, 0.172, 0.208), vec3(0.070, 0.082, 0.110), height);
}
)";

const std::string kSharedByVertices = R"(
// Corner of a triangle strip over the square -1 .. 1.
vec2 corner() { return vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0; }

// Nothing is below the ground, so the ground and what lies on it go to the far end of depth: they
// show wherever no ball does, and never quarrel with one another.
vec4 onGround(vec4 clip) { return vec4(clip.xy, clip.w * 0.999999, clip.w); }
)";

/// std140: the layout of `Frame` above.
struct FrameData {
  float viewProjection[16];
  float eye[4], right[4], up[4], forward[4], light[4], arena[4];
};

void store(float (&to)[4], const Vec3& v, double w) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(v[i]);
  to[3] = static_cast<float>(w);
}

void compileInto(GLuint program, GLenum stage, const std::string& name, const std::string& source) {
  const char* text = source.c_str();
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good != GL_TRUE) {
    std::vector<char> log(4096);
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error("the graphics library refuses the shader '" + name +
                             "': " + log.data());
  }
  glAttachShader(program, shader);
  glDeleteShader(shader);
}

}  // namespace

GLuint makeProgram(const std::string& name, const std::string& vertex,
                   const std::string& fragment) {
  const GLuint program = glCreateProgram();
  compileInto(program, GL_VERTEX_SHADER, name, kShared + kSharedByVertices + vertex);
  compileInto(program, GL_FRAGMENT_SHADER, name, kShared + fragment);
  glLinkProgram(program);
  GLint good = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  if (good != GL_TRUE) {
    std::vector<char> log(4096);
    glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error("the graphics library cannot link the shader '" + name +
                             "': " + log.data());
  }
  const GLuint block = glGetUniformBlockIndex(program, "Frame");
  if (block != GL_INVALID_INDEX) glUniformBlockBinding(program, block, kFrameBinding);
  return program;
}

FrameUniforms::FrameUniforms() {
  glGenBuffers(1, &buffer_);
  glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBinding, buffer_);
}

void FrameUniforms::set(const Camera& camera, const Arena& arena, int width, int height) {
  const double aspect = static_cast<double>(width) / height;
  const double tangent = std::tan(camera.fieldOfView / 360 * std::numbers::pi);
  const CameraAxes axes = cameraAxes(camera);

  FrameData data{};
  Eigen::Map<Eigen::Matrix4f>(data.viewProjection) =
      viewProjection(camera, aspect, arena.center).cast<float>();
  store(data.eye, camera.eye - arena.center, 2 * tangent / height);
  store(data.right, axes.right, tangent * aspect);
  store(data.up, axes.up, tangent);
  store(data.forward, axes.forward, nearDistance(camera));
  store(data.light, kKeyLight, arena.radius);
  data.arena[0] = static_cast<float>(rimHeight(arena));

  glBindBuffer(GL_UNIFORM_BUFFER, buffer_);
  glBufferData(GL_UNIFORM_BUFFER, sizeof data, &data, GL_STREAM_DRAW);
}

}  // namespace wells
