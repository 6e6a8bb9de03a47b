#include "session_setup.h"

#include <fmt/format.h>
#include <unistd.h>

#include <bit>
#include <random>

#include "clocks.h"
#include "cores.h"
#include "errors.h"
#include "keys.h"
#include "math/hash.h"
#include "network/codec.h"
#include "network/memory_transport.h"
#include "predictors.h"
#include "setting_checks.h"
#include "world_setup.h"

namespace wells {
namespace {

static_assert(kCanonicalLimit <= kMaxCanonicalBytes);

std::uint64_t freshSeed(const Times& now) {
  Hash hash;
  std::random_device device;
  for (int i = 0; i < 4; ++i) hash.add(std::uint64_t{device()});
  hash.add(static_cast<std::uint64_t>(now.wallUs));
  hash.add(static_cast<std::uint64_t>(::getpid()));
  return hash.value();
}

std::int64_t worldHash(const std::string& canonical) {
  Hash hash;
  hash.add(std::string_view(canonical));
  return std::bit_cast<std::int64_t>(hash.value());
}

}  // namespace

Link openLink(const PeerOptions& options) {
  const std::string url =
      options.lcmUrl.empty() ? lcmUrl(static_cast<int>(options.config.udpPort), 0) : options.lcmUrl;
  try {
    auto lcm = std::make_unique<LcmTransport>(url, options.config.networkRate);
    LcmTransport* const pointer = lcm.get();
    const std::vector<int>& cores = options.places.network.value();
    if (!cores.empty() && !lcm->pin(cores))
      throw RunError(
          fmt::format("the threads of the network cannot be kept on core {}", formatCores(cores)));
    return {std::move(lcm), pointer, pointer->note()};
  } catch (const TransportError& error) {
    if (options.requireLcm) throw RunError(fmt::format("--require-lcm: {}", error.what()));
    auto memory = std::make_unique<MemoryTransport>(std::make_shared<MemoryNetwork>());
    return {std::move(memory), nullptr, fmt::format("This peer stays alone: {}", error.what())};
  }
}

SessionOptions makeSessionOptions(const PeerOptions& options, const World& initial,
                                  const WellMotion& motion, const Link& link,
                                  std::function<void(const std::string&)> notice) {
  const Config& config = options.config;
  SessionOptions session;
  session.peer = PeerId{static_cast<std::int32_t>(config.peerId)};
  session.idChoice =
      options.idOrigin == IdOrigin::CommandLine ? PeerIdChoice::Explicit : PeerIdChoice::Preferred;
  session.seed = freshSeed(readClocks());
  session.lease = config.lease;
  if (!link.lcm) session.listen = 0;  // there is nobody to be heard
  session.stepRate = stepRate(config, options.engine);
  session.canonicalConfig = canonicalConfig(config, options.engine, initial.balls);
  session.defaultOf = [](std::string_view name) {
    const Key* key = findKey(name);
    const auto values = key ? key->get(Config{}) : std::vector<std::string>{};
    return values.empty() ? "" : values.front();
  };
  session.worldHash = worldHash(session.canonicalConfig);
  session.well.softening = motion.softening();
  session.well.at = [&motion](PeerId peer, std::int64_t step) { return motion.at(peer, step); };
  session.predict = makePredictor(options.engine);
  session.checkSetting = checkPeerSetting;
  session.notice = std::move(notice);
  return session;
}

}  // namespace wells
