// One good message of each type, for tests to damage.
#pragma once

#include <vector>

#include "network/codec.h"

namespace wells {

inline gravity_wells::peer_header_t goodHeader() {
  return {.utime = 1'700'000'000'000'000,
          .protocol = gravity_wells::peer_header_t::PROTOCOL,
          .peer_id = 3,
          .incarnation = -77,
          .sequence = 12,
          .generation_resets = 0,
          .generation_founded = 1'699'999'999'000'000,
          .generation_nonce = 5,
          .step = 600};
}

inline gravity_wells::ball_state_t goodBall(std::int32_t id) {
  return {.id = id,
          .term = 2,
          .adopter = 3,
          .adopter_incarnation = -77,
          .epoch = 4,
          .position = {1.5, 0.5, -20},
          .velocity = {0, -3.25, 1e-9},
          .spin = {0.1, 0, 7}};
}

inline gravity_wells::heartbeat_t goodHeartbeat(int buckets = 0) {
  gravity_wells::heartbeat_t m;
  m.header = goodHeader();
  m.started = 1'699'999'990'000'000;
  m.world_hash = -9;
  m.phase = gravity_wells::heartbeat_t::ACTIVE;
  m.paused = 0;
  m.complete = 0;
  m.lease_ms = 2000;
  m.balls_owned = 7;
  m.settings_digest = 5;
  m.first_bucket = 0;
  m.buckets = buckets;
  m.digests.assign(static_cast<std::size_t>(buckets), {});
  return m;
}

inline gravity_wells::wells_t goodWells(int count = 3) {
  gravity_wells::wells_t m;
  m.header = goodHeader();
  m.peer = 3;
  m.softening = 2;
  m.count = count;
  for (int i = 0; i < count; ++i)
    m.keyframes.push_back({.step = 600 + 6 * i, .position = {1, 0.5, 2}, .strength = -40});
  return m;
}

inline gravity_wells::ball_states_t goodStates(int count = 2) {
  gravity_wells::ball_states_t m;
  m.header = goodHeader();
  m.step = 599;
  m.count = count;
  for (int i = 0; i < count; ++i) m.balls.push_back(goodBall(i));
  return m;
}

inline gravity_wells::offers_t goodOffers(int count = 2) {
  gravity_wells::offers_t m;
  m.header = goodHeader();
  m.receiver = 255;
  m.receiver_incarnation = 99;
  m.step = 599;
  m.count = count;
  for (int i = 0; i < count; ++i) m.balls.push_back(goodBall(i));
  return m;
}

inline gravity_wells::world_config_t goodConfig() {
  gravity_wells::world_config_t m;
  m.header = goodHeader();
  m.world_hash = -9;
  m.canonical = "BallRadius=0.5\nNumOfBalls=25\n";
  return m;
}

inline gravity_wells::statistics_t goodStatistics() {
  gravity_wells::statistics_t m{};
  m.header = goodHeader();
  m.simulation_rate = 59.9;
  m.kinetic_energy = 1e9;
  m.potential_energy = -1e9;
  m.reasons = 2;
  m.drops = {{"replayed", 3}, {"not owner", 1}};
  m.peers = 1;
  m.views = {
      {.peer_id = 2, .phase = 2, .lease_left_ms = 1900, .clock_offset_ms = -3, .steps_behind = 1}};
  return m;
}

inline gravity_wells::setting_t goodSetting() {
  return {.key = "Gravity",
          .value = "reversed",
          .version = 3,
          .setter = -12,
          .set_by = "ada@lab-3",
          .from_step = 700};
}

inline gravity_wells::settings_t goodSettings(int count = 2) {
  gravity_wells::settings_t m;
  m.header = goodHeader();
  m.count = count;
  m.known.assign(static_cast<std::size_t>(count), goodSetting());
  return m;
}

inline gravity_wells::request_t goodRequest() {
  gravity_wells::request_t m;
  m.header = goodHeader();
  m.header.peer_id = 0;
  m.count = 1;
  m.settings = {goodSetting()};
  return m;
}

inline std::vector<Message> goodMessages() {
  return {goodHeartbeat(), goodWells(),      goodStates(),   goodOffers(),
          goodConfig(),    goodStatistics(), goodSettings(), goodRequest()};
}

}  // namespace wells
