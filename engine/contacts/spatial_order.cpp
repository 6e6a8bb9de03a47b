#include "contacts/spatial_order.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace wells {
namespace {

constexpr double kColumnWidth = 4;  // radii of the greatest ball

/// The bits of a number below 2^16 with a zero between each.
std::uint32_t spread(std::uint32_t n) {
  n = (n | n << 8) & 0x00ff00ff;
  n = (n | n << 4) & 0x0f0f0f0f;
  n = (n | n << 2) & 0x33333333;
  return (n | n << 1) & 0x55555555;
}

}  // namespace

void SpatialOrder::sort(const Balls& balls, std::span<const std::uint32_t> ids) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double radius = 0;
  double lowX = kInfinity, lowZ = kInfinity, highX = -kInfinity, highZ = -kInfinity;
  for (const std::uint32_t i : ids) {
    const Vec3& at = balls.position[i];
    radius = std::max(radius, balls.radius[i]);
    lowX = std::min(lowX, at.x());
    highX = std::max(highX, at.x());
    lowZ = std::min(lowZ, at.z());
    highZ = std::max(highZ, at.z());
  }
  // About as many columns as balls at most, however far these are apart.
  const double extent = std::max(highX - lowX, highZ - lowZ);
  const double most = std::min(65535.0, std::sqrt(static_cast<double>(ids.size())));
  const double width = std::max(kColumnWidth * radius, extent / most);
  const auto placeOf = [&](double from, double at) {
    return static_cast<std::uint32_t>((at - from) / width);
  };
  const std::size_t side = std::bit_ceil(placeOf(0, extent) + 1);

  column_.resize(ids.size());
  sorted_.resize(ids.size());
  const std::size_t mostSides = std::bit_ceil(static_cast<std::size_t>(most) + 1);
  next_.reserve(mostSides * mostSides + 1);  // once for as many balls
  next_.assign(side * side + 1, 0);
  for (std::size_t n = 0; n < ids.size(); ++n) {
    const Vec3& at = balls.position[ids[n]];
    column_[n] = spread(placeOf(lowX, at.x())) | spread(placeOf(lowZ, at.z())) << 1;
    ++next_[column_[n] + 1];
  }
  for (std::size_t c = 1; c < next_.size(); ++c) next_[c] += next_[c - 1];
  for (std::size_t n = 0; n < ids.size(); ++n) sorted_[next_[column_[n]]++] = ids[n];
}

}  // namespace wells
