// What a peer is told: the world that it takes part in, and how it takes part. Values and defaults
// only; keys.h names, parses and documents each of them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "state/arena.h"
#include "state/settings.h"
#include "state/wells.h"

namespace wells {

/// How this peer's well moves.
struct WellPath {
  enum class Kind { Still, Circle, Keyframes };
  Kind kind = Kind::Still;
  double radius = 0;             // m, of the circle
  double period = 0;             // s a turn, not 0; > 0 goes from +x towards +z
  std::filesystem::path file{};  // of the keyframes
};

/// Where a loop's threads run.
struct CoreChoice {
  enum class Kind { Auto, Any, Listed };
  Kind kind = Kind::Auto;
  std::vector<int> listed{};  // rising
};

struct Config {
  // The world: the same for all peers of a session.
  Arena arena;
  Settings settings;
  std::int64_t ballCount = 25;
  double ballRadius = 0.5;  // m
  double ballMass = 1;      // kg
  std::uint64_t seed = 1;
  std::filesystem::path ballsFile;  // empty: balls are spread by seed
  std::vector<Well> wells;          // fixed ones
  double timeScale = 1;             // simulated seconds in a wall second

  // This peer and its well.
  std::int64_t peerId = 1;
  std::int64_t udpPort = 9171;
  double lease = 2;                    // s of silence after which a peer counts as gone
  std::optional<Vec3> wellPosition;    // m; default: scenes/own_well.h
  std::optional<double> wellStrength;  // m^3/s^2; default: scenes/own_well.h
  double wellSoftening = 2;            // m
  WellPath wellPath;

  // Target rates, Hz.
  double simulationRate = 0;  // 0: 1/dt in a session, as fast as possible alone
  double graphicsRate = 30;
  double networkRate = 100;

  // Threads and cores.
  std::int64_t threads = 0;  // of the simulation; 0: as many as sensible
  CoreChoice simulationCores;
  CoreChoice graphicsCores;
  CoreChoice networkCores;

  // Picture.
  bool fullScreen = false;
  std::int64_t screenWidth = 1024;
  std::int64_t screenHeight = 768;
  std::optional<Vec3> cameraEye;            // m; default: the whole arena is seen
  std::optional<Vec3> cameraTarget;         // m; default: the arena's centre
  std::optional<double> cameraFieldOfView;  // degrees, vertical; default: the arena's view's

  // The old transport: read and otherwise unused.
  bool isServer = false;
  std::int64_t tcpPort = 9172;
  std::string hostIp;
};

}  // namespace wells
