#include "render/palette.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <set>
#include <tuple>

namespace wells {
namespace {

double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// CIE L*a*b* of linear sRGB, white point D65.
Eigen::Vector3d lab(const Eigen::Vector3d& rgb) {
  Eigen::Matrix3d toXyz;
  toXyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const Eigen::Vector3d xyz = toXyz * rgb;
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
  const double x = f(xyz[0] / 0.9505), y = f(xyz[1]), z = f(xyz[2] / 1.089);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// How dichromats see linear sRGB: Machado, Oliveira and Fernandes (2009), severity 1.
std::vector<Eigen::Matrix3d> visions() {
  std::vector<Eigen::Matrix3d> all(3);
  all[0].setIdentity();
  all[1] << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
      1.051998;  // protanopia
  all[2] << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
      0.968881;  // deuteranopia
  return all;
}

TEST(Palette, FirstEightDifferForDichromatsToo) {
  for (const Eigen::Matrix3d& vision : visions()) {
    for (int a = 0; a <= 8; ++a) {
      for (int b = a + 1; b <= 8; ++b) {
        const auto seen = [&](int peer) {
          const Color color = peerColor(peer);
          const Eigen::Vector3d rgb{linear(color.red), linear(color.green), linear(color.blue)};
          return lab((vision * rgb).cwiseMax(0).cwiseMin(1));
        };
        // 2.3 is just noticeable side by side; small balls need several times as much.
        EXPECT_GT((seen(a) - seen(b)).norm(), 10) << "peers " << a << " and " << b;
      }
    }
  }
}

TEST(Palette, AllPeersOfASessionDiffer) {
  std::set<std::tuple<int, int, int>> seen;
  for (int peer = 0; peer <= 64; ++peer) {
    const Color color = peerColor(peer);
    EXPECT_TRUE(seen.insert({color.red, color.green, color.blue}).second) << "peer " << peer;
  }
}

TEST(Palette, NobodyIsGrey) {
  EXPECT_EQ(peerColor(0), peerColor(-3));
  EXPECT_NEAR(peerColor(0).red, peerColor(0).blue, 16);
}

}  // namespace
}  // namespace wells
