#include "state/snapshot_check.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace wells {
namespace {

constexpr std::int64_t kLatestStep = std::int64_t{1} << 53;  // World::time() counts in doubles

template <class Value>
void require(bool holds, std::string_view name, const Value& value, std::string_view allowed) {
  if (!holds) throw SnapshotError(fmt::format("{} = {}; allowed: {}", name, value, allowed));
}

template <class Value>
void requireItem(bool holds, std::string_view list, std::size_t index, std::string_view part,
                 const Value& value, std::string_view allowed) {
  if (!holds) require(false, fmt::format("{}[{}]{}", list, index, part), value, allowed);
}

void requirePositive(std::string_view name, double value) {
  require(value > 0 && std::isfinite(value), name, value, "a finite number above 0");
}

void requireFinite(std::string_view name, const Vec3& v) {
  if (isFinite(v)) return;
  throw SnapshotError(
      fmt::format("{} = {},{},{}; allowed: finite numbers", name, v.x(), v.y(), v.z()));
}

void requireStep(std::string_view name, std::int64_t step, std::int64_t first) {
  require(step >= first && step <= kLatestStep, name, step,
          fmt::format("{} to {}", first, kLatestStep));
}

void requireSettings(const Settings& settings) {
  requirePositive("settings.dt", settings.dt);
  requireFinite("settings.gravity", settings.gravity);
  require(settings.drag > 0 && settings.drag <= 1, "settings.drag", settings.drag,
          "a number above 0 to 1");
  require(settings.elasticity >= 0 && settings.elasticity <= 1, "settings.elasticity",
          settings.elasticity, "a number 0 to 1");
  require(settings.friction >= 0 && std::isfinite(settings.friction), "settings.friction",
          settings.friction, "a finite number from 0");
  require(settings.rollingResistance >= 0 && std::isfinite(settings.rollingResistance),
          "settings.rollingResistance", settings.rollingResistance, "a finite number from 0");
  require(settings.substeps >= 1, "settings.substeps", settings.substeps, "1 or more");
  require(settings.iterations >= 1, "settings.iterations", settings.iterations, "1 or more");
  require(settings.mostImpacts >= 1, "settings.mostImpacts", settings.mostImpacts, "1 or more");
  require(settings.sleepSpeed >= 0 && std::isfinite(settings.sleepSpeed), "settings.sleepSpeed",
          settings.sleepSpeed, "a finite number from 0");
}

void requireTrack(const WellTrack& track, const std::string& name) {
  require(!track.keyframes.empty(), name + ".keyframes", "none", "at least one");
  for (std::size_t k = 0; k < track.keyframes.size(); ++k) {
    const WellKeyframe& key = track.keyframes[k];
    const std::string at = fmt::format("{}.keyframes[{}]", name, k);
    requireStep(at + ".step", key.step, -kLatestStep);
    require(k == 0 || key.step > track.keyframes[k - 1].step, at + ".step", key.step,
            "later than the keyframe before");
    requireFinite(at + ".position", key.position);
    require(std::isfinite(key.strength), at + ".strength", key.strength, "a finite number");
  }
  requirePositive(name + ".softening", track.softening);
}

void requireCount(std::string_view name, std::size_t size, std::size_t balls) {
  require(size == balls, fmt::format("length of {}", name), size, fmt::format("{} balls", balls));
}

void requireNoneOrCount(std::string_view name, std::size_t size, std::size_t balls) {
  if (size > 0) requireCount(name, size, balls);
}

void requireBalls(const Balls& balls, const Arena& arena) {
  requireCount("balls.velocity", balls.velocity.size(), balls.size());
  requireCount("balls.spin", balls.spin.size(), balls.size());
  requireCount("balls.radius", balls.radius.size(), balls.size());
  requireCount("balls.mass", balls.mass.size(), balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i) {
    requireItem(balls.radius[i] > 0 && balls.radius[i] < arena.radius, "balls.radius", i, "",
                balls.radius[i], "above 0 to below that of the arena");
    requireItem(balls.mass[i] > 0 && std::isfinite(balls.mass[i]), "balls.mass", i, "",
                balls.mass[i], "a finite number above 0");
  }
}

void requireContacts(std::string_view name, const std::vector<StepperMemory::Contact>& contacts,
                     std::size_t balls, bool (*isPartner)(std::uint32_t b, std::size_t balls)) {
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& [a, b] = std::pair(contacts[i].a, contacts[i].b);
    requireItem(a < balls, name, i, ".a", a, "the id of a ball");
    requireItem(isPartner(b, balls), name, i, ".b", b, "the id of a partner of that kind");
    requireItem(i == 0 || std::pair(contacts[i - 1].a, contacts[i - 1].b) < std::pair(a, b), name,
                i, ".a", a, "contacts that rise by (a, b)");
  }
}

/// Each group is named for the lowest of its balls.
void requireRest(const StepperMemory::Rest& rest, std::size_t balls) {
  requireNoneOrCount("memory.rest.group", rest.group.size(), balls);
  const std::size_t size = rest.group.size();
  for (const auto& [name, count] : {std::pair("memory.rest.steps", rest.steps.size()),
                                    std::pair("memory.rest.speed", rest.speed.size()),
                                    std::pair("memory.rest.position", rest.position.size()),
                                    std::pair("memory.rest.acceleration", rest.acceleration.size()),
                                    std::pair("memory.rest.isGhost", rest.isGhost.size())})
    requireCount(name, count, size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t lowest = rest.group[i];
    requireItem(lowest == StepperMemory::kAwake || (lowest <= i && rest.group[lowest] == lowest),
                "memory.rest.group", i, "", lowest,
                fmt::format("the lowest ball of a group; {} if awake", StepperMemory::kAwake));
  }
}

void requireMemory(const StepperMemory& memory, std::size_t balls) {
  require(memory.substep >= 0 && std::isfinite(memory.substep), "memory.substep", memory.substep,
          "a finite number from 0");
  requireContacts("memory.ballContacts", memory.ballContacts, balls,
                  [](std::uint32_t b, std::size_t count) { return b < count; });
  requireContacts("memory.arenaContacts", memory.arenaContacts, balls,
                  [](std::uint32_t b, std::size_t) { return !isBall(b); });
  requireNoneOrCount("memory.stepsInSubsteps", memory.stepsInSubsteps.size(), balls);
  requireRest(memory.rest, balls);
  const StepperMemory::Carried& carried = memory.carried;
  requireNoneOrCount("memory.carried.position", carried.position.size(), balls);
  requireCount("memory.carried.velocity", carried.velocity.size(), carried.position.size());
  requireCount("memory.carried.lastVelocity", carried.lastVelocity.size(), carried.position.size());
  requireCount("memory.carried.force", carried.force.size(), carried.position.size());
}

}  // namespace

void requireValid(const Snapshot& snapshot) {
  const World& world = snapshot.world;
  requireSettings(world.settings);
  requireFinite("arena.center", world.arena.center);
  requirePositive("arena.radius", world.arena.radius);
  for (std::size_t i = 0; i < world.tracks.size(); ++i)
    requireTrack(world.tracks[i], fmt::format("wells[{}]", i));
  requireBalls(world.balls, world.arena);
  requireNoneOrCount("roles", world.roles.size(), world.balls.size());
  requireStep("step", world.step, 0);
  for (std::size_t i = 0; i < world.changed.list().size(); ++i)
    requireItem(world.changed.list()[i] < world.balls.size(), "changed", i, "",
                world.changed.list()[i], "the id of a ball");
  requireMemory(snapshot.memory, world.balls.size());
}

}  // namespace wells
