#include "network/codec_ranges.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <initializer_list>

#include "math/ids.h"
#include "ownership/digest.h"

namespace wells {
namespace {

using namespace gravity_wells;

constexpr std::int64_t kMaxStep = std::int64_t{1} << 53;   // 4.7 million years at 60 Hz
constexpr std::int64_t kMaxCount = std::int64_t{1} << 62;  // of anything that only rises
constexpr double kMaxCoordinate = 1e9;                     // m
constexpr double kMaxSpeed = 1e8;                          // m/s
constexpr double kMaxSpin = 1e9;                           // rad/s
constexpr double kMaxStrength = 1e15;                      // m^3/s^2
constexpr double kMaxSoftening = 1e9;                      // m
constexpr std::int32_t kMinLease = 50;                     // ms
constexpr std::int32_t kMaxLease = 60'000;                 // ms

// A template, so that no number changes its type before it is compared.
template <class T>
bool isWithin(T value, std::type_identity_t<T> low, std::type_identity_t<T> high) {
  return value >= low && value <= high;  // false for NaN
}

bool isCount(std::int64_t value) {
  return isWithin(value, 0, kMaxCount);
}

bool isStep(std::int64_t value) {
  return isWithin(value, 0, kMaxStep);
}

bool isPeer(std::int32_t value) {
  return isWithin(value, 1, kMaxPeerId);
}

bool areFinite(std::initializer_list<double> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

bool isVector(const double (&v)[3], double bound) {
  return std::ranges::all_of(v, [&](double value) { return isWithin(value, -bound, bound); });
}

bool isInRange(const peer_header_t& header, std::int32_t lowestPeer = 1) {
  const bool noGeneration = header.generation_founded == 0;
  if (noGeneration && (header.generation_resets != 0 || header.generation_nonce != 0)) return false;
  return isCount(header.utime) && isWithin(header.peer_id, lowestPeer, kMaxPeerId) &&
         header.incarnation != 0 && isWithin(header.sequence, 1, kMaxCount) &&
         isCount(header.generation_resets) && isCount(header.generation_founded) &&
         isStep(header.step);
}

bool isInRange(const ball_state_t& ball, const DecodeLimits& limits) {
  return ball.id >= 0 && ball.id < limits.balls && isCount(ball.term) &&
         isWithin(ball.adopter, 0, kMaxPeerId) && isCount(ball.epoch) &&
         isVector(ball.position, kMaxCoordinate) && isVector(ball.velocity, kMaxSpeed) &&
         isVector(ball.spin, kMaxSpin);
}

bool areInRange(const std::vector<ball_state_t>& balls, const DecodeLimits& limits) {
  return std::ranges::all_of(balls,
                             [&](const ball_state_t& ball) { return isInRange(ball, limits); });
}

bool isInRange(const well_keyframe_t& key) {
  return isStep(key.step) && isVector(key.position, kMaxCoordinate) &&
         isWithin(key.strength, -kMaxStrength, kMaxStrength);
}

// What people read must not move their cursor.
bool isPrintable(const std::string& text) {
  return std::ranges::all_of(text, [](char c) { return c >= ' ' && c != 0x7f; });
}

bool isInRange(const setting_t& setting) {
  return !setting.key.empty() && isPrintable(setting.key) && isPrintable(setting.value) &&
         isPrintable(setting.set_by) && isWithin(setting.version, 1, kMaxCount) &&
         isStep(setting.from_step);
}

bool areInRange(const std::vector<setting_t>& settings) {
  return std::ranges::all_of(settings, [](const setting_t& s) { return isInRange(s); });
}

}  // namespace

bool isInRange(const heartbeat_t& message, const DecodeLimits& limits) {
  return isInRange(message.header) && isWithin(message.started, 1, kMaxCount) &&
         isWithin(message.phase, heartbeat_t::JOINING, heartbeat_t::LEAVING) &&
         isWithin(message.paused, 0, 1) && isWithin(message.complete, 0, 1) &&
         isWithin(message.lease_ms, kMinLease, kMaxLease) &&
         isWithin(std::int64_t{message.balls_owned}, 0, limits.balls) &&
         message.first_bucket >= 0 &&
         std::int64_t{message.first_bucket} + message.buckets <=
             static_cast<std::int64_t>(bucketCount(static_cast<std::size_t>(limits.balls)));
}

bool isInRange(const wells_t& message, const DecodeLimits&) {
  const bool stepsRise = std::ranges::adjacent_find(message.keyframes, [](auto& a, auto& b) {
                           return a.step >= b.step;
                         }) == message.keyframes.end();
  return isInRange(message.header) && isPeer(message.peer) && message.softening > 0 &&
         message.softening <= kMaxSoftening && stepsRise &&
         std::ranges::all_of(message.keyframes,
                             [](const well_keyframe_t& key) { return isInRange(key); });
}

bool isInRange(const ball_states_t& message, const DecodeLimits& limits) {
  return isInRange(message.header) && isStep(message.step) && areInRange(message.balls, limits);
}

bool isInRange(const offers_t& message, const DecodeLimits& limits) {
  return isInRange(message.header) && isPeer(message.receiver) &&
         message.receiver_incarnation != 0 && isStep(message.step) &&
         areInRange(message.balls, limits);
}

bool isInRange(const world_config_t& message, const DecodeLimits&) {
  return isInRange(message.header) &&
         std::ranges::none_of(message.canonical, [](char c) { return c == '\0'; });
}

bool isInRange(const statistics_t& message, const DecodeLimits&) {
  return isInRange(message.header) &&
         areFinite({message.sim_time, message.simulation_rate, message.simulation_target,
                    message.network_rate, message.network_target, message.graphics_rate,
                    message.graphics_target, message.kinetic_energy, message.potential_energy,
                    message.max_overlap, message.view_difference_max, message.doubled_ball_seconds,
                    message.messages_sent_rate, message.messages_received_rate,
                    message.bytes_sent_rate, message.bytes_received_rate}) &&
         std::ranges::all_of(message.drops,
                             [](const drop_count_t& drop) { return isPrintable(drop.reason); });
}

bool isInRange(const settings_t& message, const DecodeLimits&) {
  return isInRange(message.header) && areInRange(message.known);
}

bool isInRange(const request_t& message, const DecodeLimits&) {
  return isInRange(message.header, 0) && message.header.peer_id == 0 &&
         areInRange(message.settings);
}

}  // namespace wells
