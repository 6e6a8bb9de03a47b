#include <gtest/gtest.h>

#include <set>

#include "config_file.h"
#include "errors.h"
#include "keys.h"
#include "temporary_folder.h"
#include "text_file.h"
#include "values.h"
#include "world_setup.h"

namespace wells {
namespace {

const std::filesystem::path kConfigFolder = WELLS_SOURCE_DIR "/config";

Config load(const std::filesystem::path& file) {
  Config config;
  applySettings(config, readConfigFile(file));
  return config;
}

std::string errorOf(const std::filesystem::path& file) {
  try {
    load(file);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Template, LoadsUnchanged) {
  Config config;
  const auto notices = applySettings(config, readConfigFile(kConfigFolder / "template.txt"));
  EXPECT_FALSE(config.fullScreen);
  EXPECT_EQ(config.screenWidth, 1024);
  EXPECT_EQ(config.screenHeight, 768);
  EXPECT_EQ(config.arena.radius, 40);
  EXPECT_EQ(config.ballCount, 25);
  EXPECT_EQ(config.ballRadius, 0.5);
  EXPECT_EQ(config.settings.elasticity, 0.8);
  EXPECT_EQ(config.settings.friction, 0.995);
  EXPECT_EQ(config.peerId, 1);
  EXPECT_EQ(config.udpPort, 9171);
  ASSERT_EQ(notices.size(), 1u);
  EXPECT_EQ(notices[0],
            "IsServer, TCPPort, HostIP: accepted, not used (peers find each other by multicast)");
}

// The text of the 2017 report, line for line.
TEST(Template, IsTheReportsText) {
  const std::vector<std::string> expected = {
      "//Config File",    "FullScreen=false",     "ScreenWidth=1024",
      "ScreenHeight=768", "SurfaceRadius=40.f",   "NumOfBalls=25",
      "BallRadius=0.5",   "Elasticity=0.8",       "Friction=0.995",
      "PeerID=1",         "IsServer=F",           "UDPPort=9171",
      "TCPPort=9172",     "HostIP=150.237.93.182"};
  EXPECT_EQ(readLines(kConfigFolder / "template.txt"), expected);
}

TEST(ConfigFile, TakesCommentsBlanksAndWindowsEnds) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.txt",
                                 "\xEF\xBB\xBF// look\r\n\r\n  NumOfBalls = 7  // seven\r\n"
                                 "Well=1,2,3,4,5\r\nWell=-1,2,3,-4,5\r\nSurfaceRadius=12.5f\r\n");
  const Config config = load(file);
  EXPECT_EQ(config.ballCount, 7);
  EXPECT_EQ(config.arena.radius, 12.5);
  ASSERT_EQ(config.wells.size(), 2u);
  EXPECT_EQ(config.wells[1].strength, -4);
}

TEST(ConfigFile, FileNamesAreRelativeToIt) {
  const TemporaryFolder folder;
  const Config config = load(folder.write("a.txt", "BallsFile=b.csv\nWellPath=path.csv\n"));
  EXPECT_EQ(config.ballsFile, folder / "b.csv");
  EXPECT_EQ(config.wellPath.file, folder / "path.csv");
}

TEST(ConfigFile, CommandLineOverridesFile) {
  Config config;
  const std::vector<Setting> file = {{"NumOfBalls", "7", "f.txt", 1},
                                     {"Well", "1,2,3,4,5", "f.txt", 2}};
  const std::vector<Setting> line = {{"NumOfBalls", "9", {}, 0}, {"Well", "0,0,0,1,2", {}, 0}};
  applySettings(config, file);
  applySettings(config, line);
  EXPECT_EQ(config.ballCount, 9);
  ASSERT_EQ(config.wells.size(), 1u) << "wells of the command line replace the file's";
  EXPECT_EQ(config.wells[0].position, Vec3(0, 0, 0));
}

struct BadLine {
  const char* line;
  const char* why;
};

// Every message: file, line, key, value, why, and what is allowed.
TEST(ConfigFile, RefusesEveryBadValue) {
  const BadLine cases[] = {
      {"SurfaceRadius=0", "out of range"},
      {"SurfaceRadius=40 m", "carries no unit"},
      {"SurfaceRadius=", "missing"},
      {"ArenaCenter=1,2", "2 number(s) instead of 3"},
      {"ArenaCenter=1,2,1e7", "out of range"},
      {"NumOfBalls=2.5", "not a whole number"},
      {"NumOfBalls=-1", "out of range"},
      {"BallRadius=-0.5", "out of range"},
      {"BallRadius=nan", "not a finite number"},
      {"BallMass=0", "out of range"},
      {"BallMass=1kg", "carries no unit"},
      {"Seed=-1", "out of range"},
      {"BallsFile=", "missing"},
      {"Elasticity=1.5", "out of range"},
      {"Friction=-0.1", "out of range"},
      {"RollingResistance=-0.001", "out of range"},
      {"RollingResistance=inf", "not a finite number"},
      {"Gravity=down", "not a number"},
      {"Drag=0", "out of range"},
      {"Drag=1.1", "out of range"},
      {"Well=0,1,0,100", "4 number(s) instead of 5"},
      {"Well=0,1,0,100,0", "softening out of range"},
      {"Well=0,1,0,1e16,2", "strength out of range"},
      {"Well=0,1,zero,100,2", "z=zero: not a number"},
      {"TimeScale=0", "out of range"},
      {"Dt=0", "out of range"},
      {"Dt=2", "out of range"},
      {"Integrator=magic", "no such integrator"},
      {"ContactMethod=magic", "no such contact method"},
      {"Substeps=0", "out of range"},
      {"Iterations=0", "out of range"},
      {"MostImpacts=0", "out of range"},
      {"SleepSpeed=-1e-9", "out of range"},
      {"Broadphase=sweep", "no such broadphase"},
      {"PeerID=0", "out of range"},
      {"PeerID=256", "out of range"},
      {"UDPPort=80", "out of range"},
      {"UDPPort=70000", "out of range"},
      {"Lease=0", "out of range"},
      {"WellPosition=1,2,3,4", "4 number(s) instead of 3"},
      {"WellStrength=strong", "not a number"},
      {"WellSoftening=0", "out of range"},
      {"WellPath=circle,5", "1 number(s) instead of 2"},
      {"WellPath=circle,5,0", "period out of range"},
      {"WellPath=circle,-5,10", "radius out of range"},
      {"SimulationRate=-1", "out of range"},
      {"GraphicsRate=0", "out of range"},
      {"NetworkRate=0", "out of range"},
      {"Threads=65", "out of range"},
      {"SimulationCores=0-", "missing"},
      {"GraphicsCores=5-2", "5-2 runs backwards"},
      {"NetworkCores=second", "not a whole number"},
      {"FullScreen=maybe", "neither true nor false"},
      {"ScreenWidth=10", "out of range"},
      {"ScreenHeight=1e3", "not a whole number"},
      {"CameraEye=here", "1 number(s) instead of 3"},
      {"CameraTarget=0,0", "2 number(s) instead of 3"},
      {"CameraFieldOfView=180", "out of range"},
      {"IsServer=perhaps", "neither true nor false"},
      {"TCPPort=0", "out of range"},
  };
  const TemporaryFolder folder;
  std::set<std::string> tried;
  for (const BadLine& bad : cases) {
    const auto file = folder.write("a.txt", std::string("// look\n") + bad.line + "\n");
    const std::string line = bad.line;
    const std::string name = line.substr(0, line.find('='));
    const std::string error = errorOf(file);
    tried.insert(name);
    EXPECT_EQ(error.find(file.string() + ":2: " + line + ": "), 0u) << error;
    EXPECT_NE(error.find(bad.why), std::string::npos) << line << " -> " << error;
    ASSERT_NE(findKey(name), nullptr) << name;
    EXPECT_NE(error.find("; allowed: " + findKey(name)->allowed), std::string::npos) << error;
  }
  tried.insert("HostIP");  // takes any text
  for (const Key& key : keys())
    EXPECT_TRUE(tried.contains(key.name)) << key.name << " has no bad value in this table";
}

TEST(ConfigFile, RefusesUnknownKeysAndNamesTheNearest) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.txt", "Elastisity=0.5\n");
  EXPECT_NE(
      errorOf(file).find(file.string() + ":1: Elastisity=0.5: no such key: Elastisity; did you "
                                         "mean Elasticity?"),
      std::string::npos)
      << errorOf(file);
  EXPECT_NE(errorOf(folder.write("a.txt", "numofballs=3")).find("did you mean NumOfBalls?"),
            std::string::npos);
}

