// Between the generated message types and bytes. What decode() lets through is well formed: every
// count, id and number is in its range. Whether it is welcome (who sent it, when, in which session)
// is for the session to say.
//
// The generated decoders allocate whatever a length field claims, so sizes are compared first.
#pragma once

#include <array>
#include <cstddef>
#include <gravity_wells/ball_states_t.hpp>
#include <gravity_wells/heartbeat_t.hpp>
#include <gravity_wells/offers_t.hpp>
#include <gravity_wells/request_t.hpp>
#include <gravity_wells/settings_t.hpp>
#include <gravity_wells/statistics_t.hpp>
#include <gravity_wells/wells_t.hpp>
#include <gravity_wells/world_config_t.hpp>
#include <span>
#include <string_view>
#include <variant>

#include "network/drops.h"
#include "network/transport.h"

namespace wells {

using Message =
    std::variant<gravity_wells::heartbeat_t, gravity_wells::wells_t, gravity_wells::ball_states_t,
                 gravity_wells::offers_t, gravity_wells::world_config_t,
                 gravity_wells::statistics_t, gravity_wells::settings_t, gravity_wells::request_t>;

inline constexpr int kMaxBallsInMessage = 12;
inline constexpr int kMaxKeyframesInMessage = 24;
inline constexpr int kMaxBucketsInMessage = 24;
inline constexpr int kMaxSettingsInMessage = 4;
inline constexpr int kMaxViewsInMessage = 16;
inline constexpr int kMaxDropReasonsInMessage = 16;
inline constexpr std::size_t kMaxCanonicalBytes = 1000;
inline constexpr std::size_t kMaxDropReason = 24;     // bytes
inline constexpr std::size_t kMaxSettingKey = 40;     // bytes
inline constexpr std::size_t kMaxSettingValue = 120;  // bytes
inline constexpr std::size_t kMaxSettingAuthor = 60;  // bytes

/// Of programs that look whether multicast passes; sessions ignore it.
inline constexpr std::string_view kProbeChannel = "WELLS_PROBE";

/// The channel that a type is published on.
std::string_view channelOf(const gravity_wells::heartbeat_t&);
std::string_view channelOf(const gravity_wells::wells_t&);
std::string_view channelOf(const gravity_wells::ball_states_t&);
std::string_view channelOf(const gravity_wells::offers_t&);
std::string_view channelOf(const gravity_wells::world_config_t&);
std::string_view channelOf(const gravity_wells::statistics_t&);
std::string_view channelOf(const gravity_wells::settings_t&);
std::string_view channelOf(const gravity_wells::request_t&);

using MessageBuffer = std::array<std::byte, kMaxMessageBytes>;

/// Encodes into `buffer`. Throws std::length_error for a message that does not fit.
std::span<const std::byte> encode(const Message& message, MessageBuffer& buffer);

/// What depends on the world.
struct DecodeLimits {
  std::int64_t balls = 0;  // ids are below this
};

/// The message in `bytes`, or why it is refused.
std::variant<Message, Drop> decode(std::string_view channel, std::span<const std::byte> bytes,
                                   const DecodeLimits& limits);

inline const gravity_wells::peer_header_t& headerOf(const Message& message) {
  return std::visit([](const auto& m) -> const gravity_wells::peer_header_t& { return m.header; },
                    message);
}

}  // namespace wells
