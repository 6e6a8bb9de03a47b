#include "network/codec.h"

#include <gtest/gtest.h>

#include <bit>
#include <functional>
#include <limits>
#include <string>

#include "math/random.h"
#include "network/codec_messages.h"

namespace wells {
namespace {

using Bytes = std::vector<std::byte>;

constexpr DecodeLimits kLimits{.balls = 25};
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string_view channelOfMessage(const Message& message) {
  return std::visit([](const auto& m) { return channelOf(m); }, message);
}

Bytes bytesOf(const Message& message) {
  MessageBuffer buffer;
  const auto bytes = encode(message, buffer);
  return {bytes.begin(), bytes.end()};
}

std::variant<Message, Drop> decodeOn(const Message& channelOwner, const Bytes& bytes) {
  return decode(channelOfMessage(channelOwner), bytes, kLimits);
}

Drop dropOf(const Message& message) {
  const auto decoded = decodeOn(message, bytesOf(message));
  EXPECT_TRUE(std::holds_alternative<Drop>(decoded));
  return std::holds_alternative<Drop>(decoded) ? std::get<Drop>(decoded) : Drop::Echo;
}

void writeInt32(Bytes& bytes, std::size_t offset, std::uint32_t number) {
  for (std::size_t i = 0; i < 4; ++i)
    bytes[offset + i] = static_cast<std::byte>(number >> (24 - 8 * i));
}

TEST(Codec, EveryTypeComesBackAsItWasSent) {
  for (const Message& message : goodMessages()) {
    const Bytes bytes = bytesOf(message);
    const auto decoded = decodeOn(message, bytes);
    ASSERT_TRUE(std::holds_alternative<Message>(decoded)) << channelOfMessage(message);
    EXPECT_EQ(std::get<Message>(decoded).index(), message.index());
    EXPECT_EQ(bytesOf(std::get<Message>(decoded)), bytes);
  }
  const auto decoded = decodeOn(goodStates(), bytesOf(goodStates()));
  const auto& states = std::get<gravity_wells::ball_states_t>(std::get<Message>(decoded));
  EXPECT_EQ(states.balls[1].id, 1);
  EXPECT_EQ(states.balls[1].position[2], -20);
  EXPECT_EQ(states.balls[1].velocity[2], 1e-9);
}

TEST(Codec, TheLargestMessagesFitOneEthernetFrame) {
  gravity_wells::world_config_t config = goodConfig();
  config.canonical.assign(kMaxCanonicalBytes, 'x');
  gravity_wells::settings_t settings = goodSettings(kMaxSettingsInMessage);
  for (auto& setting : settings.known) {
    setting.key.assign(kMaxSettingKey, 'k');
    setting.value.assign(kMaxSettingValue, 'v');
    setting.set_by.assign(kMaxSettingAuthor, 'a');
  }
  gravity_wells::statistics_t statistics = goodStatistics();
  statistics.reasons = kMaxDropReasonsInMessage;
  statistics.drops.assign(kMaxDropReasonsInMessage, {std::string(kMaxDropReason, 'r'), 1});
  statistics.peers = kMaxViewsInMessage;
  statistics.views.assign(kMaxViewsInMessage, {});
  constexpr DecodeLimits kManyBalls{.balls = kMaxBucketsInMessage * 256};
  for (const Message& message :
       {Message(goodStates(kMaxBallsInMessage)), Message(goodOffers(kMaxBallsInMessage)),
        Message(goodWells(kMaxKeyframesInMessage)), Message(config),
        Message(goodHeartbeat(kMaxBucketsInMessage)), Message(settings), Message(statistics)}) {
    const Bytes bytes = bytesOf(message);
    EXPECT_LE(bytes.size(), kMaxMessageBytes);
    EXPECT_TRUE(
        std::holds_alternative<Message>(decode(channelOfMessage(message), bytes, kManyBalls)));
  }
}

TEST(Codec, RefusesToEncodeWhatDoesNotFit) {
  MessageBuffer buffer;
  EXPECT_THROW(encode(goodStates(13), buffer), std::length_error);
}

TEST(Codec, RefusesAMessageThatEndsEarlyAtAnyByte) {
  for (const Message& message : goodMessages()) {
    const Bytes whole = bytesOf(message);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      EXPECT_TRUE(std::holds_alternative<Drop>(decodeOn(message, part))) << size << " bytes";
    }
  }
}

TEST(Codec, RefusesTrailingBytesAndWhatIsTooLarge) {
  for (const Message& message : goodMessages()) {
    Bytes bytes = bytesOf(message);
    bytes.push_back(std::byte{0});
    EXPECT_EQ(std::get<Drop>(decodeOn(message, bytes)), Drop::WrongSize);
    bytes.resize(kMaxMessageBytes + 1);
    EXPECT_EQ(std::get<Drop>(decodeOn(message, bytes)), Drop::WrongSize);
  }
}

TEST(Codec, RefusesCountsThatTheBytesDoNotBack) {
  // Fingerprint and header take 72 bytes.
  const std::pair<Message, std::size_t> counts[] = {{goodWells(), 84},    {goodStates(), 80},
                                                    {goodOffers(), 92},   {goodConfig(), 80},
                                                    {goodSettings(), 72}, {goodRequest(), 72}};
  for (const auto& [message, offset] : counts) {
    const Bytes good = bytesOf(message);
    for (const std::uint32_t count : {0u, 2'000u, 0x7fffffffu, 0x80000000u, 0xffffffffu}) {
      Bytes bytes = good;
      writeInt32(bytes, offset, count);
      EXPECT_EQ(std::get<Drop>(decodeOn(message, bytes)), Drop::BadCount) << count;
    }
    Bytes bytes = good;
    writeInt32(bytes, offset, 4);
    EXPECT_EQ(std::get<Drop>(decodeOn(message, bytes)), Drop::WrongSize);
  }
}

TEST(Codec, RefusesForeignChannelsTypesAndProtocols) {
  const Bytes heartbeat = bytesOf(goodHeartbeat());
  EXPECT_EQ(std::get<Drop>(decode("WELLS_OTHER", heartbeat, kLimits)), Drop::UnknownChannel);
  EXPECT_EQ(std::get<Drop>(decode("", heartbeat, kLimits)), Drop::UnknownChannel);
  Bytes other = heartbeat;
  other[0] ^= std::byte{1};  // of the fingerprint
  EXPECT_EQ(std::get<Drop>(decode("WELLS_HEARTBEAT", other, kLimits)), Drop::Undecodable);
  gravity_wells::heartbeat_t m = goodHeartbeat();
  m.header.protocol = gravity_wells::peer_header_t::PROTOCOL + 1;
  EXPECT_EQ(dropOf(m), Drop::WrongProtocol);
}

TEST(Codec, RefusesEveryNumberOutsideItsRange) {
  using Damage = std::function<void(gravity_wells::heartbeat_t&)>;
  const Damage headers[] = {
      [](auto& m) { m.header.peer_id = 0; },
      [](auto& m) { m.header.peer_id = 256; },
      [](auto& m) { m.header.peer_id = -1; },
      [](auto& m) { m.header.incarnation = 0; },
      [](auto& m) { m.header.sequence = 0; },
      [](auto& m) { m.header.sequence = -5; },
      [](auto& m) { m.header.utime = -1; },
      [](auto& m) { m.header.step = -1; },
      [](auto& m) { m.header.step = std::numeric_limits<std::int64_t>::max(); },
      [](auto& m) { m.header.generation_resets = -1; },
      [](auto& m) { m.header.generation_founded = 0; },  // with a nonce: neither none nor one
      [](auto& m) { m.started = 0; },
      [](auto& m) { m.phase = 4; },
      [](auto& m) { m.phase = -1; },
      [](auto& m) { m.paused = 2; },
      [](auto& m) { m.complete = 2; },
      [](auto& m) { m.lease_ms = 0; },
      [](auto& m) { m.lease_ms = 3'600'000; },
      [](auto& m) { m.balls_owned = 26; },
      [](auto& m) { m.balls_owned = -1; },
      [](auto& m) { m.first_bucket = -1; },
      [](auto& m) {  // 25 balls lie in one bucket
        m = goodHeartbeat(1);
        m.first_bucket = 1;
      },
  };
  for (std::size_t i = 0; i < std::size(headers); ++i) {
    gravity_wells::heartbeat_t m = goodHeartbeat();
    headers[i](m);
    EXPECT_EQ(dropOf(m), Drop::OutOfRange) << "damage " << i;
  }

  const std::function<void(gravity_wells::ball_state_t&)> balls[] = {
      [](auto& b) { b.id = -1; },
      [](auto& b) { b.id = 25; },
      [](auto& b) { b.term = -1; },
      [](auto& b) { b.epoch = -1; },
      [](auto& b) { b.adopter = 256; },
      [](auto& b) { b.position[0] = kNaN; },
      [](auto& b) { b.position[2] = 1e300; },
      [](auto& b) { b.velocity[1] = kInfinity; },
      [](auto& b) { b.velocity[2] = -1e9; },
      [](auto& b) { b.spin[0] = -kInfinity; },
      [](auto& b) { b.spin[2] = kNaN; },
  };
  for (std::size_t i = 0; i < std::size(balls); ++i) {
    gravity_wells::ball_states_t states = goodStates();
    balls[i](states.balls.back());
    EXPECT_EQ(dropOf(states), Drop::OutOfRange) << "damage " << i;
    gravity_wells::offers_t offers = goodOffers();
    balls[i](offers.balls.back());
    EXPECT_EQ(dropOf(offers), Drop::OutOfRange) << "damage " << i;
  }

  const std::function<void(gravity_wells::wells_t&)> wells[] = {
      [](auto& m) { m.peer = 0; },
      [](auto& m) { m.peer = 256; },
      [](auto& m) { m.softening = 0; },
      [](auto& m) { m.softening = kNaN; },
      [](auto& m) { m.keyframes[1].strength = kInfinity; },
      [](auto& m) { m.keyframes[1].position[1] = kNaN; },
      [](auto& m) { m.keyframes[1].step = m.keyframes[0].step; },
      [](auto& m) { m.keyframes[2].step = -3; },
  };
  for (std::size_t i = 0; i < std::size(wells); ++i) {
    gravity_wells::wells_t m = goodWells();
    wells[i](m);
    EXPECT_EQ(dropOf(m), Drop::OutOfRange) << "damage " << i;
  }

  gravity_wells::offers_t offers = goodOffers();
  offers.receiver = 0;
  EXPECT_EQ(dropOf(offers), Drop::OutOfRange);
  offers = goodOffers();
  offers.receiver_incarnation = 0;
  EXPECT_EQ(dropOf(offers), Drop::OutOfRange);
  gravity_wells::statistics_t statistics = goodStatistics();
  statistics.max_overlap = kNaN;
  EXPECT_EQ(dropOf(statistics), Drop::OutOfRange);
  statistics = goodStatistics();
  statistics.drops[0].reason = "\x1b[2J";
  EXPECT_EQ(dropOf(statistics), Drop::OutOfRange) << "it would clear somebody's terminal";

  const std::function<void(gravity_wells::setting_t&)> settings[] = {
      [](auto& s) { s.key.clear(); },
      [](auto& s) { s.key.assign(1, '\n'); },
      [](auto& s) { s.value.assign(1, '\x7f'); },
      [](auto& s) { s.set_by.assign(1, '\x1b'); },
      [](auto& s) { s.version = 0; },
      [](auto& s) { s.version = -1; },
      [](auto& s) { s.from_step = -1; },
  };
  for (std::size_t i = 0; i < std::size(settings); ++i) {
    gravity_wells::settings_t m = goodSettings();
    settings[i](m.known.back());
    EXPECT_EQ(dropOf(m), Drop::OutOfRange) << "damage " << i;
  }
  gravity_wells::request_t request = goodRequest();
  request.header.peer_id = 1;
  EXPECT_EQ(dropOf(request), Drop::OutOfRange) << "a peer sets by settings_t";
}

// Whatever comes in, decode() returns; what it lets through can be encoded again to the same bytes.
// Under the sanitizers this is where a decoder that reads too far shows.
void expectSafe(const Message& message, const Bytes& bytes) {
  const auto decoded = decodeOn(message, bytes);
  if (const Message* passed = std::get_if<Message>(&decoded)) {
    EXPECT_EQ(bytesOf(*passed).size(), bytes.size());
  }
}

TEST(Codec, SurvivesRandomBytes) {
  Random random(1);
  for (int round = 0; round < 20'000; ++round)
    for (const Message& message : goodMessages()) {
      Bytes bytes(random.below(kMaxMessageBytes + 100));
      for (std::byte& byte : bytes) byte = static_cast<std::byte>(random.bits());
      EXPECT_TRUE(std::holds_alternative<Drop>(decodeOn(message, bytes)));
      if (round % 10 != 0) continue;
      // With a true fingerprint, so that the decoder itself gets to see them.
      const Bytes good = bytesOf(message);
      bytes.resize(good.size());
      std::copy_n(good.begin(), 8, bytes.begin());
      expectSafe(message, bytes);
    }
}

TEST(Codec, SurvivesFlippedBits) {
  Random random(2);
  for (const Message& message : goodMessages()) {
    const Bytes good = bytesOf(message);
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
      Bytes bytes = good;
      bytes[bit / 8] ^= static_cast<std::byte>(1 << (bit % 8));
      expectSafe(message, bytes);
    }
    for (int round = 0; round < 5'000; ++round) {
      Bytes bytes = good;
      for (std::uint64_t flips = 1 + random.below(20); flips > 0; --flips)
        bytes[random.below(bytes.size())] ^= static_cast<std::byte>(1 << random.below(8));
      expectSafe(message, bytes);
    }
  }
}

TEST(Drops, EveryReasonHasAName) {
  for (std::size_t i = 0; i < kDropReasons; ++i)
    EXPECT_NE(name(static_cast<Drop>(i)), "unknown") << i;
}

TEST(Drops, EchoesAndWhatComesBeforeJoiningAreNoFault) {
  DropCounts counts;
  counts.add(Drop::Echo);
  counts.add(Drop::NotJoined);
  counts.add(Drop::Replayed);
  counts.add(Drop::Replayed);
  EXPECT_EQ(counts.total(), 2);
  EXPECT_EQ(counts[Drop::Replayed], 2);
  EXPECT_EQ(counts[Drop::Echo], 1);
}

}  // namespace
}  // namespace wells
