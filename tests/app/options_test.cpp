// The command line of `gravity-wells peer`: everything wrong is refused before anything starts.

#include "peer_options.h"

#include <gtest/gtest.h>

#include "errors.h"
#include "keys.h"
#include "temporary_folder.h"

namespace wells {
namespace {

PeerOptions parsed(const std::vector<std::string>& arguments) {
  return parsePeerOptions(arguments).value();
}

std::string errorOf(const std::vector<std::string>& arguments) {
  try {
    parsePeerOptions(arguments);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PeerOptions, KeysOverrideTheFile) {
  const PeerOptions options = parsed(
      {"--NumOfBalls", "200", "--config", WELLS_SOURCE_DIR "/config/template.txt", "--PeerID=2"});
  EXPECT_EQ(options.config.ballCount, 200);
  EXPECT_EQ(options.config.peerId, 2);
  EXPECT_EQ(options.config.settings.friction, 0.995) << "the file's";
  EXPECT_EQ(options.idOrigin, IdOrigin::CommandLine);
}

TEST(PeerOptions, AnIdFromTheFileMayBeGivenUp) {
  const PeerOptions options = parsed({"--config", WELLS_SOURCE_DIR "/config/template.txt"});
  EXPECT_EQ(options.idOrigin, IdOrigin::File);
  EXPECT_EQ(options.company, Company::Session);
  EXPECT_FALSE(options.hasEnd());
}

TEST(PeerOptions, NegativeValuesAndAliases) {
  const PeerOptions options =
      parsed({"--Gravity", "-1.5", "--dt", "0.01", "--integrator", "rk4", "--peer-id", "3",
              "--ArenaCenter", "-1,-2,-3", "--Well", "-5,1,0,100,2", "--Well", "5,1,0,-100,2"});
  EXPECT_EQ(options.config.settings.gravity.y(), -1.5);
  EXPECT_EQ(options.config.settings.dt, 0.01);
  EXPECT_EQ(options.config.settings.integrator, "rk4");
  EXPECT_EQ(options.config.peerId, 3);
  EXPECT_EQ(options.config.arena.center, Vec3(-1, -2, -3));
  ASSERT_EQ(options.config.wells.size(), 2u);
  EXPECT_EQ(options.config.wells[1].strength, -100);
}

TEST(PeerOptions, DurationBecomesSteps) {
  EXPECT_EQ(parsed({"--duration", "10"}).steps, 600);
  EXPECT_EQ(parsed({"--duration", "10", "--dt", "0.01"}).steps, 1000);
  EXPECT_EQ(parsed({"--duration", "10", "--dt", "0.01", "--TimeScale", "2"}).steps, 1000);
  // The reference engines stretch their step instead of doing more of them.
  EXPECT_EQ(
      parsed({"--duration", "10", "--dt", "0.01", "--TimeScale", "2", "--engine", "reference-rk"})
          .steps,
      500);
  EXPECT_EQ(parsed({"--steps", "7"}).steps, 7);
}

TEST(PeerOptions, StepsAreCountedAnewWhenDtHasChanged) {
  const TemporaryFolder folder;
  PeerOptions options = parsed({"--solo", "--duration", "10", "--target-error", "1e-6",
                                "--save-snapshot", folder / "world", "--save-snapshot-every", "1"});
  EXPECT_EQ(options.targetError, 1e-6);
  EXPECT_EQ(options.steps, 600);
  options.config.settings.dt = 0.05;
  countSteps(options);
  EXPECT_EQ(options.steps, 200);
  EXPECT_EQ(options.snapshotEvery, 20);
}

TEST(PeerOptions, EveryKeyIsAnOption) {
  for (const Key& key : keys()) {
    if (key.name == "HostIP") continue;  // takes any text
    const std::string error = errorOf({"--" + key.name, "&"});
    if (key.name == "BallsFile" || key.name == "WellPath") {
      EXPECT_EQ(error, "accepted") << "the name of a file";
      continue;
    }
    EXPECT_EQ(error.find("--" + key.name + " &: "), 0u) << error;
    EXPECT_NE(error.find("; allowed: " + key.allowed), std::string::npos) << error;
  }
}

struct BadOption {
  std::vector<std::string> arguments;
  const char* thing;    // names the option and the value
  const char* allowed;  // part of what is allowed
};

TEST(PeerOptions, RefusesEveryBadOption) {
  const BadOption cases[] = {
      {{"--config", "/absent/file"}, "/absent/file: cannot be read", "readable file"},
      {{"--config", ""}, "--config \"\": the value is missing", "a name"},
      {{"--config"}, "--config", "--help"},
      {{"--duration", "-1"}, "--duration -1: out of range", "above 0"},
      {{"--duration", "10s"}, "--duration 10s: \"s\" after the number", "in s"},
      {{"--duration", "inf"}, "--duration inf: not a finite number", "above 0"},
      {{"--steps", "1.5"}, "--steps 1.5: not a whole number", "0 to"},
      {{"--steps", "-1"}, "--steps -1: out of range", "0 to"},
      {{"--steps", "5", "--duration", "1"}, "--steps and --duration", "one of them"},
      {{"--engine", "havok"}, "--engine havok: no such engine", "ours, reference-euler"},
      {{"--engine", "bulet"},
       "--engine bulet: no such engine; did you mean bullet? allowed: ",
       "ours"},
      {{"--instructions", "mmx"}, "--instructions mmx: ", "baseline, avx2, avx512"},
      {{"--threads", "65"}, "--Threads 65: out of range", "0 to 64"},
      {{"--threads", "two"}, "--Threads two: not a whole number", "0 to 64"},
      {{"--GraphicsCores", "first"}, "--GraphicsCores first: not a whole number", "0,2-5"},
      {{"--GraphicsCores", "0,"}, "--GraphicsCores 0,: the value is missing", "0,2-5"},
      {{"--NetworkCores", "3-1"}, "--NetworkCores 3-1: 3-1 runs backwards", "0,2-5"},
      {{"--SimulationCores", "1023"}, "SimulationCores=1023: this machine has no core", "0"},
      {{"--dt", "0"}, "--Dt 0: out of range", "in s"},
      {{"--integrator", "magic"}, "--Integrator magic: no such integrator", "leapfrog"},
      {{"--peer-id", "0"}, "--PeerID 0: out of range", "1 to 255"},
      {{"--PeerID", "1", "--peer-id", "2"}, "--PeerID 2: PeerID is already given", "once"},
      {{"--lcm-url", "tcp://here"}, "--lcm-url tcp://here: ", "udpm"},
      {{"--solo", "--require-lcm"}, "--solo and --require-lcm", "one of them"},
      {{"--solo", "--lcm-url", "udpm://239.255.76.67:9171?ttl=0"},
       "--solo and --lcm-url",
       "one of them"},
      {{"--solo", "--target-error", "1e-12"}, "--target-error 1e-12: out of range", "1e-11 to 1"},
      {{"--solo", "--target-error", "small"}, "--target-error small: not a number", "in m"},
      {{"--target-error", "1e-6"}, "--target-error: all peers of a session", "with --solo"},
      {{"--solo", "--target-error", "1e-6", "--steps", "5"},
       "--target-error and --steps",
       "--duration"},
      {{"--solo", "--target-error", "1e-6", "--engine", "bullet"},
       "--target-error: chooses for ours, not for bullet",
       "--engine ours"},
      {{"--frames", "/absent/folder/frames"}, "--frames /absent/folder/frames", "folder"},
      {{"--video", "/absent/a.mp4"}, "--video /absent/a.mp4", "a file in a folder that exists"},
      {{"--last-frame", "/absent/a.png"}, "--last-frame /absent/a.png", "a file in a folder"},
      {{"--state-out", "/absent/a.csv"}, "--state-out /absent/a.csv", "a file in a folder"},
      {{"--report", "/tmp"}, "--report /tmp", "a file in a folder"},
      {{"--numofballs", "5"},
       "--numofballs: no such option; did you mean --NumOfBalls? allowed: ",
       "--help"},
      {{"--Elastisity=0.5"},
       "--Elastisity=0.5: no such option; did you mean --Elasticity?",
       "--help"},
      {{"stray"}, "stray: no such option", "--help"},
  };
  for (const BadOption& bad : cases) {
    const std::string error = errorOf(bad.arguments);
    EXPECT_NE(error.find(bad.thing), std::string::npos) << bad.thing << " -> " << error;
    EXPECT_NE(error.find("allowed"), std::string::npos) << error;
    EXPECT_NE(error.find(bad.allowed), std::string::npos) << bad.allowed << " -> " << error;
  }
}

TEST(PeerOptions, AFramesFolderMayBeNew) {
  const TemporaryFolder folder;
  EXPECT_EQ(errorOf({"--frames", (folder / "new").string()}), "accepted");
  EXPECT_FALSE(std::filesystem::exists(folder / "new")) << "parsing makes nothing";
}

}  // namespace
}  // namespace wells