TEST(ConfigFile, RefusesRepeatedKeysNamingBothLines) {
  const TemporaryFolder folder;
  const auto file = folder.write("a.txt", "PeerID=1\n\nPeerID=2\n");
  const std::string error = errorOf(file);
  EXPECT_NE(error.find(":3: PeerID=2: PeerID is already given in line 1"), std::string::npos)
      << error;
}

TEST(ConfigFile, RefusesLinesThatAreNoSettings) {
  const TemporaryFolder folder;
  EXPECT_NE(
      errorOf(folder.write("a.txt", "// a\nhello\n")).find("a.txt:2: \"hello\" is no setting"),
      std::string::npos);
  EXPECT_NE(errorOf(folder.write("a.txt", "=5\n")).find("allowed: KEY=VALUE"), std::string::npos);
  EXPECT_NE(errorOf(folder / "absent.txt").find("absent.txt: cannot be read"), std::string::npos);
}

TEST(Keys, AreUniqueAndComplete) {
  std::set<std::string> names;
  for (const Key& key : keys()) {
    EXPECT_TRUE(names.insert(key.name).second) << key.name;
    EXPECT_FALSE(key.allowed.empty()) << key.name;
    EXPECT_FALSE(key.help.empty()) << key.name;
    const bool hasParts = key.name == "Well" || key.name == "WellPath";  // each with its unit
    EXPECT_TRUE(hasParts || key.allowed.ends_with(key.unit)) << key.name << " hides its unit";
    EXPECT_FALSE(key.defaultText().empty()) << key.name;
  }
}

