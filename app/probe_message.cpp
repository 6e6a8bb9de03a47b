#include "probe_message.h"

#include <algorithm>
#include <stdexcept>

#include "network/codec_layout.h"

namespace wells {
namespace {

constexpr std::size_t kFrontBytes = 8 + 64;  // fingerprint, header
constexpr std::size_t kEchoBytes = 40;
constexpr std::int64_t kMaxCount = std::int64_t{1} << 62;

bool isCount(std::int64_t value) {
  return value >= 0 && value <= kMaxCount;
}

bool isInRange(const gravity_wells::probe_echo_t& echo) {
  return isCount(echo.sent) && isCount(echo.heard) && echo.heard <= echo.sent &&
         isCount(echo.latest) && isCount(echo.held_us);
}

// The host's name is shown to people: it must not move their cursor.
bool isInRange(const gravity_wells::probe_t& probe) {
  const auto isPrintable = [](char c) { return c >= ' ' && c != 0x7f; };
  return probe.header.incarnation != 0 && probe.header.sequence >= 1 &&
         isCount(probe.header.sequence) && !probe.host.empty() &&
         std::ranges::all_of(probe.host, isPrintable) &&
         std::ranges::all_of(probe.echoes, [](const auto& echo) { return isInRange(echo); });
}

}  // namespace

std::span<const std::byte> encodeProbe(const gravity_wells::probe_t& probe, MessageBuffer& buffer) {
  const int size = probe.encode(buffer.data(), 0, static_cast<int>(buffer.size()));
  if (size < 0) throw std::length_error("a probe does not fit into a message");
  return {buffer.data(), static_cast<std::size_t>(size)};
}

std::optional<gravity_wells::probe_t> decodeProbe(std::span<const std::byte> bytes) {
  // The generated decoder allocates whatever a length field claims.
  MessageWalk walk(bytes);
  walk.skip(kFrontBytes);
  walk.string(kMaxHostName);
  walk.skip(static_cast<std::size_t>(walk.count(0, kMaxEchoesInMessage)) * kEchoBytes);
  if (walk.end()) return std::nullopt;
  gravity_wells::probe_t probe;
  const int size = static_cast<int>(bytes.size());
  if (probe.decode(bytes.data(), 0, size) != size || !isInRange(probe)) return std::nullopt;
  return probe;
}

}  // namespace wells
