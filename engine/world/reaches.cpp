#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "world/reaches.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <array>

#include "forces/wide_acceleration-inl.h"
#include "math/components.h"
#include "world/advance.h"
#include "world/reaches.h"

#ifndef WELLS_WORLD_REACHES_CPP_
#define WELLS_WORLD_REACHES_CPP_
namespace wells {

/// Balls in a row, some that fit the cache.
struct ReachBlock {
  static constexpr std::size_t kSize = 64;
  using Component = std::array<double, kSize>;

  std::array<Component, 3> position;  // m
  std::array<Component, 3> velocity;  // m/s
  std::array<Component, 3> spin;      // rad/s
  Component radius;                   // m
  Component reach;                    // m
};

}  // namespace wells
#endif

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

void fillReaches(const Field& field, double dt, std::size_t count, ReachBlock& block) {
  const auto vectorAt = [](auto d, const auto& of, std::size_t i) HWY_ATTR {
    return load(d, of[0].data() + i, of[1].data() + i, of[2].data() + i);
  };
  forEachVector(count, [&](auto d, std::size_t i) HWY_ATTR {
    const auto x = vectorAt(d, block.position, i);
    const auto v = vectorAt(d, block.velocity, i);
    const auto pull = length(acceleration(field, x, 0)) * hn::Set(d, dt);
    const auto margin = hn::Set(d, kReachMargin) * hn::LoadU(d, block.radius.data() + i);
    const auto reach = (length(v) + pull) * hn::Set(d, dt) + margin;
    // 0 where all is finite, else NaN.
    const auto sum = x * 0.0 + v * 0.0 + vectorAt(d, block.spin, i) * 0.0;
    hn::StoreU(reach + (sum.x + sum.y + sum.z), d, block.reach.data() + i);
  });
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {
namespace {

HWY_EXPORT(fillReaches);

}  // namespace

void reachesOf(const Field& field, const Balls& balls, std::span<const std::uint32_t> among,
               double dt, std::span<double> reach) {
  ReachBlock block;
  for (std::size_t first = 0; first < among.size(); first += ReachBlock::kSize) {
    const auto some = among.subspan(first, std::min(ReachBlock::kSize, among.size() - first));
    const auto take = [&](const std::vector<Vec3>& vectors, auto& to) {
      toComponents(some, vectors.data(), to[0].data(), to[1].data(), to[2].data());
    };
    take(balls.position, block.position);
    take(balls.velocity, block.velocity);
    take(balls.spin, block.spin);
    for (std::size_t k = 0; k < some.size(); ++k) block.radius[k] = balls.radius[some[k]];
    HWY_DYNAMIC_DISPATCH(fillReaches)(field, dt, some.size(), block);
    for (std::size_t k = 0; k < some.size(); ++k) reach[some[k]] = block.reach[k];
  }
}

}  // namespace wells
#endif
