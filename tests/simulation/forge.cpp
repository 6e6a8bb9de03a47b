#include "simulation/forge.h"

#include <cmath>
#include <limits>

#include "network/codec.h"

namespace wells::simulation {
namespace {

std::byte anyByte(Random& random) {
  return static_cast<std::byte>(random.below(256));
}

RawMessage raw(const Message& message) {
  MessageBuffer buffer;
  const auto bytes = encode(message, buffer);
  const auto channel = std::visit([](const auto& m) { return channelOf(m); }, message);
  return {std::string(channel), {bytes.begin(), bytes.end()}};
}

/// Of the balls in a message of states or offers; nullptr in others.
std::vector<gravity_wells::ball_state_t>* ballsOf(Message& message) {
  if (auto* states = std::get_if<gravity_wells::ball_states_t>(&message)) return &states->balls;
  if (auto* offers = std::get_if<gravity_wells::offers_t>(&message)) return &offers->balls;
  return nullptr;
}

gravity_wells::peer_header_t& headerIn(Message& message) {
  return std::visit([](auto& m) -> gravity_wells::peer_header_t& { return m.header; }, message);
}

}  // namespace

RawMessage forge(const RawMessage& honest, std::size_t balls, Random& random) {
  RawMessage forged = honest;
  auto& bytes = forged.bytes;
  const auto decoded =
      decode(honest.channel, honest.bytes, {.balls = static_cast<std::int64_t>(balls)});
  switch (random.below(7)) {
    case 0:
      bytes.resize(random.below(bytes.size()));
      return forged;
    case 1:
      for (auto extra = 1 + random.below(200); extra > 0 && bytes.size() < kMaxMessageBytes;
           --extra)
        bytes.push_back(anyByte(random));
      return forged;
    case 2:
      for (std::byte& byte : bytes) byte = anyByte(random);
      return forged;
    case 3:
      forged.channel = forged.channel == "WELLS_BALLS" ? "WELLS_OFFERS" : "WELLS_BALLS";
      return forged;
    default:
      break;
  }
  const Message* original = std::get_if<Message>(&decoded);
  if (!original) return forged;
  Message message = *original;
  auto* claimed = ballsOf(message);
  switch (random.below(3)) {
    case 0:
      if (claimed)
        claimed->front().velocity[1] = std::numeric_limits<double>::quiet_NaN();
      else
        headerIn(message).peer_id = 0;
      break;
    case 1:
      if (claimed)
        claimed->front().id = static_cast<std::int32_t>(balls);
      else
        headerIn(message).protocol += 1;
      break;
    default:  // a stranger
      headerIn(message).incarnation = static_cast<std::int64_t>(random.bits() | 1);
      if (claimed) claimed->front().epoch += 1000;
      // Its heartbeat would make it a member, and what it says be believed.
      if (std::holds_alternative<gravity_wells::heartbeat_t>(message)) headerIn(message).utime = 1;
      break;
  }
  return raw(message);
}

}  // namespace wells::simulation
