#include "network/state_schedule.h"

#include <algorithm>

namespace wells {
namespace {

// m/s by which the change of velocity in one step differs from that in the step before. In smooth
// flight it hardly differs; an impact shows.
constexpr double kJolt = 0.05;
constexpr double kRestingSpeed = 1e-3;  // m/s

// One part in so many of the limit is for the others, so that they are refreshed however many are
// jolted.
constexpr std::size_t kReservedShare = 4;

bool isMoving(const World& world, std::size_t ball) {
  return squaredLength(world.balls.velocity[ball]) > kRestingSpeed * kRestingSpeed;
}

}  // namespace

StateSchedule::StateSchedule(std::size_t balls) : balls_(balls) {
  due_.reserve(balls);
}

void StateSchedule::observe(const World& world) {
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    Ball& ball = balls_[i];
    const Vec3 change = world.balls.velocity[i] - ball.velocity;
    if (squaredLength(change - ball.change) > kJolt * kJolt) ball.isUrgent = true;
    ball.change = change;
    ball.velocity = world.balls.velocity[i];
  }
}

void StateSchedule::want(std::uint32_t ball, double time) {
  if (balls_[ball].sent < time) balls_[ball].isUrgent = true;
}

void StateSchedule::wantAll() {
  for (Ball& ball : balls_) ball.isUrgent = ball.isUrgent || ball.wasOwned;
}

std::vector<std::uint32_t> StateSchedule::pick(const World& world, const StatePace& pace,
                                               double now) {
  due_.clear();
  for (std::uint32_t i = 0; i < balls_.size(); ++i) {
    Ball& ball = balls_[i];
    const bool isOwned = world.owns(i);
    if (isOwned && !ball.wasOwned) ball.isUrgent = true;
    ball.wasOwned = isOwned;
    if (!isOwned) continue;
    const double interval = isMoving(world, i) ? pace.moving : pace.resting;
    if (ball.isUrgent || now - ball.sent >= interval) due_.push_back(i);
  }

  std::vector<std::uint32_t> chosen;
  if (due_.size() <= pace.limit) {
    chosen = due_;
  } else {
    std::ranges::stable_sort(due_, {}, [&](std::uint32_t i) { return balls_[i].sent; });
    const auto rest =
        std::ranges::stable_partition(due_, [&](std::uint32_t i) { return balls_[i].isUrgent; });
    const auto urgent = static_cast<std::size_t>(rest.begin() - due_.begin());
    const std::size_t others = due_.size() - urgent;
    const std::size_t reserved = std::min(others, pace.limit / kReservedShare);
    const std::size_t urgentTaken = std::min(urgent, pace.limit - reserved);
    const std::size_t othersTaken = std::min(others, pace.limit - urgentTaken);
    chosen.assign(due_.begin(), due_.begin() + static_cast<std::ptrdiff_t>(urgentTaken));
    chosen.insert(chosen.end(), rest.begin(),
                  rest.begin() + static_cast<std::ptrdiff_t>(othersTaken));
    std::ranges::sort(chosen);
  }
  for (const std::uint32_t i : chosen) {
    balls_[i].sent = now;
    balls_[i].isUrgent = false;
  }
  return chosen;
}

}  // namespace wells
