#include "demo.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <thread>
#include <vector>

#include "child_process.h"
#include "command_line.h"
#include "demo_summary.h"
#include "errors.h"
#include "interrupt.h"
#include "network/multicast_check.h"
#include "text_file.h"
#include "values.h"

namespace wells {
namespace {

namespace fs = std::filesystem;

// The two wells go round in opposite directions on circles of different radius, so that the border
// between them sweeps over the arena and balls change hands.
constexpr const char* kWellPaths[] = {"circle,20,40", "circle,14,-30"};

// Two peers draw and encode without a GPU, on as few as two cores.
constexpr const char* kGraphicsRate = "20";  // Hz

struct DemoOptions {
  fs::path config = "config/template.txt";
  fs::path out = "out/demo";
  double duration = 10;  // s, simulated
  bool requireLcm = false;
};

struct DemoPeer {
  PeerFiles files;
  ChildProcess process;
};

bool parseDemoOptions(std::span<const std::string> arguments, DemoOptions& options) {
  CLI::App app(
      "Two peers on this machine share the template world for a while and say what they "
      "did.",
      "gravity-wells demo");
  addPath(app, "--config", options.config, "FILE", "the world of both peers")
      ->default_str(options.config.string());
  addPath(app, "--out", options.out, "FOLDER",
          "folder for videos, last frames and reports; made if absent")
      ->default_str(options.out.string());
  app.add_option_function<std::string>(
         "--duration",
         [&](const std::string& value) {
           const Range range = Range::above(0, 3600);
           parseOption("--duration", value, fmt::format("a number {}, in s", range.text()),
                       [&] { options.duration = parseNumber(value, range); });
         },
         "simulated time")
      ->type_name("s")
      ->default_str("10");
  app.add_flag("--require-lcm", options.requireLcm,
               "exit with status 1 where multicast does not pass, instead of running one peer");
  return parseArguments(app, arguments) == Parsed::Options;
}

// A port of its own keeps a demonstration on the host apart from sessions and other demonstrations.
LcmUrl demoUrl() {
  constexpr int kFirstPrivatePort = 49152;  // RFC 6335
  constexpr int kPrivatePorts = 16384;
  return parseLcmUrl(lcmUrl(kFirstPrivatePort + ::getpid() % kPrivatePorts, 0));
}

std::vector<std::string> peerArguments(const DemoOptions& options, const LcmUrl& url, int id,
                                       const PeerFiles& files) {
  std::vector<std::string> arguments = {"peer",
                                        "--config",
                                        options.config.string(),
                                        "--peer-id",
                                        fmt::format("{}", id),
                                        "--WellPath",
                                        kWellPaths[id - 1],
                                        "--duration",
                                        formatNumber(options.duration),
                                        "--GraphicsRate",
                                        kGraphicsRate,
                                        "--GraphicsCores",  // not one for the pictures of both
                                        "any",
                                        "--lcm-url",
                                        url.text(),
                                        "--video",
                                        files.video.string(),
                                        "--last-frame",
                                        files.lastFrame.string(),
                                        "--state-out",
                                        files.state.string(),
                                        "--report",
                                        files.report.string()};
  if (options.requireLcm) arguments.push_back("--require-lcm");
  return arguments;
}

std::string whatItSaid(const PeerFiles& files) {
  std::string text;
  for (const std::string& line : readLines(files.log)) text += line + '\n';
  return text;
}

void requireSuccess(DemoPeer& peer, int id) {
  const int status = *peer.process.poll();
  if (status == 0) return;
  throw RunError(fmt::format("peer {} ended with status {}; it said:\n{}", id, status,
                             whatItSaid(peer.files)));
}

// Waits for all, or until one has failed. Bounded: a peer that hangs is an error.
void waitForAll(std::vector<DemoPeer>& peers, double duration) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const double limit = 60 + 10 * duration;  // s: a tenth of real time is slow enough
  const bool isTerminal = ::isatty(STDERR_FILENO) != 0;
  bool told = false;
  for (std::size_t ended = 0; ended < peers.size();) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    ended = 0;
    for (std::size_t i = 0; i < peers.size(); ++i) {
      if (!peers[i].process.poll()) continue;
      requireSuccess(peers[i], static_cast<int>(i) + 1);
      ++ended;
    }
    if (interrupted() && !told) {
      for (const DemoPeer& peer : peers) peer.process.interrupt();
      told = true;
    }
    const double passed = std::chrono::duration<double>(Clock::now() - start).count();
    if (passed > limit)
      throw RunError(fmt::format("the peers did not end within {:.0f} s; see {}", limit,
                                 peers.front().files.log.string()));
    if (isTerminal) {
      fmt::print(stderr, "\r\033[Kthe peers find each other and run: {:.0f} of about {:.0f} s",
                 passed, duration + 6);
      std::fflush(stderr);
    }
  }
  if (isTerminal) fmt::print(stderr, "\r\033[K");
}

}  // namespace

int runDemo(std::span<const std::string> arguments) {
  DemoOptions options;
  if (!parseDemoOptions(arguments, options)) return 0;
  const LcmUrl url = demoUrl();
  const bool passes = checkMulticast(url).result == MulticastCheck::Result::Passes;
  const int count = passes || options.requireLcm ? 2 : 1;
  const fs::path& folder = options.out;
  makeFolder("--out", folder);

  catchInterrupts();
  std::vector<DemoPeer> peers;
  std::vector<PeerFiles> files;
  for (int id = 1; id <= count; ++id) {
    files.push_back(peerFiles(folder, id));
    peers.push_back({files.back(), ChildProcess(peerArguments(options, url, id, files.back()),
                                                files.back().log)});
  }
  waitForAll(peers, options.duration);
  if (!passes) fmt::print("{}\n", whatItSaid(files.front()));
  fmt::print("{}", demoSummary(files));
  return 0;
}

}  // namespace wells
