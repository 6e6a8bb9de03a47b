#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "flight/fly_through.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <array>
#include <bit>

#include "flight/fly_each-inl.h"
#include "math/components.h"

HWY_BEFORE_NAMESPACE();
namespace wells::HWY_NAMESPACE {

void flyParabolas(const double* gain, double h, const FlightArrays& balls) {
  flyEach(balls, [&]<class D>(WideVector<D>& x, WideVector<D>& v) HWY_ATTR {
    const WideVector<D> whole = wide(D(), gain[0], gain[1], gain[2]);
    x += (v + 0.5 * whole) * h;
    v += whole;
  });
}

}  // namespace wells::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wells {
namespace {

HWY_EXPORT(flyParabolas);

void flyStretches(const Integrator& integrator, const Flight& flight, const FlightArrays& balls) {
  const double stretch = flight.field->stretch;
  Flight part = flight;
  double left = flight.duration;
  while (left > stretch * (1 + kNoRemainder)) {
    part.duration = stretch;
    integrator.fly(part, balls);
    part.start += stretch;
    left -= stretch;
  }
  part.duration = left;
  integrator.fly(part, balls);
}

/// Balls in a row, copied from where they are and back: some that fit the cache.
class Block {
 public:
  static constexpr std::size_t kSize = 64;

  /// The last few fly with as many made-up ones as make a vector: that costs less than several
  /// shorter vectors.
  static std::size_t room(std::size_t balls) {
    const std::size_t rest = balls % kMostLanes;
    return balls - rest + (rest == 0 ? 0 : std::bit_ceil(rest));
  }

  FlightArrays take(std::span<const std::uint32_t> balls, const Vec3* position,
                    const Vec3* velocity) {
    toComponents(balls, position, x_.data(), y_.data(), z_.data());
    toComponents(balls, velocity, vx_.data(), vy_.data(), vz_.data());
    for (Component* const of : {&x_, &y_, &z_, &vx_, &vy_, &vz_})
      std::fill(of->begin() + balls.size(), of->begin() + room(balls.size()), 0.0);
    return {x_.data(),  y_.data(),  z_.data(),         vx_.data(),
            vy_.data(), vz_.data(), room(balls.size())};
  }

  void giveBack(std::span<const std::uint32_t> balls, Vec3* position, Vec3* velocity) const {
    fromComponents(balls, x_.data(), y_.data(), z_.data(), position);
    fromComponents(balls, vx_.data(), vy_.data(), vz_.data(), velocity);
  }

 private:
  static constexpr std::size_t kMostLanes = 8;
  using Component = std::array<double, kSize>;
  Component x_, y_, z_;     // m
  Component vx_, vy_, vz_;  // m/s
};

}  // namespace

void flyThrough(const Integrator& integrator, const Flight& flight, const FlightArrays& balls) {
  if (isParabola(*flight.field, flight.drag)) {
    const Vec3 gain = flight.field->gravity * flight.duration;
    HWY_DYNAMIC_DISPATCH(flyParabolas)(gain.data(), flight.duration, balls);
    return;
  }
  flyStretches(integrator, flight, balls);
}

void flyThrough(const Integrator& integrator, const Flight& flight,
                std::span<const std::uint32_t> balls, Vec3* position, Vec3* velocity) {
  if (isParabola(*flight.field, flight.drag)) {
    // So short that copying would cost more than vectors save.
    const double h = flight.duration;
    const Vec3 gain = flight.field->gravity * h;
    for (const std::uint32_t i : balls) {
      position[i] += (velocity[i] + 0.5 * gain) * h;
      velocity[i] += gain;
    }
    return;
  }
  if (balls.size() == 1) {
    double* const x = position[balls[0]].data();
    double* const v = velocity[balls[0]].data();
    flyStretches(integrator, flight, {x, x + 1, x + 2, v, v + 1, v + 2, 1});
    return;
  }
  Block block;
  for (std::size_t first = 0; first < balls.size(); first += Block::kSize) {
    const auto some = balls.subspan(first, std::min(Block::kSize, balls.size() - first));
    flyStretches(integrator, flight, block.take(some, position, velocity));
    block.giveBack(some, position, velocity);
  }
}

}  // namespace wells
#endif
