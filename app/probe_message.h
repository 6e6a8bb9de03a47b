// probe_t as bytes and back, with the checks that network/codec.h makes of the session's messages.
#pragma once

#include <gravity_wells/probe_t.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "network/codec.h"

namespace wells {

inline constexpr std::size_t kMaxHostName = 60;  // bytes
inline constexpr int kMaxEchoesInMessage = 24;

std::span<const std::byte> encodeProbe(const gravity_wells::probe_t& probe, MessageBuffer& buffer);

/// Nothing when it is not well formed.
std::optional<gravity_wells::probe_t> decodeProbe(std::span<const std::byte> bytes);

}  // namespace wells
