// Gravity Wells: the command line's first word and the exit status.

#include <fmt/format.h>
#include <malloc.h>

#include <cstdio>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "bench.h"
#include "demo.h"
#include "engines.h"
#include "errors.h"
#include "keys.h"
#include "peer.h"
#include "peer_options.h"
#include "peers_command.h"
#include "set_command.h"
#include "spy.h"

namespace wells {
namespace {

constexpr const char* kUsage =
    "usage: gravity-wells peer [OPTION...]    one peer of a session, or a world alone (--solo)\n"
    "       gravity-wells demo [OPTION...]    two peers on this machine share a world\n"
    "       gravity-wells bench [OPTION...]   one scene, measured\n"
    "       gravity-wells spy --text          a live table of a session\n"
    "       gravity-wells peers [OPTION...]   does multicast pass between machines?\n"
    "       gravity-wells set KEY=VALUE...    changes a live session\n"
    "       gravity-wells keys                the config keys as a Markdown table\n"
    "Each takes --help.\n";

int peer(const std::vector<std::string>& arguments, char** argv) {
  auto options = parsePeerOptions(arguments);
  if (!options) return 0;
  becomeExecutableOf(options->engine, argv);
  return runPeer(std::move(*options));
}

int run(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const std::string command = words.empty() ? "" : words.front();
  const std::vector<std::string> arguments(words.begin() + (words.empty() ? 0 : 1), words.end());
  if (command == "peer") return peer(arguments, argv);
  if (command == "bench") return runBench(arguments, argv);
  if (command == "demo") return runDemo(arguments);
  if (command == "spy") return runSpy(arguments);
  if (command == "set") return runSet(arguments);
  if (command == "peers") return runPeers(arguments);
  if (command == "keys") {
    fmt::print("{}", keysAsMarkdown());
    return 0;
  }
  if (command == "help" || command == "--help" || command == "-h") {
    fmt::print("{}", kUsage);
    return 0;
  }
  throw UsageError(fmt::format("{}; allowed: peer, demo, bench, spy, peers, set, keys, help",
                               command.empty() ? "no command" : command + ": no such command"));
}

}  // namespace
}  // namespace wells

int main(int argc, char** argv) {
  // Arrays of large worlds grow. What they leave goes back to the system at once; else the C
  // library would begin to keep it, in holes that nothing fits: a third of the memory of 100,000
  // balls in heaps.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  try {
    return wells::run(argc, argv);
  } catch (const wells::UsageError& error) {
    fmt::print(stderr, "gravity-wells: {}\n", error.what());
    return wells::kExitUsage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "gravity-wells: {}\n", error.what());
    return wells::kExitFailure;
  }
}
