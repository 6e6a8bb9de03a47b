// Peers as somebody who listens hears them, for tests of the operator's tools.
#pragma once

#include <bit>
#include <utility>
#include <vector>

#include "network/codec.h"
#include "network/shared_settings.h"
#include "ownership/version.h"
#include "session_watch.h"

namespace wells {

inline constexpr Generation kGeneration{0, 1'700'000'000'000'000, 0xff};

/// What peer `id` sends. Its incarnation is 100 + id.
class Speaker {
 public:
  explicit Speaker(int id, const Generation& generation = kGeneration) : id_(id) {
    setGeneration(generation);
  }

  void setGeneration(const Generation& generation) { generation_ = generation; }

  gravity_wells::peer_header_t header(std::int64_t step) {
    return {.utime = 1'700'000'100'000'000,
            .protocol = gravity_wells::peer_header_t::PROTOCOL,
            .peer_id = id_,
            .incarnation = 100 + id_,
            .sequence = ++sequence_,
            .generation_resets = generation_.resets,
            .generation_founded = generation_.foundedUs,
            .generation_nonce = generation_.nonce,
            .step = step};
  }

  gravity_wells::heartbeat_t heartbeat(std::int64_t step, Phase phase = Phase::Active,
                                       const SharedSettings& known = {}) {
    gravity_wells::heartbeat_t m{};
    m.header = header(step);
    m.started = 1;
    m.world_hash = 42;
    m.phase = static_cast<std::int32_t>(phase);
    m.lease_ms = 2000;
    m.balls_owned = 10 * id_;
    m.settings_digest = std::bit_cast<std::int64_t>(known.digest());
    return m;
  }

  gravity_wells::statistics_t statistics(std::int64_t step) {
    gravity_wells::statistics_t m{};
    m.header = header(step);
    return m;
  }

  gravity_wells::settings_t settings(std::int64_t step, const SharedSettings& known) {
    gravity_wells::settings_t m{};
    m.header = header(step);
    for (const auto& [key, r] : known.registers())
      m.known.push_back({key, r.value, r.version, r.setter, r.setBy, r.fromStep});
    m.count = static_cast<std::int32_t>(m.known.size());
    return m;
  }

  gravity_wells::world_config_t config(std::int64_t step) {
    gravity_wells::world_config_t m{};
    m.header = header(step);
    m.world_hash = 42;
    m.canonical = "NumOfBalls=30\nElasticity=0.8\nFriction=0.3\n";
    return m;
  }

 private:
  int id_;
  Generation generation_{};
  std::int64_t sequence_ = 0;
};

inline void say(SessionWatch& watch, const Message& message, Times now) {
  MessageBuffer buffer;
  const auto bytes = encode(message, buffer);
  watch.hear(std::visit([](const auto& m) { return channelOf(m); }, message), bytes, now);
}

inline void say(Transport& transport, const Message& message) {
  MessageBuffer buffer;
  const auto bytes = encode(message, buffer);
  transport.publish(std::visit([](const auto& m) { return channelOf(m); }, message), bytes);
}

}  // namespace wells
