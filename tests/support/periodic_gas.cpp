#include "support/periodic_gas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "contacts/impact_time.h"
#include "contacts/impacts.h"
#include "math/random.h"

namespace wells {
namespace {

/// Every second site (x + y + z even) of a cubic lattice.
std::vector<Vec3> closePackedSites(int perSide, double spacing) {
  std::vector<Vec3> sites;
  for (int x = 0; x < perSide; ++x)
    for (int y = 0; y < perSide; ++y)
      for (int z = 0; z < perSide; ++z)
        if ((x + y + z) % 2 == 0) sites.push_back(spacing * Vec3(x + 0.5, y + 0.5, z + 0.5));
  return sites;
}

}  // namespace

PeriodicGas::PeriodicGas(std::size_t balls, double density, std::uint64_t seed) {
  model_ = {.field = &field_, .integrator = &findIntegrator("pefrl"), .arena = &arena_};
  placeBalls(balls, density, seed);
  heatBalls(seed);
  for (std::uint32_t i = 0; i < balls_.size(); ++i) foresee(i);
}

void PeriodicGas::placeBalls(std::size_t balls, double density, std::uint64_t seed) {
  side_ = std::cbrt(static_cast<double>(balls) / density);
  // Neighbours are sqrt(2) lattice spacings apart; an even number of them fits the box's images.
  int perSide = 2;
  while (perSide * perSide * perSide / 2 < static_cast<int>(balls)) perSide += 2;
  const double spacing = side_ / perSide;
  if (spacing * std::numbers::sqrt2 < 1) throw std::invalid_argument("the gas is too dense");
  std::vector<Vec3> sites = closePackedSites(perSide, spacing);
  Random random(seed);
  for (std::size_t i = 0; i < balls; ++i) {
    std::swap(sites[i], sites[i + random.below(sites.size() - i)]);
    balls_.add({.position = sites[i]}, 0.5, 1);
  }

  // Cells of about one ball.
  cellsPerSide_ = static_cast<int>(side_ / std::max(1.0, std::cbrt(1 / density)));
  if (cellsPerSide_ < 3) throw std::invalid_argument("the box is too small for its images");
  cellSide_ = side_ / cellsPerSide_;
  members_.resize(cellsPerSide_ * cellsPerSide_ * cellsPerSide_);
  for (std::uint32_t i = 0; i < balls; ++i) {
    Triple cell;
    for (int k = 0; k < 3; ++k) cell[k] = static_cast<int>(balls_.position[i][k] / cellSide_);
    cells_.push_back(cell);
    members(cell).push_back(i);
  }
  since_.assign(balls, 0);
  paths_.assign(balls, 0);
  turns_.assign(balls, 0);
}

void PeriodicGas::heatBalls(std::uint64_t seed) {
  Random random(~seed);
  Vec3 mean = Vec3::Zero();
  for (Vec3& v : balls_.velocity) {
    v = random.direction();
    mean += v / static_cast<double>(balls_.size());
  }
  for (Vec3& v : balls_.velocity) v -= mean;
  const double slower = 1 / std::sqrt(temperature());
  for (Vec3& v : balls_.velocity) v *= slower;
}

double PeriodicGas::temperature() const {
  double sum = 0;
  for (const Vec3& v : balls_.velocity) sum += squaredLength(v);
  return sum / 3 / static_cast<double>(balls_.size() - 1);
}

Vec3 PeriodicGas::positionOf(std::uint32_t ball) const {
  Vec3 x = stateAt(model_, pathOf(ball), now_).position;
  for (int k = 0; k < 3; ++k) x[k] -= side_ * std::floor(x[k] / side_);
  return x;
}

std::vector<std::uint32_t>& PeriodicGas::members(const Triple& cell) {
  const auto inBox = [&](int k) { return (k % cellsPerSide_ + cellsPerSide_) % cellsPerSide_; };
  const int index =
      (inBox(cell[0]) * cellsPerSide_ + inBox(cell[1])) * cellsPerSide_ + inBox(cell[2]);
  return members_[index];
}

PeriodicGas::Triple PeriodicGas::imageIn(const Triple& cell, std::uint32_t ball) const {
  Triple image;
  for (int k = 0; k < 3; ++k) image[k] = (cell[k] - cells_[ball][k]) / cellsPerSide_;
  return image;
}

Vec3 PeriodicGas::shiftOf(const Triple& image) const {
  return side_ * Vec3(image[0], image[1], image[2]);
}

Path PeriodicGas::pathOf(std::uint32_t ball) const {
  return {balls_.state(ball), since_[ball], balls_.radius[ball], Motion::Flying};
}

PeriodicGas::Exit PeriodicGas::exitOf(std::uint32_t ball) const {
  const BallState now = stateAt(model_, pathOf(ball), now_);
  Exit first{.time = std::numeric_limits<double>::infinity()};
  for (int k = 0; k < 3; ++k) {
    const double v = now.velocity[k];
    if (v == 0) continue;
    const double border = cellSide_ * (cells_[ball][k] + (v > 0 ? 1 : 0));
    const double time = now_ + std::max(0.0, (border - now.position[k]) / v);
    if (time < first.time) first = {time, k};
  }
  return first;
}

void PeriodicGas::foresee(std::uint32_t ball) {
  const Path path = pathOf(ball);
  Event next{.time = exitOf(ball).time, .ball = ball};
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const Triple& home = cells_[ball];
        const Triple cell{home[0] + x, home[1] + y, home[2] + z};
        for (const std::uint32_t other : members(cell)) {
          if (other == ball) continue;
          const Triple image = imageIn(cell, other);
          Path seen = pathOf(other);
          seen.state.position += shiftOf(image);
          const Encounter encounter = encounterOfBalls(model_, path, seen, now_, next.time);
          if (encounter.meeting == Meeting::Sustained)
            throw std::logic_error("balls in free flight do not stay together");
          if (encounter.meeting == Meeting::Impact && encounter.time < next.time)
            next = {.time = encounter.time,
                    .ball = ball,
                    .partner = other,
                    .path = paths_[other],
                    .image = image};
        }
      }
  next.turn = ++turns_[ball];
  queue_.push(next);
}

