#include "set_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>
#include <vector>

#include "clocks.h"
#include "command_line.h"
#include "errors.h"
#include "host_name.h"
#include "network/lcm_transport.h"
#include "random_number.h"
#include "session_url.h"
#include "settable_keys.h"
#include "setter.h"
#include "setting_list.h"
#include "values.h"

namespace wells {
namespace {

constexpr double kSendingRate = 100;  // Hz
constexpr std::chrono::milliseconds kPollInterval{5};

struct SetOptions {
  std::string url;
  bool list = false;
  std::vector<WantedSetting> wanted;
};

WantedSetting parseSetting(const std::string& word) {
  const auto equals = word.find('=');
  const std::string key(trimmed(word.substr(0, equals)));
  if (equals == std::string::npos)
    throw UsageError(fmt::format("{}: no value; allowed: KEY=VALUE, as in Gravity=off", word));
  WantedSetting wanted{key, std::string(trimmed(word.substr(equals + 1)))};
  const std::string fault = settingFault(wanted.key, wanted.value);
  if (!fault.empty()) throw UsageError(fault);
  return wanted;
}

void addSetting(std::vector<WantedSetting>& settings, const std::string& word) {
  WantedSetting wanted = parseSetting(word);
  if (std::ranges::count(settings, wanted.key, &WantedSetting::key) > 0)
    throw UsageError(fmt::format("{}: {} stands twice; allowed: each key once", word, wanted.key));
  settings.push_back(std::move(wanted));
}

std::optional<SetOptions> parse(std::span<const std::string> arguments) {
  SetOptions options;
  CLI::App app(
      "Changes a live session, from any machine of its group: KEY=VALUE ... holds for all peers, "
      "from half a second later on, and for those who join later. Exit status 1: there is no "
      "session, or not every peer has confirmed.",
      "gravity-wells set");
  addSessionUrl(app, options.url);
  app.add_flag("--list", options.list, "only shows what is in force and who set it");
  app.add_option_function<std::vector<std::string>>(
      "KEY=VALUE",
      [&](const std::vector<std::string>& words) {
        for (const std::string& word : words) addSetting(options.wanted, word);
      },
      "what to change");
  app.footer("KEY and what it may be (N: the number of a peer):\n" + settableKeysText());
  if (parseArguments(app, arguments) == Parsed::HelpShown) return std::nullopt;
  if (options.list && !options.wanted.empty())
    throw UsageError("--list and KEY=VALUE: contradict each other; allowed: one of them");
  if (!options.list && options.wanted.empty())
    throw UsageError("set: nothing to set; allowed: KEY=VALUE ..., --list or --help");
  return options;
}

int list(const std::string& url) {
  LcmTransport transport(url, kSendingRate);
  SessionFinder finder;
  const double start = readClocks().monotonic;
  double now = start;
  // The world's config is not needed, but good to see.
  const auto knowsConfig = [&] {
    const auto sessions = finder.watch().sessions();
    return std::ranges::any_of(sessions, [](const auto& s) { return s.canonical.has_value(); });
  };
  while (!finder.isDone(now) || (!knowsConfig() && now < start + SessionFinder::kLongest)) {
    std::this_thread::sleep_for(kPollInterval);
    now = readClocks().monotonic;
    transport.poll([&](std::string_view channel, std::span<const std::byte> bytes) {
      finder.watch().hear(channel, bytes, readClocks());
    });
  }
  fmt::print("{}May be set (N: the number of a peer):\n{}", settingList(finder.session(now), now),
             settableKeysText());
  return 0;
}

int set(const SetOptions& options) {
  LcmTransport transport(options.url, kSendingRate);
  Setter setter(transport, options.wanted, {randomNumber(), userAtHost(kMaxSettingAuthor)});
  while (!setter.isOver()) {
    setter.tick(readClocks());
    std::this_thread::sleep_for(kPollInterval);
  }
  for (const SettingChange& change : setter.changes()) fmt::print("{}\n", changeText(change));
  const bool allHold = std::ranges::none_of(
      setter.changes(), [](const SettingChange& change) { return change.stronger.has_value(); });
  return setter.isConfirmed() && allHold ? 0 : kExitFailure;
}

}  // namespace

int runSet(std::span<const std::string> arguments) {
  const auto options = parse(arguments);
  if (!options) return 0;
  return options->list ? list(options->url) : set(*options);
}

}  // namespace wells
