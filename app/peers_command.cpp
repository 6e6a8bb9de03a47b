#include "peers_command.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <thread>

#include "clocks.h"
#include "command_line.h"
#include "errors.h"
#include "host_name.h"
#include "network/lcm_transport.h"
#include "probe_table.h"
#include "progress.h"
#include "random_number.h"
#include "session_url.h"

namespace wells {
namespace {

// Sending waits for a tick, and what has come for a poll: both lengthen a round trip.
constexpr double kSendingRate = 1000;  // Hz
constexpr std::chrono::milliseconds kPollInterval{1};

struct PeersOptions {
  std::string url;
  double seconds = 5;  // s
};

std::optional<PeersOptions> parse(std::span<const std::string> arguments) {
  PeersOptions options;
  CLI::App app(
      "Tells whether multicast passes between machines: start it on each at the same time. Each "
      "sends ten small messages a second, for some seconds, and shows whom it heard and who heard "
      "it. Peers of a running session are noticed too. Exit status 0: somebody else was heard and "
      "hears us; 1: nobody.",
      "gravity-wells peers");
  addSessionUrl(app, options.url);
  addSeconds(app, "--seconds", options.seconds, 1, 3600, "how long to listen");
  if (parseArguments(app, arguments) == Parsed::HelpShown) return std::nullopt;
  return options;
}

}  // namespace

int runPeers(std::span<const std::string> arguments) {
  const auto options = parse(arguments);
  if (!options) return 0;
  const LcmUrl url = parseLcmUrl(options->url);
  LcmTransport transport(options->url, kSendingRate);
  ProbeRound round(transport, hostName(), randomNumber());
  {
    const StatusLine status;
    const double end = readClocks().monotonic + options->seconds;
    double nextStatus = 0;
    for (Times now = readClocks(); now.monotonic < end; now = readClocks()) {
      round.tick(now);
      if (now.monotonic >= nextStatus) {
        nextStatus = now.monotonic + 0.5;
        status.show(fmt::format("listens for {:.0f} s more", end - now.monotonic));
      }
      std::this_thread::sleep_for(kPollInterval);
    }
  }
  fmt::print("{}", probeReport({url, multicastRoute(url), hostName(), options->seconds}, round));
  return passesBothWays(round) ? 0 : kExitFailure;
}

}  // namespace wells
