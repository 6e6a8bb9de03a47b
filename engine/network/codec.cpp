#include "network/codec.h"

#include <cstdint>
#include <optional>
#include <stdexcept>

#include "network/codec_ranges.h"

namespace wells {
namespace {

using namespace gravity_wells;

// The layout of each message: a fixed part that holds at most one count, then `count` elements of a
// fixed size. All counts and lengths are big-endian int32, and stand behind the fingerprint (8
// bytes), the header and the fields named here.
constexpr std::size_t kFingerprintBytes = 8;
constexpr std::size_t kHeaderBytes = 64;
constexpr std::size_t kBallStateBytes = 104;
constexpr std::size_t kKeyframeBytes = 40;

struct Layout {
  std::string_view channel;
  std::size_t fixedBytes;   // of the whole message without its elements
  std::size_t countOffset;  // 0: no elements
  std::size_t elementBytes;
  std::int32_t maxCount;  // the smallest is 1
  std::variant<Message, Drop> (*decode)(std::span<const std::byte>, const DecodeLimits&);
};

template <class T>
std::variant<Message, Drop> decodeAs(std::span<const std::byte> bytes, const DecodeLimits& limits) {
  T message;
  const int size = static_cast<int>(bytes.size());
  if (message.decode(bytes.data(), 0, size) != size) return Drop::Undecodable;
  if (message.header.protocol != peer_header_t::PROTOCOL) return Drop::WrongProtocol;
  if (!isInRange(message, limits)) return Drop::OutOfRange;
  return Message(std::move(message));
}

constexpr std::size_t kFrontBytes = kFingerprintBytes + kHeaderBytes;

constexpr Layout kLayouts[] = {
    {"WELLS_HEARTBEAT", kFrontBytes + 8 + 8 + 4 + 1 + 4 + 4, 0, 0, 0, decodeAs<heartbeat_t>},
    {"WELLS_WELL", kFrontBytes + 8 + 4, kFrontBytes + 8, kKeyframeBytes, kMaxKeyframesInMessage,
     decodeAs<wells_t>},
    {"WELLS_BALLS", kFrontBytes + 8 + 4, kFrontBytes + 8, kBallStateBytes, kMaxBallsInMessage,
     decodeAs<ball_states_t>},
    {"WELLS_OFFERS", kFrontBytes + 4 + 8 + 8 + 4, kFrontBytes + 4 + 8 + 8, kBallStateBytes,
     kMaxBallsInMessage, decodeAs<offers_t>},
    // The length of a string counts the zero byte that ends it.
    {"WELLS_CONFIG", kFrontBytes + 8 + 4, kFrontBytes + 8, 1,
     static_cast<std::int32_t>(kMaxCanonicalBytes) + 1, decodeAs<world_config_t>},
    {"WELLS_STATISTICS", kFrontBytes + 10 * 8 + 3 * 4 + 3 * 8 + 8 + 5 * 8, 0, 0, 0,
     decodeAs<statistics_t>},
};

std::int32_t readCount(std::span<const std::byte> bytes, std::size_t offset) {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < 4; ++i)
    count = (count << 8) | std::to_integer<std::uint32_t>(bytes[offset + i]);
  return static_cast<std::int32_t>(count);
}

std::optional<Drop> checkSize(const Layout& layout, std::span<const std::byte> bytes) {
  if (bytes.size() > kMaxMessageBytes || bytes.size() < layout.fixedBytes) return Drop::WrongSize;
  std::size_t expected = layout.fixedBytes;
  if (layout.countOffset > 0) {
    const std::int32_t count = readCount(bytes, layout.countOffset);
    if (count < 1 || count > layout.maxCount) return Drop::BadCount;
    expected += static_cast<std::size_t>(count) * layout.elementBytes;
  }
  if (bytes.size() != expected) return Drop::WrongSize;
  return std::nullopt;
}

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
  for (const Layout& layout : kLayouts) {
    if (layout.channel != channel) continue;
    if (const auto drop = checkSize(layout, bytes)) return *drop;
    return layout.decode(bytes, limits);
  }
  return Drop::UnknownChannel;
}

}  // namespace wells
