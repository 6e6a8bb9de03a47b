#include "contacts/spatial_order.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wells {
namespace {

constexpr double kColumnWidth = 4;  // radii of the greatest ball

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
  // Not more columns than balls, however far these are apart.
  const double most = std::max(1.0, std::sqrt(static_cast<double>(ids.size())));
  const double width =
      std::max({kColumnWidth * radius, (highX - lowX) / most, (highZ - lowZ) / most});
  const auto placeOf = [&](double from, double at) {
    return static_cast<std::uint32_t>((at - from) / width);
  };
  const std::uint32_t columns = placeOf(lowX, highX) + 1;
  const std::uint32_t rows = placeOf(lowZ, highZ) + 1;

  column_.resize(ids.size());
  sorted_.resize(ids.size());
  next_.assign(std::size_t{columns} * rows + 1, 0);
  for (std::size_t n = 0; n < ids.size(); ++n) {
    const Vec3& at = balls.position[ids[n]];
    column_[n] = placeOf(lowZ, at.z()) * columns + placeOf(lowX, at.x());
    ++next_[column_[n] + 1];
  }
  for (std::size_t c = 1; c < next_.size(); ++c) next_[c] += next_[c - 1];
  for (std::size_t n = 0; n < ids.size(); ++n) sorted_[next_[column_[n]]++] = ids[n];
}

}  // namespace wells
