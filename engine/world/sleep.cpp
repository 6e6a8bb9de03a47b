#include "world/sleep.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/hash.h"
#include "math/straight_path.h"
#include "math/union_find.h"
#include "world/advance.h"
#include "world/measures.h"

namespace wells {
namespace {

/// Of all that holds for every ball alike and may be changed between two steps.
std::uint64_t conditionsOf(const World& world) {
  const auto& [dt, gravity, drag, elasticity, friction, rollingResistance, integrator,
               contactMethod, substeps, iterations, mostImpacts, sleepSpeed, broadphase] =
      world.settings;
  static_cast<void>(broadphase);  // changes no result
  Hash hash;
  for (const double number : {dt, drag, elasticity, friction, rollingResistance, sleepSpeed})
    hash.add(number);
  hash.add(gravity);
  hash.add(integrator);
  hash.add(static_cast<std::uint64_t>(contactMethod));
  for (const std::int64_t number : {std::int64_t{substeps}, std::int64_t{iterations}, mostImpacts})
    hash.add(static_cast<std::uint64_t>(number));
  hash.add(world.arena.center);
  hash.add(world.arena.radius);
  hash.add(std::uint64_t{world.roles.empty()});
  return hash.value();
}

bool areSame(const FieldWells& x, const FieldWells& y) {
  return std::ranges::equal(x, y, [](const Well& a, const Well& b) {
    return a.position == b.position && a.velocity == b.velocity && a.strength == b.strength &&
           a.softening == b.softening;
  });
}

double speedOf(const Balls& balls, std::size_t i) {
  return length(balls.velocity[i]) + balls.radius[i] * length(balls.spin[i]);
}

/// Steps for which an island must have rested.
std::uint32_t restSteps(double dt) {
  return static_cast<std::uint32_t>(std::max(2.0, std::ceil(kRestTime / dt)));
}

}  // namespace

void Sleep::begin(World& world, const Field& field, ContactMemory& memory) {
  const std::uint64_t conditions = conditionsOf(world);
  woken_.clear();
  if (conditions != conditions_ || group_.size() != world.balls.size() ||
      (nextStep_ && *nextStep_ != world.step)) {
    wakeAll(world, memory);
  } else {
    if (needsBoxes_)
      for (const auto& [lowest, group] : groups_)
        for (const std::uint32_t i : group.balls)
          boxes_.add(i, world.balls.position[i], (1 + kLeaningGap) * world.balls.radius[i]);
    wakeChanged(world);
    wakePulled(world, field);
    finishWaking(memory);
  }
  needsBoxes_ = false;
  conditions_ = conditions;
  world.changed.clear();
}

void Sleep::wakeAll(const World& world, ContactMemory& memory) {
  for (const auto& [lowest, group] : groups_)
    returned_.insert(returned_.end(), group.contacts.begin(), group.contacts.end());
  giveBack(memory);
  groups_.clear();
  boxes_.clear();
  const std::size_t size = world.balls.size();
  group_.assign(size, kAwake);
  steps_.assign(size, 0);
  early_.assign(size, 0);
  slow_.clear();
  position_.resize(size);
  acceleration_.resize(size);
  isGhost_.resize(size);
  if (world.settings.sleepSpeed > 0) makeRoom(size);
  awake_.resize(size);
  std::iota(awake_.begin(), awake_.end(), 0u);
}

void Sleep::makeRoom(std::size_t size) {
  isPressed_.resize(size);
  speed_.resize(size);
  ahead_.resize(size);
  island_.resize(size);
  rest_.resize(size);
  slow_.reserve(size);
}

void Sleep::wakeChanged(const World& world) {
  for (const std::uint32_t i : world.changed.list()) {
    if (i >= group_.size()) continue;
    steps_[i] = 0;
    if (group_[i] != kAwake && !isUnchanged(world, i)) wake(group_[i]);
  }
}

bool Sleep::isUnchanged(const World& world, std::uint32_t ball) const {
  const bool isGhost = !world.owns(ball);
  if (isGhost != (isGhost_[ball] != 0)) return false;
  const double tolerated = isGhost ? world.settings.sleepSpeed : 0;
  return length(world.balls.position[ball] - position_[ball]) <= tolerated * kRestTime &&
         speedOf(world.balls, ball) <= tolerated;
}

void Sleep::wakePulled(const World& world, const Field& field) {
  if (groups_.empty() || areSame(wells_, field.wells)) return;
  wells_ = field.wells;
  for (auto next = groups_.begin(); next != groups_.end();) {
    const auto& [lowest, group] = *next++;  // waking it erases it
    if (isPulledAnew(world, field, group)) wake(lowest);
  }
}

bool Sleep::isPulledAnew(const World& world, const Field& field, const Group& group) const {
  // What stands still exactly does so while the fields stay exactly as they are.
  const double most = group.contacts.empty() ? 0 : world.settings.sleepSpeed / kRestTime;
  return std::ranges::any_of(group.balls, [&](std::uint32_t i) {
    const Vec3& at = world.balls.position[i];
    return length(acceleration(field, at, 0) - acceleration_[i]) > most ||
           length(acceleration(field, at, world.settings.dt) - acceleration_[i]) > most;
  });
}

void Sleep::wakeAhead(const World& world, const Field& field, ContactMemory& memory) {
  if (groups_.empty()) return;
  woken_.clear();
  const double dt = world.settings.dt;
  for (const std::uint32_t i : awake_) {
    if (!isFinite(world.balls.state(i))) continue;
    const Vec3& at = world.balls.position[i];
    wakeMet(world, {i, at, world.balls.velocity[i] * dt, pullOf(field, at, dt) * dt});
  }
  wakeMetByWoken(world, field, memory);
}

bool Sleep::wakeAround(const World& world, std::span<const BallState> start, const Field& field,
                       ContactMemory& memory) {
  woken_.clear();
  if (groups_.empty()) return false;
  const double dt = world.settings.dt;
  for (const std::uint32_t i : awake_) {
    const Vec3& before = start[i].velocity;
    const Vec3& after = world.balls.velocity[i];
    const double pull = pullOf(field, start[i].position, dt);
    // Forces alone change it by no more.
    if (!(length(after - before) > 2 * pull)) continue;
    const double speed = std::max(length(before), length(after));
    wakeMet(world, {i, start[i].position, Vec3::Zero(), (speed + pull) * dt});
  }
  wakeMetByWoken(world, field, memory);
  return !woken_.empty();
}

void Sleep::wakeMetByWoken(const World& world, const Field& field, ContactMemory& memory) {
  const double dt = world.settings.dt;
  for (std::size_t n = 0; n < woken_.size(); ++n) {
    const std::uint32_t i = woken_[n];
    const Vec3& at = world.balls.position[i];
    wakeMet(world, {i, at, Vec3::Zero(), pullOf(field, at, dt) * dt});
  }
  finishWaking(memory);
}

void Sleep::wakeMet(const World& world, const Sweep& sweep) {
  const Balls& balls = world.balls;
  const double radius = balls.radius[sweep.ball];
  const Vec3 margin = Vec3::Constant((1 + kLeaningGap) * radius + sweep.slack);
  found_.clear();
  boxes_.find(sweep.start + sweep.path.cwiseMin(0) - margin,
              sweep.start + sweep.path.cwiseMax(0) + margin, found_);
  const bool isGhost = !world.owns(sweep.ball);
  for (const std::uint32_t i : found_) {
    if (group_[i] == kAwake) continue;
    const double touching = radius + balls.radius[i];
    const double bound =
        isGhost && !world.owns(i) ? (1 + kLeaningGap) * touching : touching + sweep.slack;
    if (distanceFromPath(balls.position[i], sweep.start, sweep.path) <= bound) wake(group_[i]);
  }
}

void Sleep::wake(std::uint32_t group) {
  const auto woken = groups_.extract(group);
  const Group& left = woken.mapped();
  returned_.insert(returned_.end(), left.contacts.begin(), left.contacts.end());
  for (const std::uint32_t i : left.balls) {
    boxes_.remove(i);
    group_[i] = kAwake;
    steps_[i] = 0;
    woken_.push_back(i);
  }
}

void Sleep::giveBack(ContactMemory& memory) {
  if (!returned_.empty()) memory.giveBack(returned_);
  returned_.clear();
}

void Sleep::finishWaking(ContactMemory& memory) {
  if (woken_.empty()) return;
  awake_.insert(awake_.end(), woken_.begin(), woken_.end());
  std::ranges::sort(awake_);
  giveBack(memory);
}

void Sleep::end(World& world, const Field& field, const Candidates& candidates, Books& books,
                ContactMemory& memory) {
  nextStep_ = world.step;
  fallen_.clear();
  if (world.settings.sleepSpeed == 0 || !anyHasRested(world, memory)) return;
  findIslands(world, field, candidates, memory);
  for (const std::uint32_t i : awake_) {
    Rest& rest = rest_[rootOf(island_, i)];
    if (!rest.isLong || rest.now > rest.early) continue;
    if (rest.group == kAwake) rest.group = i;
    letSleep(world, field, i, rest.group, books);
  }
  // What has settled at a steady creep does not gather speed any more.
  const std::uint32_t needed = restSteps(world.settings.dt);
  for (const std::uint32_t i : slow_) {
    if (group_[i] != kAwake || steps_[i] < 2 * needed) continue;
    steps_[i] = needed;
    early_[i] = speed_[i];
  }
  if (fallen_.empty()) return;
  std::erase_if(awake_, [&](std::uint32_t i) { return group_[i] != kAwake; });
  takeContacts(memory);
  wells_ = field.wells;
}

// Most balls of a world that moves are too fast, and are only looked at.
void Sleep::findSlow(const World& world) {
  const double most = world.settings.sleepSpeed * world.settings.sleepSpeed;
  const auto isFast = [&](std::uint32_t i) {
    return squaredLength(world.balls.velocity[i]) > most;  // not so what is not a number
  };
  for (const std::uint32_t i : slow_)
    if (group_[i] == kAwake && isFast(i)) steps_[i] = 0;
  slow_.clear();
  for (const std::uint32_t i : awake_)
    if (!isFast(i)) slow_.push_back(i);
}

bool Sleep::anyHasRested(const World& world, const ContactMemory& memory) {
  findSlow(world);
  if (slow_.empty()) return false;
  for (const std::uint32_t i : slow_) isPressed_[i] = 0;
  for (const StepperMemory::Contact& c : memory.contacts()) {
    isPressed_[c.a] = 1;
    if (isBall(c.b)) isPressed_[c.b] = 1;
  }
  const std::uint32_t needed = restSteps(world.settings.dt);
  bool anyHas = false;
  for (const std::uint32_t i : slow_) {
    speed_[i] = speedOf(world.balls, i);
    // What is not finite is named after each step, and does not rest.
    if (!(speed_[i] <= (isPressed_[i] ? world.settings.sleepSpeed : 0)) ||
        !isFinite(world.balls.position[i])) {
      steps_[i] = 0;
      continue;
    }
    if (steps_[i] == 0) early_[i] = 0;
    ++steps_[i];
    if (steps_[i] <= needed / 2) early_[i] = std::max(early_[i], speed_[i]);
    if (steps_[i] >= needed) anyHas = true;
  }
  return anyHas;
}

void Sleep::findIslands(const World& world, const Field& field, const Candidates& candidates,
                        const ContactMemory& memory) {
  const Balls& balls = world.balls;
  const double dt = world.settings.dt;
  for (const std::uint32_t i : awake_) island_[i] = i;
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    island_[rootOf(island_, a)] = rootOf(island_, b);
  };
  for (const StepperMemory::Contact& c : memory.contacts())
    if (isBall(c.b)) join(c.a, c.b);
  // As wakeAhead() has it: an island whose neighbour stays awake would wake at once.
  for (const std::uint32_t i : awake_)
    ahead_[i] = (length(balls.velocity[i]) + pullOf(field, balls.position[i], dt)) * dt;
  for (const auto& [a, b] : candidates.ballPairs()) {
    const double bound = balls.radius[a] + balls.radius[b] + std::max(ahead_[a], ahead_[b]);
    if (squaredLength(balls.position[b] - balls.position[a]) <= bound * bound) join(a, b);
  }
  for (const auto& [a, b] : candidates.leaningPairs()) join(a, b);

