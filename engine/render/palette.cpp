#include "render/palette.h"

#include <array>
#include <cmath>

namespace wells {
namespace {

// Okabe and Ito's set (Color Universal Design, 2008), its black, which a dark ground would swallow,
// replaced by a pale lilac.
constexpr std::array<Color, 8> kFirst{{{230, 159, 0},
                                       {86, 180, 233},
                                       {0, 158, 115},
                                       {204, 121, 167},
                                       {240, 228, 66},
                                       {0, 114, 178},
                                       {213, 94, 0},
                                       {226, 214, 246}}};

constexpr Color kNobodys{180, 184, 190};

Color fromHue(double turns, double saturation, double value) {
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + turns * 6, 6);
    const double ramp = std::fmax(0, std::fmin(1, std::fmin(k, 4 - k)));
    return static_cast<std::uint8_t>(std::lround(255 * value * (1 - saturation * ramp)));
  };
  return {channel(5), channel(3), channel(1)};
}

}  // namespace

Color peerColor(std::int32_t peer) {
  if (peer <= 0) return kNobodys;
  if (peer <= std::int32_t(kFirst.size())) return kFirst[std::size_t(peer - 1)];
  // Steps of the golden ratio never come near an earlier hue before all the gaps are filled.
  const double turns = std::fmod(peer * 0.6180339887498949, 1.0);
  return fromHue(turns, peer % 2 == 0 ? 0.55 : 0.8, peer % 3 == 0 ? 0.75 : 0.95);
}

}  // namespace wells
