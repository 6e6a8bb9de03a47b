// Shader programs, and what all of them share: the frame's camera and light, and the functions that
// turn light into screen colours.
//
// Lengths in shaders are metres relative to the arena's centre, y up, so that single precision does
// for an arena anywhere.
#pragma once

#include <string>

#include "render/camera.h"
#include "render/gl.h"
#include "state/arena.h"

namespace wells {

/// Towards the key light: from the upper left of a camera that looks along -z.
inline const Vec3 kKeyLight = Vec3{-0.52, 1.0, 0.30}.normalized();

/// Compiles and links; both sources come after the shared part. Throws std::runtime_error with
/// `name` and the compiler's message.
GLuint makeProgram(const std::string& name, const std::string& vertex, const std::string& fragment);

/// The camera and the light of a frame, in the graphics library's memory, seen by every program.
class FrameUniforms {
 public:
  FrameUniforms();
  void set(const Camera& camera, const Arena& arena, int width, int height);

 private:
  GLuint buffer_ = 0;
};

}  // namespace wells