void PeriodicGas::cross(std::uint32_t ball) {
  Triple& cell = cells_[ball];
  std::erase(members(cell), ball);
  const int axis = exitOf(ball).axis;
  cell[axis] += balls_.velocity[ball][axis] > 0 ? 1 : -1;
  members(cell).push_back(ball);
}

void PeriodicGas::hit(const Event& event) {
  const std::uint32_t a = event.ball, b = event.partner;
  for (const std::uint32_t i : {a, b}) {
    balls_.setState(i, stateAt(model_, pathOf(i), now_));
    since_[i] = now_;
    ++paths_[i];
  }
  // b goes on as that image of itself which was hit.
  balls_.position[b] += shiftOf(event.image);
  for (int k = 0; k < 3; ++k) cells_[b][k] += cellsPerSide_ * event.image[k];

  Contact contact{.a = a, .b = b};
  touchBalls(balls_, contact);
  const Vec3 before = balls_.velocity[a];
  resolveImpacts(elasticity_, 0, {&contact, 1}, balls_);
  const Vec3 impulse = balls_.mass[a] * (balls_.velocity[a] - before);
  virial_ += dot(balls_.position[a] - balls_.position[b], impulse);
  ++hits_;
  foresee(a);
  foresee(b);
}

void PeriodicGas::happen(const Event& event) {
  if (event.turn != turns_[event.ball]) return;
  now_ = event.time;
  if (event.partner == kNobody) {
    cross(event.ball);
    foresee(event.ball);
  } else if (event.path == paths_[event.partner]) {
    hit(event);
  } else {
    foresee(event.ball);  // the partner was hit meanwhile
  }
}

void PeriodicGas::runToHits(std::int64_t hits) {
  while (hits_ < hits) {
    const Event event = queue_.top();
    queue_.pop();
    happen(event);
  }
}

void PeriodicGas::runToTime(double time) {
  while (queue_.top().time <= time) {
    const Event event = queue_.top();
    queue_.pop();
    happen(event);
  }
  now_ = time;
}

}  // namespace wells
