#include "state/snapshot.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "any_snapshot.h"
#include "math/hash.h"

namespace wells {
namespace {

constexpr std::size_t kVersionAt = 8;
constexpr std::size_t kLengthAt = 12;
constexpr std::size_t kFieldsAt = 20;

std::string errorOf(std::string_view bytes) {
  try {
    decode(bytes);
  } catch (const SnapshotError& error) {
    return error.what();
  }
  return "accepted";
}

std::string errorOf(const Snapshot& snapshot) {
  try {
    encode(snapshot);
  } catch (const SnapshotError& error) {
    return error.what();
  }
  return "accepted";
}

void put(std::string& bytes, std::size_t at, std::uint64_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i)
    bytes.at(at + i) = static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
}

// Somebody who knows the format can make length and checksum fit any content.
std::string sealed(std::string bytes) {
  put(bytes, kLengthAt, bytes.size(), 8);
  Hash hash;
  hash.add(std::string_view(bytes).substr(0, bytes.size() - 8));
  put(bytes, bytes.size() - 8, hash.value(), 8);
  return bytes;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Snapshot, EveryBitOfEveryFieldSurvives) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const Snapshot snapshot = anySnapshot(seed, seed % 7);
    expectSame(decode(encode(snapshot)), snapshot);
  }
}

TEST(Snapshot, ABallThatIsNotFiniteSurvives) {
  Snapshot snapshot = anySnapshot(1, 1);
  const double payload = std::bit_cast<double>(0xfff0dead0000beefu);  // signalling, negative
  snapshot.world.balls.position[0] = {payload, -0.0, std::numeric_limits<double>::infinity()};
  snapshot.world.balls.velocity[0] = {std::nan("7"), std::numeric_limits<double>::denorm_min(), 0};
  expectSame(decode(encode(snapshot)), snapshot);
}

TEST(Snapshot, AWorldWithoutBallsOrMemorySurvives) {
  expectSame(decode(encode({})), {});
}

// The format, from its description: a World of defaults without balls, wells and memory.
TEST(Snapshot, HasTheDocumentedLayout) {
  Snapshot snapshot;
  snapshot.world.settings.integrator = "rk4";
  snapshot.world.step = 0x0102;
  snapshot.engine = "e";
  const std::string bytes = encode(snapshot);
  EXPECT_EQ(bytes.substr(0, 8), "wellsnap");
  EXPECT_EQ(bytes.substr(kVersionAt, 4), std::string("\3\0\0\0", 4));
  EXPECT_EQ(static_cast<unsigned char>(bytes[kLengthAt]) +
                256u * static_cast<unsigned char>(bytes[kLengthAt + 1]),
            bytes.size());
  double dt = 0;
  std::memcpy(&dt, bytes.data() + kFieldsAt, 8);  // this machine is little-endian, as the format
  EXPECT_EQ(dt, 1.0 / 60);
  const std::size_t settings = 8 + 24 + 4 * 8 + (8 + 3) + 1 + 4 + 4 + 8 + 8 + 1;
  const std::size_t arena = 24 + 8;
  const std::size_t step = kFieldsAt + settings + arena + 8 + 5 * 8 + 8;
  EXPECT_EQ(bytes.substr(step, 8), std::string("\2\1\0\0\0\0\0\0", 8));
  EXPECT_EQ(bytes.size(), step + 8 + 8 + 8 + (8 + 6 * 8) + 7 * 8 + (8 + 1) + 8 + 8);
}

TEST(Snapshot, EveryCutIsRefused) {
  const std::string bytes = encode(anySnapshot(3, 3));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::string error = errorOf(std::string_view(bytes).substr(0, size));
    ASSERT_TRUE(contains(error, "cut: has " + std::to_string(size))) << size << ": " << error;
    ASSERT_TRUE(size < 28 || contains(error, "of " + std::to_string(bytes.size()))) << error;
  }
}

TEST(Snapshot, EveryAlteredByteIsRefused) {
  const std::string bytes = encode(anySnapshot(4, 3));
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const int change : {0x01, 0x80, 0xff}) {
      std::string altered = bytes;
      altered[at] = static_cast<char>(altered[at] ^ change);
      const std::string error = errorOf(altered);
      ASSERT_NE(error, "accepted") << at;
      ASSERT_TRUE(at < kFieldsAt || contains(error, "altered: its checksum is ")) << at << error;
    }
  }
}

