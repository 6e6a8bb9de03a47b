// The ready-made worlds of config/.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "config_file.h"
#include "text_file.h"
#include "well_motion.h"
#include "world/measures.h"
#include "world/simulation.h"
#include "world_setup.h"

namespace wells {
namespace {

const std::filesystem::path kFolder = WELLS_SOURCE_DIR "/config";

std::vector<std::filesystem::path> worldFiles() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder))
    if (entry.path().extension() == ".txt") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

Config load(const std::filesystem::path& file) {
  Config config;
  applySettings(config, readConfigFile(file));
  return config;
}

class ReadyMadeWorld : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(ReadyMadeWorld, LoadsAndSteps) {
  const Config config = load(GetParam());
  World world = makeWorld(config, "ours");
  const WellMotion motion(config, world.settings.dt);
  const PeerId peer{static_cast<std::int32_t>(config.peerId)};
  world.tracks.push_back(motion.trackAt(peer, world.step));
  ASSERT_GT(world.balls.size(), 0u);
  // Balls of a lattice may start in touch, never in each other.
  EXPECT_LE(measure(world).worstOverlap(), 1e-9);
  const auto simulation = makeSimulation();
  for (int i = 0; i < 30; ++i) {
    motion.extend(world.tracks.back(), world.step);
    simulation->step(world);
  }
  EXPECT_EQ(world.step, 30);
  EXPECT_EQ(measure(world).escaped, 0);
}

TEST_P(ReadyMadeWorld, SaysWhatToLookAt) {
  const std::string first = readLines(GetParam()).at(0);
  if (GetParam().filename() == "template.txt")
    EXPECT_EQ(first, "//Config File");
  else
    EXPECT_TRUE(first.starts_with("// Look at ")) << first;
}

INSTANTIATE_TEST_SUITE_P(Config, ReadyMadeWorld, testing::ValuesIn(worldFiles()),
                         [](const auto& param) {
                           std::string name = param.param.stem().string();
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(FourPeers, ShareOneWorldAndDifferInIdAndPath) {
  std::set<std::string> canonical;
  std::set<std::int64_t> ids;
  for (int i = 1; i <= 4; ++i) {
    const Config config = load(kFolder / ("peer-" + std::to_string(i) + ".txt"));
    canonical.insert(canonicalConfig(config, "ours", {}));
    ids.insert(config.peerId);
  }
  EXPECT_EQ(canonical.size(), 1u);
  EXPECT_EQ(ids, (std::set<std::int64_t>{1, 2, 3, 4}));
}

}  // namespace
}  // namespace wells
