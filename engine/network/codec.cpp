#include "network/codec.h"

#include <cstdint>
#include <optional>
#include <stdexcept>

#include "network/codec_layout.h"
#include "network/codec_ranges.h"

namespace wells {
namespace {

using namespace gravity_wells;

template <class T>
std::variant<Message, Drop> decodeAs(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  T message;
  const int size = static_cast<int>(bytes.size());
  if (message.decode(bytes.data(), 0, size) != size) return Drop::Undecodable;
  if (message.header.protocol != peer_header_t::PROTOCOL) return Drop::WrongProtocol;
  if (!isInRange(message, limits)) return Drop::OutOfRange;
  return Message(std::move(message));
}

struct Channel {
  std::string_view name;
  void (*walk)(MessageWalk&);
  std::variant<Message, Drop> (*decode)(std::span<const std::byte>, const DecodeLimits&);
};

constexpr Channel kChannels[] = {
    {"WELLS_HEARTBEAT", walkHeartbeat, decodeAs<heartbeat_t>},
    {"WELLS_WELL", walkWells, decodeAs<wells_t>},
    {"WELLS_BALLS", walkBallStates, decodeAs<ball_states_t>},
    {"WELLS_OFFERS", walkOffers, decodeAs<offers_t>},
    {"WELLS_CONFIG", walkWorldConfig, decodeAs<world_config_t>},
    {"WELLS_STATISTICS", walkStatistics, decodeAs<statistics_t>},
    {"WELLS_SETTINGS", walkSettings, decodeAs<settings_t>},
    {"WELLS_REQUEST", walkSettings, decodeAs<request_t>},
};

}  // namespace

std::string_view channelOf(const heartbeat_t&) {
  return "WELLS_HEARTBEAT";
}
std::string_view channelOf(const wells_t&) {
  return "WELLS_WELL";
}
std::string_view channelOf(const ball_states_t&) {
  return "WELLS_BALLS";
}
std::string_view channelOf(const offers_t&) {
  return "WELLS_OFFERS";
}
std::string_view channelOf(const world_config_t&) {
  return "WELLS_CONFIG";
}
std::string_view channelOf(const statistics_t&) {
  return "WELLS_STATISTICS";
}
std::string_view channelOf(const settings_t&) {
  return "WELLS_SETTINGS";
}
std::string_view channelOf(const request_t&) {
  return "WELLS_REQUEST";
}

std::span<const std::byte> encode(const Message& message, MessageBuffer& buffer) {
  const int size = std::visit(
      [&](const auto& m) { return m.encode(buffer.data(), 0, static_cast<int>(buffer.size())); },
      message);
  if (size < 0) {
    throw std::length_error("a message does not fit into " + std::to_string(buffer.size()) +
                            " bytes");
  }
  return {buffer.data(), static_cast<std::size_t>(size)};
}

std::variant<Message, Drop> decode(std::string_view channel, std::span<const std::byte> bytes,
                                   const DecodeLimits& limits) {
  for (const Channel& known : kChannels) {
    if (known.name != channel) continue;
    if (bytes.size() > kMaxMessageBytes) return Drop::WrongSize;
    MessageWalk walk(bytes);
    known.walk(walk);
    if (const auto drop = walk.end()) return *drop;
    return known.decode(bytes, limits);
  }
  return Drop::UnknownChannel;
}

}  // namespace wells