TEST(Snapshot, EveryTwoExchangedBytesAreRefused) {
  const std::string bytes = encode(anySnapshot(5, 2));
  for (std::size_t at = kFieldsAt; at + 1 < bytes.size(); ++at) {
    std::string altered = bytes;
    std::swap(altered[at], altered[at + 1]);
    ASSERT_TRUE(altered == bytes || contains(errorOf(altered), "altered: ")) << at;
  }
}

TEST(Snapshot, SaysWhatIsWrongWithTheHead) {
  const std::string bytes = encode(anySnapshot(6, 2));
  EXPECT_TRUE(contains(errorOf("id,x,y,z,vx,vy,vz,wx,wy,wz"), "not a snapshot"));
  EXPECT_TRUE(contains(errorOf("id"), "not a snapshot"));
  std::string newer = bytes;
  put(newer, kVersionAt, 7, 4);
  EXPECT_EQ(errorOf(sealed(newer)), "is of format version 7; this program reads 3");
  EXPECT_TRUE(contains(errorOf(bytes + "x"), "altered: has "));
  std::string huge = bytes;
  put(huge, kLengthAt, ~0ull, 8);
  EXPECT_TRUE(contains(errorOf(huge), "cut: has ")) << errorOf(huge);
}

// With a right checksum: whatever stands in the fields, nothing is allocated for more items than
// there are bytes, and nothing but SnapshotError is thrown.
TEST(Snapshot, ContentThatNobodyEncodedIsRefusedOrValid) {
  const std::string bytes = encode(anySnapshot(7, 3));
  for (std::size_t at = kFieldsAt; at + 8 <= bytes.size() - 8; ++at) {
    for (const std::uint64_t value : {~0ull, 1ull << 63, 1ull << 40, 0ull, 5ull}) {
      std::string forged = bytes;
      put(forged, at, value, 8);
      forged = sealed(forged);
      try {
        EXPECT_EQ(encode(decode(forged)), forged) << at;
      } catch (const SnapshotError&) {
      }
    }
  }
  for (std::size_t size = 28; size < bytes.size(); ++size)
    EXPECT_NE(errorOf(sealed(bytes.substr(0, size))), "accepted") << size;
  EXPECT_NE(errorOf(sealed(bytes + std::string(5, '\0'))), "accepted");
}

TEST(Snapshot, AHugeCountIsRefusedBeforeAnythingIsAllocated) {
  std::string bytes = encode({});
  const std::size_t wells = kFieldsAt + 8 + 24 + 4 * 8 + (8 + 5) + 1 + 4 + 4 + 8 + 8 + 1 + 24 + 8;
  put(bytes, wells, 1ull << 60, 8);
  const std::string error = errorOf(sealed(bytes));
  EXPECT_TRUE(contains(error, "length of wells = 1152921504606846976; allowed: at most ")) << error;
}

struct BadField {
  const char* message;
  void (*spoil)(Snapshot&);
};