// Whatever a key says about a config, it takes: so canonical text means what it says.
TEST(Keys, TakeTheirOwnDefaults) {
  for (const Key& key : keys()) {
    Config config;
    const auto before = key.get(config);
    if (key.repeat == Key::Repeat::Yes) continue;
    for (const std::string& value : before) key.set(config, value, {});
    EXPECT_EQ(key.get(config), before) << key.name;
  }
}

TEST(CanonicalConfig, ListsWhatDiffersFromTheDefaultInTableOrder) {
  Config config;
  config.ballCount = 3;
  config.settings.gravity.y() = 0;
  config.wells = {{.position = {1, 2, 3}, .strength = 4, .softening = 5}};
  config.peerId = 7;  // each peer's own, as are its threads
  config.threads = 2;
  config.graphicsCores = {.kind = CoreChoice::Kind::Any};
  const World world = makeWorld(config, "ours");
  EXPECT_EQ(canonicalConfig(config, "ours", world.balls),
            "NumOfBalls=3\nGravity=0\nWell=1,2,3,4,5\n");
  EXPECT_EQ(canonicalConfig(config, "bullet", world.balls),
            "NumOfBalls=3\nGravity=0\nWell=1,2,3,4,5\nengine=bullet\n");
}

TEST(CanonicalConfig, StaysWithinItsLimitWithManyWells) {
  Config config;
  config.ballCount = 1;
  for (int i = 0; i < 100; ++i)
    config.wells.push_back(
        {.position = {0.1 * i, 1.0 / 3, 0}, .strength = 1.0 / 7, .softening = 2});
  const Balls balls = makeWorld(config, "ours").balls;
  const std::string text = canonicalConfig(config, "ours", balls);
  EXPECT_LE(text.size(), kCanonicalLimit);
  config.wells[50].strength += 1e-12;
  EXPECT_NE(canonicalConfig(config, "ours", balls), text) << "every well counts";
}

TEST(CanonicalConfig, CountsABallsFileByItsContent) {
  const TemporaryFolder folder;
  const std::string header = "id,x,y,z,vx,vy,vz,wx,wy,wz,radius,mass\n";
  Config a, b;
  a.ballsFile = folder.write("a.csv", header + "0,1,2,3,0,0,0,0,0,0,0.5,1\n");
  b.ballsFile = folder.write("b.csv", header + "0,1,2,3,0,0,0,0,0,0,0.5,1\n");
  const auto text = [](const Config& c) {
    return canonicalConfig(c, "ours", makeWorld(c, "ours").balls);
  };
  EXPECT_EQ(text(a), text(b));
  folder.write("b.csv", header + "0,1,2,3,0,0,0,0,0,0,0.5,1.0000000001\n");
  EXPECT_NE(text(a), text(b));
}

TEST(World, ReferenceEnginesStretchTheirStep) {
  Config config;
  config.timeScale = 2;
  config.settings.dt = 0.01;
  EXPECT_EQ(makeWorld(config, "ours").settings.dt, 0.01);
  EXPECT_EQ(makeWorld(config, "reference-rk").settings.dt, 0.02);
  EXPECT_DOUBLE_EQ(stepRate(config, "ours"), 200);
  EXPECT_DOUBLE_EQ(stepRate(config, "reference-rk"), 100);
}

TEST(World, RefusesBallsThatDoNotFit) {
  Config config;
  config.ballRadius = 50;
  EXPECT_THROW(makeWorld(config, "ours"), UsageError);
  config.ballRadius = 0.001;  // a grain of sand on a plaza does fit
  EXPECT_EQ(makeWorld(config, "ours").balls.size(), 25u);
}

}  // namespace
}  // namespace wells
