#include "keys.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "cores.h"
#include "key_kinds.h"
#include "math/ids.h"
#include "special_keys.h"
#include "threads/thread_pool.h"

namespace wells {
namespace {

// Accessor for key_kinds.h.
#define WELLS_FIELD(member)   \
  [](auto& config) -> auto& { \
    return config.member;     \
  }

void addGroup(std::vector<Key>& table, const std::string& group, Scope scope,
              std::vector<Key> keysOfGroup) {
  for (Key& key : keysOfGroup) {
    key.group = group;
    key.scope = scope;
    table.push_back(std::move(key));
  }
}

std::vector<Key> makeKeys() {
  std::vector<Key> table;
  const Range kLength = Range::above(0, kLargestLength);
  addGroup(
      table, "World (the same for all peers of a session)", Scope::World,
      {numberKey("SurfaceRadius", "m", WELLS_FIELD(arena.radius), kLength,
                 "radius of the circular wall; more than every ball's"),
       arenaCenterKey(),
       integerKey("NumOfBalls", WELLS_FIELD(ballCount), 0, 1'000'000,
                  "balls, spread at rest just above the ground, without overlap, by Seed"),
       numberKey("BallRadius", "m", WELLS_FIELD(ballRadius), kLength, "radius of every ball"),
       numberKey("BallMass", "kg", WELLS_FIELD(ballMass), Range::above(0, 1e12),
                 "mass of every ball"),
       integerKey("Seed", WELLS_FIELD(seed), 0, std::numeric_limits<std::int64_t>::max(),
                  "chooses the places of the balls"),
       ballsFileKey(),
       numberKey("Elasticity", "", WELLS_FIELD(settings.elasticity), Range::between(0, 1),
                 "coefficient of restitution"),
       numberKey("Friction", "", WELLS_FIELD(settings.friction), Range::between(0, 1000),
                 "Coulomb's coefficient; in the reference engines the viscous factor of rolling"),
       numberKey("RollingResistance", "m", WELLS_FIELD(settings.rollingResistance),
                 Range::between(0, kLargestLength),
                 "lever arm of rolling resistance: a torque of so much times the normal force of a "
                 "contact; 0 for none. Not in the reference engines"),
       numberKey("Gravity", "m/s^2", WELLS_FIELD(settings.gravity.y()), Range::between(-1e6, 1e6),
                 "vertical, up is positive; 0 for none"),
       numberKey("Drag", "", WELLS_FIELD(settings.drag), Range::above(0, 1),
                 "factor by which drag changes a velocity in a second; 1 for no drag"),
       wellKey(),
       numberKey(
           "TimeScale", "", WELLS_FIELD(timeScale), Range::above(0, 1000),
           "simulated seconds in a wall second: changes how many steps a second are made, not "
           "Dt; the reference engines make longer steps instead, Dt x TimeScale")});
  addGroup(
      table, "Method (the same for all peers of a session)", Scope::World,
      {numberKey("Dt", "s", WELLS_FIELD(settings.dt), Range::between(1e-6, 1), "length of a step"),
       integratorKey(), contactMethodKey(),
       integerKey("Substeps", WELLS_FIELD(settings.substeps), 1, 1000,
                  "substeps of a step, where balls may touch something"),
       integerKey("Iterations", WELLS_FIELD(settings.iterations), 1, 10'000,
                  "passes of the contact solver in a substep"),
       integerKey("MostImpacts", WELLS_FIELD(settings.mostImpacts), 1, 1'000'000'000,
                  "elastic impacts among balls that may meet in one step; with more, "
                  "ContactMethod exact stops and auto leaves them to the substeps"),
       numberKey("SleepSpeed", "m/s", WELLS_FIELD(settings.sleepSpeed), Range::between(0, 1),
                 "balls in lasting contacts that are slower rest, and islands at rest sleep until "
                 "something wakes them; 0: none ever does")});
  addGroup(
      table, "This peer and its well", Scope::Peer,
      {integerKey(
           "PeerID", WELLS_FIELD(peerId), 1, kMaxPeerId,
           "unique in a session; from a file, a taken one is replaced by the lowest free one"),
       integerKey("UDPPort", WELLS_FIELD(udpPort), 1024, 65535, "port of the multicast group"),
       numberKey("Lease", "s", WELLS_FIELD(lease), Range::between(0.2, 60),
                 "silence after which a peer counts as gone and its balls are adopted"),
       optionalVectorKey("WellPosition", WELLS_FIELD(wellPosition), "x,y,z of this peer's well",
                         "at ball height on the circle of radius SurfaceRadius/2, at the angle of "
                         "PeerID (1, 2, 3, 4: 0, 180, 90, 270 degrees from +x towards +z)"),
       optionalNumberKey("WellStrength", "m^3/s^2", WELLS_FIELD(wellStrength), kStrength,
                         "strength of this peer's well; > 0 attracts, < 0 repels, 0 is off",
                         "pulls 9.81/8 m/s^2 at the distance SurfaceRadius/2"),
       numberKey("WellSoftening", "m", WELLS_FIELD(wellSoftening), kSoftening,
                 "softening of this peer's well"),
       wellPathKey()});
  addGroup(table, "Target rates of the three loops", Scope::Peer,
           {numberKey("SimulationRate", "Hz", WELLS_FIELD(simulationRate), Range::between(0, 1e6),
                      "steps in a wall second at TimeScale 1; 0: 1/Dt in a session, as fast as "
                      "possible alone"),
            numberKey("GraphicsRate", "Hz", WELLS_FIELD(graphicsRate), Range::between(1, 1000),
                      "frames in a simulated second"),
            numberKey("NetworkRate", "Hz", WELLS_FIELD(networkRate), Range::between(10, 1000),
                      "how often messages are sent")});
  addGroup(table, "Speed (changes no result; may differ from peer to peer)", Scope::Peer,
           {broadphaseKey()});
  addGroup(
      table, "Threads and cores", Scope::Peer,
      {integerKey("Threads", WELLS_FIELD(threads), 0, kMostThreads,
                  "threads of the simulation; 0: one for each of its cores, 8 at most. Worlds with "
                  "few balls awake use one; the result has the same bits for any number"),
       coresKey(
           "SimulationCores", &Config::simulationCores,
           "where the simulation runs; a list keeps it there, any leaves it to the system. "
           "auto, for all three: graphics on the first core, network on the second, simulation "
           "on the others, where at least two are left for it; else any"),
       coresKey("GraphicsCores", &Config::graphicsCores, "where pictures are drawn; likewise"),
       coresKey("NetworkCores", &Config::networkCores,
                "where messages are sent and received; likewise")});
  addGroup(
      table, "Picture", Scope::Peer,
      {booleanKey(
           "FullScreen", WELLS_FIELD(fullScreen),
           "accepted; frames have ScreenWidth x ScreenHeight either way, as there is no screen"),
       integerKey("ScreenWidth", WELLS_FIELD(screenWidth), 64, 4096, "width of a frame, pixels"),
       integerKey("ScreenHeight", WELLS_FIELD(screenHeight), 64, 4096, "height of a frame, pixels"),
       optionalVectorKey("CameraEye", WELLS_FIELD(cameraEye), "x,y,z of the camera",
                         "where the whole arena is seen"),
       optionalVectorKey("CameraTarget", WELLS_FIELD(cameraTarget),
                         "x,y,z of the point in the middle of the picture", "the arena's centre"),
       optionalNumberKey("CameraFieldOfView", "degrees", WELLS_FIELD(cameraFieldOfView),
                         Range::between(5, 120), "vertical angle of view",
                         "that of the view of the whole arena")});
  addGroup(
      table, "Old transport (accepted, not used)", Scope::Transport,
      {booleanKey("IsServer", WELLS_FIELD(isServer), "accepted, not used: no peer is a server"),
       integerKey("TCPPort", WELLS_FIELD(tcpPort), 1, 65535, "accepted, not used: there is no TCP"),
       hostIpKey()});
  return table;
}

#undef WELLS_FIELD

std::string escapedForTable(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\\');
  return text;
}

}  // namespace

std::string Key::defaultText() const {
  const auto values = get(Config{});
  return values.empty() ? absent : joined(values, " ");
}

std::span<const Key> keys() {
  static const std::vector<Key> table = makeKeys();
  return table;
}

const Key* findKey(std::string_view name) {
  const auto all = keys();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Key& k) { return k.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::string suggestKey(std::string_view name) {
  std::vector<std::string> names;
  for (const Key& key : keys()) names.push_back(key.name);
  const std::string nearest = nearestWord(name, names);
  return nearest.empty() ? "" : fmt::format("did you mean {}?", nearest);
}

std::string keysAsMarkdown() {
  std::string text;
  std::string_view group;
  for (const Key& key : keys()) {
    if (key.group != group) {
      text += fmt::format(
          "{}**{}**\n\n| key | default | unit | allowed | meaning |\n|---|---|---|---|---|\n",
          text.empty() ? "" : "\n", key.group);
      group = key.group;
    }
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", key.name, key.defaultText(), key.unit,
                        escapedForTable(key.allowed), escapedForTable(key.help));
  }
  return text;
}

}  // namespace wells