  for (const std::uint32_t i : awake_) rest_[i] = {};
  const std::uint32_t needed = restSteps(dt);
  for (const std::uint32_t i : awake_) {
    Rest& rest = rest_[rootOf(island_, i)];
    if (steps_[i] == 0) {
      rest.isLong = false;
      continue;
    }
    rest.isLong = rest.isLong && steps_[i] >= needed;
    rest.now = std::max(rest.now, speed_[i]);
    rest.early = std::max(rest.early, early_[i]);
  }
}

void Sleep::letSleep(World& world, const Field& field, std::uint32_t ball, std::uint32_t group,
                     Books& books) {
  Balls& balls = world.balls;
  Mechanics left;
  addMechanics(world, field, world.settings.dt, ball, left);
  books.sleep -= left.kineticEnergy;
  books.rest.linear -= left.momentum;
  books.rest.angular -= left.angularMomentum;
  balls.velocity[ball].setZero();
  balls.spin[ball].setZero();
  group_[ball] = group;
  groups_[group].balls.push_back(ball);
  position_[ball] = balls.position[ball];
  acceleration_[ball] = acceleration(field, balls.position[ball], world.settings.dt);
  isGhost_[ball] = world.owns(ball) ? 0 : 1;
  boxes_.add(ball, balls.position[ball], (1 + kLeaningGap) * balls.radius[ball]);
  fallen_.push_back(ball);
}