TEST(Snapshot, NamesTheFieldThatIsOutOfRange) {
  static constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const BadField cases[] = {
      {"settings.dt = 0; allowed: ", [](Snapshot& s) { s.world.settings.dt = 0; }},
      {"settings.dt = nan; ", [](Snapshot& s) { s.world.settings.dt = kNan; }},
      {"settings.gravity = 0,nan,0; ",
       [](Snapshot& s) {
         s.world.settings.gravity = {0, kNan, 0};
       }},
      {"settings.drag = 1.5; ", [](Snapshot& s) { s.world.settings.drag = 1.5; }},
      {"settings.elasticity = -1; ", [](Snapshot& s) { s.world.settings.elasticity = -1; }},
      {"settings.friction = nan; ", [](Snapshot& s) { s.world.settings.friction = kNan; }},
      {"settings.rollingResistance = -0.5; allowed: a finite number from 0",
       [](Snapshot& s) { s.world.settings.rollingResistance = -0.5; }},
      {"settings.rollingResistance = inf; ",
       [](Snapshot& s) { s.world.settings.rollingResistance = HUGE_VAL; }},
      {"settings.contactMethod = 9; allowed: 0 to 2",
       [](Snapshot& s) { s.world.settings.contactMethod = static_cast<ContactMethod>(9); }},
      {"settings.substeps = 0; ", [](Snapshot& s) { s.world.settings.substeps = 0; }},
      {"settings.iterations = -4; ", [](Snapshot& s) { s.world.settings.iterations = -4; }},
      {"settings.mostImpacts = 0; ", [](Snapshot& s) { s.world.settings.mostImpacts = 0; }},
      {"settings.sleepSpeed = -1; ", [](Snapshot& s) { s.world.settings.sleepSpeed = -1; }},
      {"settings.broadphase = 3; allowed: 0 to 2",
       [](Snapshot& s) { s.world.settings.broadphase = static_cast<BroadphaseKind>(3); }},
      {"length of memory.rest.speed = ", [](Snapshot& s) { s.memory.rest.speed.pop_back(); }},
      {"memory.rest.group[1] = 2; ", [](Snapshot& s) { s.memory.rest.group[1] = 2; }},
      {"memory.rest.group[2] = 0; ", [](Snapshot& s) { s.memory.rest.group[2] = 0; }},
      {"changed[0] = 99; ",
       [](Snapshot& s) {
         s.world.changed.clear();
         s.world.changed.add(99);
       }},
      {"arena.center = inf,0,0; ",
       [](Snapshot& s) {
         s.world.arena.center = {HUGE_VAL, 0, 0};
       }},
      {"arena.radius = -1; ", [](Snapshot& s) { s.world.arena.radius = -1; }},
      {"wells[1].keyframes = none; ", [](Snapshot& s) { s.world.tracks[1].keyframes.clear(); }},
      {"wells[2].keyframes[1].step = -1000; allowed: later than",
       [](Snapshot& s) { s.world.tracks[2].keyframes[1].step = -1000; }},
      {"wells[0].keyframes[0].step = 9223372036854775807; ",
       [](Snapshot& s) { s.world.tracks[0].keyframes[0].step = INT64_MAX; }},
      {"wells[0].keyframes[0].position = ",
       [](Snapshot& s) { s.world.tracks[0].keyframes[0].position.y() = kNan; }},
      {"wells[0].keyframes[0].strength = inf",
       [](Snapshot& s) { s.world.tracks[0].keyframes[0].strength = HUGE_VAL; }},
      {"wells[0].softening = 0; ", [](Snapshot& s) { s.world.tracks[0].softening = 0; }},
      {"peer of a well = -1; allowed: 0 to 255",
       [](Snapshot& s) { s.world.tracks[0].peer = PeerId{-1}; }},
      {"length of balls.mass = 2; allowed: 3 balls",
       [](Snapshot& s) { s.world.balls.mass.pop_back(); }},
      {"length of balls.spin = 2", [](Snapshot& s) { s.world.balls.spin.pop_back(); }},
      {"balls.radius[1] = nan; ", [](Snapshot& s) { s.world.balls.radius[1] = kNan; }},
      {"balls.radius[2] = 90; ", [](Snapshot& s) { s.world.balls.radius[2] = 90; }},
      {"balls.mass[0] = 0; ", [](Snapshot& s) { s.world.balls.mass[0] = 0; }},
      {"length of roles = 4; allowed: 3 balls",
       [](Snapshot& s) { s.world.roles.push_back(Role::Owned); }},
      {"role of a ball = 2; ", [](Snapshot& s) { s.world.roles[1] = static_cast<Role>(2); }},
      {"step = -1; ", [](Snapshot& s) { s.world.step = -1; }},
      {"memory.ballContacts[0].a = 3; ", [](Snapshot& s) { s.memory.ballContacts[0].a = 3; }},
      {"memory.ballContacts[1].b = 4294967295; ",
       [](Snapshot& s) { s.memory.ballContacts[1].b = 0xffffffff; }},
      {"memory.ballContacts[1].a = 0; allowed: contacts that rise",
       [](Snapshot& s) { s.memory.ballContacts[1] = s.memory.ballContacts[0]; }},
      {"memory.arenaContacts[0].b = 0; ", [](Snapshot& s) { s.memory.arenaContacts[0].b = 0; }},
      {"memory.substep = -1; ", [](Snapshot& s) { s.memory.substep = -1; }},
      {"memory.stepsInSubsteps of a ball = 31; ",
       [](Snapshot& s) { s.memory.stepsInSubsteps[0] = 31; }},
      {"length of memory.stepsInSubsteps = 1; ",
       [](Snapshot& s) { s.memory.stepsInSubsteps.resize(1); }},
      {"length of memory.carried.force = 0; ", [](Snapshot& s) { s.memory.carried.force.clear(); }},
  };
  for (const BadField& bad : cases) {
    Snapshot snapshot = anySnapshot(8, 3);
    bad.spoil(snapshot);
    EXPECT_TRUE(contains(errorOf(snapshot), bad.message))
        << errorOf(snapshot) << "\nexpected " << bad.message;
  }
}

}  // namespace
}  // namespace wells
