#include "lcm/every_type.h"

#include <gravity_wells/ball_states_t.hpp>
#include <gravity_wells/heartbeat_t.hpp>
#include <gravity_wells/offers_t.hpp>
#include <gravity_wells/probe_t.hpp>
#include <gravity_wells/request_t.hpp>
#include <gravity_wells/settings_t.hpp>
#include <gravity_wells/statistics_t.hpp>
#include <gravity_wells/wells_t.hpp>
#include <gravity_wells/world_config_t.hpp>

namespace wells {
namespace {

using namespace gravity_wells;

class Numbers {
 public:
  template <class... Fields>
  void fill(Fields&... fields) {
    (next(fields), ...);
  }

 private:
  void next(std::int32_t& field) { field = static_cast<std::int32_t>(++last_); }
  void next(std::int64_t& field) { field = ++last_; }
  void next(std::int8_t& field) { field = ++last_ % 2 == 1; }
  void next(double& field) { field = static_cast<double>(++last_); }
  void next(std::uint8_t& field) { field = static_cast<std::uint8_t>(++last_); }
  template <class Element, std::size_t N>
  void next(Element (&elements)[N]) {
    for (Element& element : elements) next(element);
  }
  void next(std::string& field) { field = std::to_string(++last_); }

  void next(peer_header_t& m) {
    fill(m.utime, m.protocol, m.peer_id, m.incarnation, m.sequence, m.generation_resets,
         m.generation_founded, m.generation_nonce, m.step);
  }
  void next(ball_state_t& m) {
    fill(m.id, m.term, m.adopter, m.adopter_incarnation, m.epoch, m.position, m.velocity, m.spin);
  }
  void next(well_keyframe_t& m) { fill(m.step, m.position, m.strength); }
  void next(bucket_digest_t& m) { fill(m.known, m.sum); }
  void next(drop_count_t& m) { fill(m.reason, m.count); }
  void next(peer_view_t& m) {
    fill(m.peer_id, m.phase, m.lease_left_ms, m.clock_offset_ms, m.steps_behind);
  }
  void next(setting_t& m) { fill(m.key, m.value, m.version, m.setter, m.set_by, m.from_step); }
  void next(probe_echo_t& m) { fill(m.incarnation, m.heard, m.sent, m.latest, m.held_us); }
  template <class Element>
  void next(std::vector<Element>& elements) {
    for (Element& element : elements) next(element);
  }

  std::int64_t last_ = 0;
};

template <class Message>
std::vector<std::uint8_t> encode(const Message& message) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

template <class Message>
std::vector<std::uint8_t> encodeSimple() {
  Message message{};
  Numbers().fill(message);
  return encode(message);
}

std::vector<std::uint8_t> encodeHeartbeat() {
  heartbeat_t m{};
  m.buckets = 2;
  m.digests.resize(2);
  Numbers().fill(m.header, m.started, m.world_hash, m.phase, m.paused, m.complete, m.lease_ms,
                 m.balls_owned, m.settings_digest, m.first_bucket, m.digests);
  return encode(m);
}

std::vector<std::uint8_t> encodeWells() {
  wells_t m{};
  m.count = 2;
  m.keyframes.resize(2);
  Numbers().fill(m.header, m.peer, m.softening, m.keyframes);
  return encode(m);
}

std::vector<std::uint8_t> encodeBallStates() {
  ball_states_t m{};
  m.count = 12;
  m.balls.resize(12);
  Numbers().fill(m.header, m.step, m.balls);
  return encode(m);
}

std::vector<std::uint8_t> encodeOffers() {
  offers_t m{};
  m.count = 3;
  m.balls.resize(3);
  Numbers().fill(m.header, m.receiver, m.receiver_incarnation, m.step, m.balls);
  return encode(m);
}

std::vector<std::uint8_t> encodeWorldConfig() {
  world_config_t m{};
  Numbers().fill(m.header, m.world_hash, m.canonical);
  return encode(m);
}

std::vector<std::uint8_t> encodeStatistics() {
  statistics_t m{};
  m.reasons = 2;
  m.drops.resize(2);
  m.peers = 3;
  m.views.resize(3);
  Numbers().fill(m.header, m.sim_time, m.simulation_rate, m.simulation_target, m.network_rate,
                 m.network_target, m.graphics_rate, m.graphics_target, m.kinetic_energy,
                 m.potential_energy, m.max_overlap, m.balls_owned, m.balls_ghost, m.peers_heard,
                 m.handovers_given, m.handovers_taken, m.adoptions, m.view_difference_max,
                 m.doubled_ball_seconds, m.fences, m.resyncs, m.messages_sent_rate,
                 m.messages_received_rate, m.bytes_sent_rate, m.bytes_received_rate,
                 m.messages_sent, m.messages_received, m.messages_dropped, m.bytes_sent,
                 m.bytes_received, m.dropped_by_kernel, m.dropped_in_queue, m.dropped_by_checks,
                 m.drops, m.views);
  return encode(m);
}

std::vector<std::uint8_t> encodeSettings() {
  settings_t m{};
  m.count = 4;
  m.known.resize(4);
  Numbers().fill(m.header, m.known);
  return encode(m);
}

std::vector<std::uint8_t> encodeRequest() {
  request_t m{};
  m.count = 4;
  m.settings.resize(4);
  Numbers().fill(m.header, m.settings);
  return encode(m);
}

std::vector<std::uint8_t> encodeProbe() {
  probe_t m{};
  m.count = 2;
  m.echoes.resize(2);
  Numbers().fill(m.header, m.host, m.echoes);
  return encode(m);
}

}  // namespace

EncodedMessages encodeEveryType() {
  return {{"ball_state_t", encodeSimple<ball_state_t>()},
          {"ball_states_t", encodeBallStates()},
          {"bucket_digest_t", encodeSimple<bucket_digest_t>()},
          {"drop_count_t", encodeSimple<drop_count_t>()},
          {"heartbeat_t", encodeHeartbeat()},
          {"offers_t", encodeOffers()},
          {"peer_header_t", encodeSimple<peer_header_t>()},
          {"peer_view_t", encodeSimple<peer_view_t>()},
          {"probe_echo_t", encodeSimple<probe_echo_t>()},
          {"probe_t", encodeProbe()},
          {"request_t", encodeRequest()},
          {"setting_t", encodeSimple<setting_t>()},
          {"settings_t", encodeSettings()},
          {"statistics_t", encodeStatistics()},
          {"well_keyframe_t", encodeSimple<well_keyframe_t>()},
          {"wells_t", encodeWells()},
          {"world_config_t", encodeWorldConfig()}};
}

}  // namespace wells