void Sleep::takeContacts(ContactMemory& memory) {
  const auto isAsleep = [&](std::uint32_t i) { return group_[i] != kAwake; };
  memory.take(isAsleep, [&](const StepperMemory::Contact& c) {
    if (isAsleep(c.a) && (!isBall(c.b) || group_[c.a] == group_[c.b]))
      groups_[group_[c.a]].contacts.push_back(c);
  });
}

void Sleep::save(StepperMemory::Rest& rest, ContactMemory& contacts) const {
  rest.conditions = conditions_;
  rest.group = group_;
  rest.steps = steps_;
  rest.speed = early_;
  rest.position = position_;
  rest.acceleration = acceleration_;
  rest.isGhost = isGhost_;
  std::vector<StepperMemory::Contact> kept;
  for (const auto& [lowest, group] : groups_)
    kept.insert(kept.end(), group.contacts.begin(), group.contacts.end());
  contacts.giveBack(kept);
}

void Sleep::restore(const StepperMemory::Rest& rest, ContactMemory& contacts) {
  groups_.clear();
  boxes_.clear();
  wells_.clear();
  awake_.clear();
  conditions_ = rest.conditions;
  nextStep_.reset();
  needsBoxes_ = true;
  group_ = rest.group;
  steps_ = rest.steps;
  early_ = rest.speed;
  position_ = rest.position;
  acceleration_ = rest.acceleration;
  isGhost_ = rest.isGhost;
  const std::size_t size = group_.size();
  makeRoom(size);
  slow_.clear();
  for (std::uint32_t i = 0; i < size; ++i) {
    if (group_[i] != kAwake) {
      groups_[group_[i]].balls.push_back(i);
      continue;
    }
    awake_.push_back(i);
    if (steps_[i] > 0) slow_.push_back(i);
  }
  takeContacts(contacts);
}

}  // namespace wells
