#include <gtest/gtest.h>
#include <sys/stat.h>

#include <bit>
#include <cmath>

#include "ball_file.h"
#include "errors.h"
#include "math/random.h"
#include "temporary_folder.h"
#include "text_file.h"
#include "well_motion.h"

namespace wells {
namespace {

constexpr const char* kRow = ",1,2,3,4,5,6,7,8,9,0.5,1\n";

std::string errorOf(const std::filesystem::path& file) {
  try {
    readBalls(file);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BallFile, ReadsBackTheSameBits) {
  Random random(7);
  const auto number = [&] {
    return (random.uniform() - 0.5) * std::pow(10, random.uniform(-8, 6));
  };
  Balls balls;
  for (int i = 0; i < 1000; ++i) {
    balls.add({.position = {number(), number(), number()},
               .velocity = {number(), -0.0, number()},
               .spin = {number(), number(), 0}},
              std::abs(number()) + 1e-9, std::abs(number()) + 1e-9);
  }
  const TemporaryFolder folder;
  writeAtomically(folder / "balls.csv", ballsAsCsv(balls));
  const Balls again = readBalls(folder / "balls.csv");
  ASSERT_EQ(again.size(), balls.size());
  const auto sameBits = [](const Vec3& a, const Vec3& b) {
    for (int k = 0; k < 3; ++k)
      if (std::bit_cast<std::uint64_t>(a[k]) != std::bit_cast<std::uint64_t>(b[k])) return false;
    return true;
  };
  for (std::size_t i = 0; i < balls.size(); ++i) {
    EXPECT_TRUE(sameBits(again.position[i], balls.position[i])) << i;
    EXPECT_TRUE(sameBits(again.velocity[i], balls.velocity[i])) << i;
    EXPECT_TRUE(sameBits(again.spin[i], balls.spin[i])) << i;
    EXPECT_EQ(again.radius[i], balls.radius[i]);
    EXPECT_EQ(again.mass[i], balls.mass[i]);
  }
}

TEST(BallFile, TakesRowsInAnyOrder) {
  const TemporaryFolder folder;
  const auto file =
      folder.write("b.csv", std::string(kBallsHeader) +
                                "\n1,10,0,0,0,0,0,0,0,0,0.5,1\n0,20,0,0,0,0,0,0,0,0,1,2\n");
  const Balls balls = readBalls(file);
  ASSERT_EQ(balls.size(), 2u);
  EXPECT_EQ(balls.position[0].x(), 20);
  EXPECT_EQ(balls.position[1].x(), 10);
  EXPECT_EQ(balls.mass[0], 2);
}

struct BadTable {
  const char* text;
  const char* message;
};

TEST(BallFile, RefusesBadTables) {
  const TemporaryFolder folder;
  const std::string header = std::string(kBallsHeader) + "\n";
  const std::string good = std::string("0") + kRow;
  const std::pair<std::string, const char*> cases[] = {
      {"", ":1: the file is empty"},
      {"id,x,y\n", ":1: the header is \"id,x,y\"; allowed: exactly"},
      {header + "0,1,2\n", ":2: 3 cell(s); allowed: 12"},
      {header + good + "0" + kRow, ":3: id=0: already in line 2; allowed: each of 0 to 1 once"},
      {header + "1" + kRow, ":2: id=1: out of range; allowed: a whole number 0 to 0"},
      {header + "zero" + kRow, ":2: id=zero: not a whole number"},
      {header + "0,1,2,3,4,5,6,7,8,9,-0.5,1\n",
       ":2: radius=-0.5: out of range; allowed: a number above 0"},
      {header + "0,1,2,3,4,5,6,7,8,9,0.5,0\n", ":2: mass=0: out of range"},
      {header + "0,1,2,3,nan,5,6,7,8,9,0.5,1\n", ":2: vx=nan: not a finite number"},
      {header + "0,1,2,3,4,5,6,7,8,,0.5,1\n", ":2: wz=: the value is missing"},
      {header + "0,1,2,3 m,4,5,6,7,8,9,0.5,1\n", ":2: z=3 m: \"m\" after the number"},
  };
  for (const auto& [text, message] : cases) {
    const auto file = folder.write("b.csv", text);
    EXPECT_NE(errorOf(file).find(file.string() + message), std::string::npos)
        << errorOf(file) << "\nexpected " << message;
  }
  EXPECT_NE(errorOf(folder / "absent.csv").find("cannot be read"), std::string::npos);
}

TEST(TextFile, LeavesTheOldFileWhenItCannotWrite) {
  EXPECT_THROW(writeAtomically("/proc/absent/file", "x"), RunError);
  EXPECT_THROW(requireWritable("--report", "/proc/absent/file"), UsageError);
  EXPECT_THROW(requireFolder("--frames", "/proc/absent/folder"), UsageError);
}

// As /dev/null would be, to root: a renaming would take it from everybody.
TEST(TextFile, LeavesWhatIsNoRegularFile) {
  const TemporaryFolder folder;
  const auto pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(writeAtomically(pipe, "x"), RunError);
  EXPECT_THROW(requireWritable("--report", pipe), UsageError);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_FALSE(std::filesystem::exists(folder / ("pipe." + std::to_string(::getpid()) + ".part")));
}

TEST(WellMotion, CircleKeepsItsRadiusPeriodAndStart) {
  Config config;
  config.arena.center = {5, 1, -3};
  config.wellPath = {.kind = WellPath::Kind::Circle, .radius = 12, .period = 30};
  const double dt = 1.0 / 60;
  const WellMotion motion(config, dt);
  for (std::int64_t step = 0; step <= 1800; step += 50) {
    // Peer 3 stands a quarter turn from +x towards +z; its height is that of a ball on the ground.
    const double angle = 2 * M_PI * (0.25 + static_cast<double>(step) * dt / 30);
    const Vec3 expected(5 + 12 * std::cos(angle), 1.5, -3 + 12 * std::sin(angle));
    EXPECT_NEAR((motion.at(PeerId{3}, step).position - expected).norm(), 0, 1e-9) << step;
  }
}

TEST(WellMotion, ATrackStaysShortAndNearThePath) {
  Config config;
  config.wellPath = {.kind = WellPath::Kind::Circle, .radius = 20, .period = -20};
  const double dt = 1.0 / 60;
  const WellMotion motion(config, dt);
  WellTrack track = motion.trackAt(PeerId{1}, 0);
  // A chord of 0.1 s leaves its arc by at most R (1 - cos(pi 0.1 / T)).
  const double bound = 20 * (1 - std::cos(M_PI * 0.1 / 20)) + 1e-12;
  for (std::int64_t step = 0; step < 2000; ++step) {
    motion.extend(track, step);
    ASSERT_LE(track.keyframes.size(), 3u);
    const Vec3 shown = wellAt(track, step, dt).position;
    ASSERT_LE((shown - motion.at(PeerId{1}, step).position).norm(), bound) << step;
  }
}

TEST(WellMotion, AStillWellHasOneKeyframe) {
  const WellMotion motion(Config{}, 1.0 / 60);
  WellTrack track = motion.trackAt(PeerId{2}, 0);
  for (std::int64_t step = 0; step < 100; ++step) motion.extend(track, step);
  ASSERT_EQ(track.keyframes.size(), 1u);
  EXPECT_NEAR((track.keyframes[0].position - Vec3(-20, 0.5, 0)).norm(), 0, 1e-9);
}

TEST(WellMotion, FollowsAKeyframeFile) {
  const TemporaryFolder folder;
  Config config;
  config.wellPath = {.kind = WellPath::Kind::Keyframes,
                     .file = folder.write("p.csv", "t,x,y,z,strength\n1,0,1,0,10\n2,4,1,0,20\n")};
  const WellMotion motion(config, 0.01);
  const auto at = [&](std::int64_t step) { return motion.at(PeerId{1}, step); };
  EXPECT_EQ(at(0).position, Vec3(0, 1, 0));
  EXPECT_NEAR(at(150).position.x(), 2, 1e-12);
  EXPECT_EQ(at(150).strength, 10);
  EXPECT_EQ(at(200).strength, 20);
  EXPECT_EQ(at(900).position, Vec3(4, 1, 0));
}

TEST(WellMotion, RefusesTimesThatDoNotRise) {
  const TemporaryFolder folder;
  Config config;
  config.wellPath = {.kind = WellPath::Kind::Keyframes,
                     .file = folder.write("p.csv", "t,x,y,z,strength\n1,0,1,0,10\n1,4,1,0,20\n")};
  try {
    const WellMotion motion(config, 0.01);
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_NE(std::string(error.what()).find("p.csv:3: t=1: not later than the line before"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace wells
