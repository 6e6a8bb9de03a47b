#include "render/context.h"

#include <stdexcept>
#include <string>

#include "render/gl.h"

#ifdef __SANITIZE_ADDRESS__
// Mesa keeps about 100 bytes of each context for good; that is not ours to report.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa.so";
}
#endif

namespace wells {

void Context::Destroy::operator()(osmesa_context* context) const {
  OSMesaDestroyContext(context);
}

Context::Context(int width, int height) : width_(width), height_(height) {
  constexpr int kLargest = 16384;  // llvmpipe's largest render target
  const std::string size = std::to_string(width) + " x " + std::to_string(height);
  if (width < 1 || height < 1 || width > kLargest || height > kLargest) {
    throw std::runtime_error("cannot draw pictures of " + size + " pixels; allowed is 1 .. " +
                             std::to_string(kLargest) + " each way");
  }
  rgba_.resize(std::size_t(width) * std::size_t(height) * 4);

  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  context_.reset(OSMesaCreateContextAttribs(attributes, nullptr));
  if (!context_) {
    throw std::runtime_error(
        "OSMesa cannot make an OpenGL 3.3 core context; is libosmesa6 22 or later installed, and "
        "does GALLIUM_DRIVER, if set, name llvmpipe?");
  }
  makeCurrent();
  OSMesaPixelStore(OSMESA_Y_UP, 0);
}

void Context::makeCurrent() {
  if (OSMesaGetCurrentContext() == context_.get()) return;
  if (OSMesaMakeCurrent(context_.get(), rgba_.data(), GL_UNSIGNED_BYTE, width_, height_) ==
      GL_FALSE) {
    throw std::runtime_error("OSMesa cannot draw into a picture of " + std::to_string(width_) +
                             " x " + std::to_string(height_) + " pixels");
  }
}

void Context::copyTo(Image& out) {
  glFinish();
  out.width = width_;
  out.height = height_;
  const std::size_t pixels = rgba_.size() / 4;
  out.rgb.resize(pixels * 3);
  const std::uint8_t* from = rgba_.data();
  std::uint8_t* to = out.rgb.data();
  for (std::size_t i = 0; i < pixels; ++i) {
    to[3 * i] = from[4 * i];
    to[3 * i + 1] = from[4 * i + 1];
    to[3 * i + 2] = from[4 * i + 2];
  }
}

}  // namespace wells
