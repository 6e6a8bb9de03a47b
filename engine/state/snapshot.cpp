#include "state/snapshot.h"

#include "math/hash.h"
#include "state/snapshot_bytes.h"
#include "state/snapshot_check.h"

namespace wells {
namespace {

constexpr std::string_view kMagic = "wellsnap";
constexpr std::size_t kHeadSize = 8 + 4 + 8;  // magic, version, length
constexpr std::size_t kTailSize = 8;          // checksum

// The fields, once for both directions: `bytes` is a writer and the structs are const, or it is a
// reader and they are not. Each struct is taken apart whole, so that a field added to it does not
// compile until it stands here too.

void transferNumbers(auto& bytes, std::string_view name, auto& numbers) {
  bytes.list(name, numbers, 8, [&](auto& number) { bytes.field(number); });
}

void transferVectors(auto& bytes, std::string_view name, auto& vectors) {
  bytes.list(name, vectors, 24, [&](auto& vector) { bytes.field(vector); });
}

void transferSettings(auto& bytes, auto& settings) {
  auto& [dt, gravity, drag, elasticity, friction, rollingResistance, integrator, contactMethod,
         substeps, iterations, mostImpacts, sleepSpeed, broadphase] = settings;
  bytes.field(dt);
  bytes.field(gravity);
  bytes.field(drag);
  bytes.field(elasticity);
  bytes.field(friction);
  bytes.field(rollingResistance);
  bytes.field(integrator);
  bytes.choice("settings.contactMethod", contactMethod, kContactMethodNames.size());
  bytes.field(substeps);
  bytes.field(iterations);
  bytes.field(mostImpacts);
  bytes.field(sleepSpeed);
  bytes.choice("settings.broadphase", broadphase, kBroadphaseNames.size());
}

void transferKeyframe(auto& bytes, auto& keyframe) {
  auto& [step, position, strength] = keyframe;
  bytes.field(step);
  bytes.field(position);
  bytes.field(strength);
}

void transferTrack(auto& bytes, auto& track) {
  constexpr std::size_t kKeyframeSize = 8 + 24 + 8;
  auto& [keyframes, softening, peer] = track;
  bytes.list("keyframes of a well", keyframes, kKeyframeSize,
             [&](auto& keyframe) { transferKeyframe(bytes, keyframe); });
  bytes.field(softening);
  bytes.choice("peer of a well", peer, kMaxPeerId + 1);
}

void transferBalls(auto& bytes, auto& balls) {
  auto& [position, velocity, spin, radius, mass] = balls;
  transferVectors(bytes, "balls.position", position);
  transferVectors(bytes, "balls.velocity", velocity);
  transferVectors(bytes, "balls.spin", spin);
  transferNumbers(bytes, "balls.radius", radius);
  transferNumbers(bytes, "balls.mass", mass);
}

void transferArena(auto& bytes, auto& arena) {
  auto& [center, radius] = arena;
  bytes.field(center);
  bytes.field(radius);
}

void transferChanged(SnapshotWriter& bytes, std::size_t, const ChangedBalls& changed) {
  bytes.list("changed", changed.list(), 4, [&](std::uint32_t ball) { bytes.field(ball); });
}

void transferChanged(SnapshotReader& bytes, std::size_t balls, ChangedBalls& changed) {
  std::vector<std::uint32_t> list;
  bytes.list("changed", list, 4, [&](std::uint32_t& ball) { bytes.field(ball); });
  for (const std::uint32_t ball : list) {
    // It takes memory up to the highest.
    if (ball >= balls)
      throw SnapshotError(fmt::format("changed ball = {}; allowed: below {}", ball, balls));
    changed.add(ball);
  }
}

void transferWorld(auto& bytes, auto& world) {
  constexpr std::size_t kLeastTrackSize = 8 + 8 + 1;
  auto& [settings, arena, tracks, balls, roles, step, leaning, changed] = world;
  static_cast<void>(leaning);  // derived
  transferSettings(bytes, settings);
  transferArena(bytes, arena);
  bytes.list("wells", tracks, kLeastTrackSize, [&](auto& track) { transferTrack(bytes, track); });
  transferBalls(bytes, balls);
  bytes.list("roles", roles, 1, [&](auto& role) { bytes.choice("role of a ball", role, 2); });
  bytes.field(step);
  transferChanged(bytes, balls.size(), changed);
}

void transferContact(auto& bytes, auto& contact) {
  auto& [a, b, normalImpulse, tangentImpulse, rollingImpulse] = contact;
  bytes.field(a);
  bytes.field(b);
  bytes.field(normalImpulse);
  bytes.field(tangentImpulse);
  bytes.field(rollingImpulse);
}

void transferRest(auto& bytes, auto& rest) {
  auto& [conditions, group, steps, speed, position, acceleration, isGhost] = rest;
  bytes.field(conditions);
  const auto transfer = [&](auto& number) { bytes.field(number); };
  bytes.list("memory.rest.group", group, 4, transfer);
  bytes.list("memory.rest.steps", steps, 4, transfer);
  transferNumbers(bytes, "memory.rest.speed", speed);
  transferVectors(bytes, "memory.rest.position", position);
  transferVectors(bytes, "memory.rest.acceleration", acceleration);
  bytes.list("memory.rest.isGhost", isGhost, 1,
             [&](auto& flag) { bytes.choice("memory.rest.isGhost of a ball", flag, 2); });
}

void transferMemory(auto& bytes, auto& memory) {
  constexpr std::size_t kContactSize = 4 + 4 + 8 + 24 + 24;
  auto& [substep, ballContacts, arenaContacts, stepsInSubsteps, rest, carried] = memory;
  const auto transfer = [&](auto& contact) { transferContact(bytes, contact); };
  bytes.field(substep);
  bytes.list("memory.ballContacts", ballContacts, kContactSize, transfer);
  bytes.list("memory.arenaContacts", arenaContacts, kContactSize, transfer);
  bytes.list("memory.stepsInSubsteps", stepsInSubsteps, 1, [&](auto& n) {
    bytes.choice("memory.stepsInSubsteps of a ball", n, kCrowdSteps + 1);
  });
  transferRest(bytes, rest);
  auto& [position, velocity, lastVelocity, force] = carried;
  transferVectors(bytes, "memory.carried.position", position);
  transferVectors(bytes, "memory.carried.velocity", velocity);
  transferVectors(bytes, "memory.carried.lastVelocity", lastVelocity);
  transferVectors(bytes, "memory.carried.force", force);
}

void transferSnapshot(auto& bytes, auto& snapshot) {
  auto& [world, memory, engine, config] = snapshot;
  transferWorld(bytes, world);
  transferMemory(bytes, memory);
  bytes.field(engine);
  bytes.list("config", config, 8 + 8, [&](auto& entry) {
    auto& [name, value] = entry;
    bytes.field(name);
    bytes.field(value);
  });
}

std::uint64_t checksum(std::string_view bytes) {
  Hash hash;
  hash.add(bytes);
  return hash.value();
}

// What does not depend on the fields: that all bytes are there, and are those that were written.
void requireWhole(std::string_view bytes) {
  if (bytes.substr(0, kMagic.size()) != kMagic.substr(0, bytes.size()))
    throw SnapshotError("not a snapshot of a world: it does not start like one");
  if (bytes.size() < kHeadSize + kTailSize) {
    throw SnapshotError(
        fmt::format("cut: has {} bytes of at least {}", bytes.size(), kHeadSize + kTailSize));
  }
  SnapshotReader head(bytes.substr(kMagic.size()));
  const auto version = head.word<std::uint32_t>();
  if (version != kSnapshotVersion)
    throw SnapshotError(
        fmt::format("is of format version {}; this program reads {}", version, kSnapshotVersion));
  const auto length = head.word<std::uint64_t>();
  if (bytes.size() < length)
    throw SnapshotError(fmt::format("cut: has {} of {} bytes", bytes.size(), length));
  if (bytes.size() > length)
    throw SnapshotError(fmt::format("altered: has {} bytes instead of {}", bytes.size(), length));
  const std::uint64_t noted =
      SnapshotReader(bytes.substr(bytes.size() - kTailSize)).word<std::uint64_t>();
  const std::uint64_t actual = checksum(bytes.substr(0, bytes.size() - kTailSize));
  if (noted != actual) {
    throw SnapshotError(fmt::format("altered: its checksum is {:016x}, that of its content {:016x}",
                                    noted, actual));
  }
}

}  // namespace

std::string encode(const Snapshot& snapshot) {
  requireValid(snapshot);
  SnapshotWriter out;
  out.bytes = kMagic;
  out.word(kSnapshotVersion);
  SnapshotWriter fields;
  transferSnapshot(fields, snapshot);
  out.word<std::uint64_t>(kHeadSize + fields.bytes.size() + kTailSize);
  out.bytes += fields.bytes;
  out.word(checksum(out.bytes));
  return std::move(out.bytes);
}

Snapshot decode(std::string_view bytes) {
  requireWhole(bytes);
  SnapshotReader fields(bytes.substr(kHeadSize, bytes.size() - kHeadSize - kTailSize));
  Snapshot snapshot;
  transferSnapshot(fields, snapshot);
  if (fields.left() > 0)
    throw SnapshotError(
        fmt::format("{} bytes stand behind the last field; allowed: 0", fields.left()));
  requireValid(snapshot);
  return snapshot;
}

}  // namespace wells
