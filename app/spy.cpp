#include "spy.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <optional>
#include <thread>

#include "clocks.h"
#include "command_line.h"
#include "errors.h"
#include "interrupt.h"
#include "network/lcm_transport.h"
#include "session_url.h"
#include "spy_table.h"

namespace wells {
namespace {

constexpr double kSendingRate = 10;  // Hz; nothing is sent
constexpr std::chrono::milliseconds kPollInterval{20};

struct SpyOptions {
  std::string url;
  bool text = false;
  double interval = 1;  // s
  std::int64_t tables = std::numeric_limits<std::int64_t>::max();
};

// Terminal or not, one table after the other.
class Screen {
 public:
  /// False when nobody can see it any more.
  bool show(const std::string& table) {
    const std::string text = rows() > 0 ? redrawn(table) : (isFirst_ ? "" : "\n") + table;
    isFirst_ = false;
    return std::fputs(text.c_str(), stdout) >= 0 && std::fflush(stdout) == 0;
  }

 private:
  // Of the terminal; 0: there is none.
  static int rows() {
    constexpr int kUsual = 24;  // of a terminal that does not tell
    winsize size{};
    if (::isatty(STDOUT_FILENO) == 0) return 0;
    return ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0 ? size.ws_row : kUsual;
  }

  // Over the table before, without flicker; what does not fit is cut off.
  std::string redrawn(const std::string& table) const {
    constexpr const char* kClearScreen = "\033[2J";
    constexpr const char* kHome = "\033[H";
    constexpr const char* kClearRestOfLine = "\033[K";
    constexpr const char* kClearBelow = "\033[J";
    std::string text = isFirst_ ? kClearScreen : "";
    text += kHome;
    int row = 1;
    for (const char c : table) {
      if (c == '\n' && ++row >= rows()) {
        text += kClearRestOfLine;
        break;
      }
      text += c == '\n' ? kClearRestOfLine + std::string("\n") : std::string(1, c);
    }
    return text + '\n' + kClearBelow;
  }

  bool isFirst_ = true;
};

std::optional<SpyOptions> parse(std::span<const std::string> arguments) {
  SpyOptions options;
  CLI::App app(
      "Shows the peers of a session as a table that is renewed each second, until Ctrl-C. It only "
      "listens. Lease, clock and steps behind are the worst that other peers say of one; behind "
      "and "
      "clock are positive for a peer that is behind, and for a clock that is ahead. Where the "
      "output is no terminal, one table follows the other. Exit status 1: no peer was heard.",
      "gravity-wells spy --text");
  app.add_flag("--text", options.text, "as text; the windows of lcm-spy come by ./run.sh spy");
  addSessionUrl(app, options.url);
  addSeconds(app, "--interval", options.interval, 0.1, 3600, "between two tables");
  addInteger(app, "--count", options.tables, 1, 1'000'000'000, "tables after which to end");
  if (parseArguments(app, arguments) == Parsed::HelpShown) return std::nullopt;
  if (!options.text)
    throw UsageError("spy: --text is missing; allowed: spy --text (./run.sh spy opens lcm-spy)");
  return options;
}

}  // namespace

int runSpy(std::span<const std::string> arguments) {
  const auto options = parse(arguments);
  if (!options) return 0;
  catchInterrupts();
  LcmTransport transport(options->url, kSendingRate);
  SessionWatch watch;
  Screen screen;
  const double start = readClocks().monotonic;
  double next = start;
  for (std::int64_t shown = 0; shown < options->tables; ++shown) {
    next += options->interval;
    while (readClocks().monotonic < next && !interrupted()) {
      std::this_thread::sleep_for(kPollInterval);
      transport.poll([&](std::string_view channel, std::span<const std::byte> bytes) {
        watch.hear(channel, bytes, readClocks());
      });
    }
    if (interrupted()) break;
    const double now = readClocks().monotonic;
    watch.forget(now);
    const double quiet = now - watch.lastHeard().value_or(start);
    if (!screen.show(spyTable(watch.sessions(), now, quiet))) break;
  }
  return watch.lastHeard() ? 0 : kExitFailure;
}

}  // namespace wells
