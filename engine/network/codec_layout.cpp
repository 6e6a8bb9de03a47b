#include "network/codec_layout.h"

#include "network/codec.h"

namespace wells {
namespace {

constexpr std::size_t kFingerprintBytes = 8;
constexpr std::size_t kHeaderBytes = 64;
constexpr std::size_t kFrontBytes = kFingerprintBytes + kHeaderBytes;
constexpr std::size_t kBallStateBytes = 104;
constexpr std::size_t kKeyframeBytes = 40;
constexpr std::size_t kBucketBytes = 40;
constexpr std::size_t kPeerViewBytes = 24;

void walkElements(MessageWalk& walk, std::int32_t low, std::int32_t high, std::size_t bytes) {
  const std::int32_t count = walk.count(low, high);
  walk.skip(static_cast<std::size_t>(count) * bytes);
}

}  // namespace

void MessageWalk::skip(std::size_t bytes) {
  if (fault_) return;
  if (bytes > bytes_.size()) {
    fault_ = Drop::WrongSize;
  } else {
    bytes_ = bytes_.subspan(bytes);
  }
}

std::int32_t MessageWalk::count(std::int32_t low, std::int32_t high) {
  const auto field = bytes_;
  skip(4);
  if (fault_) return 0;
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) bits = (bits << 8) | std::to_integer<std::uint32_t>(field[i]);
  const auto value = static_cast<std::int32_t>(bits);
  if (value >= low && value <= high) return value;
  fault_ = Drop::BadCount;
  return 0;
}

void MessageWalk::string(std::size_t longest) {
  skip(static_cast<std::size_t>(count(1, static_cast<std::int32_t>(longest) + 1)));
}

std::optional<Drop> MessageWalk::end() const {
  if (!fault_ && !bytes_.empty()) return Drop::WrongSize;
  return fault_;
}

void walkHeartbeat(MessageWalk& walk) {
  walk.skip(kFrontBytes + 8 + 8 + 4 + 1 + 1 + 4 + 4 + 8 + 4);
  walkElements(walk, 0, kMaxBucketsInMessage, kBucketBytes);
}

void walkWells(MessageWalk& walk) {
  walk.skip(kFrontBytes + 4 + 8);
  walkElements(walk, 1, kMaxKeyframesInMessage, kKeyframeBytes);
}

void walkBallStates(MessageWalk& walk) {
  walk.skip(kFrontBytes + 8);
  walkElements(walk, 1, kMaxBallsInMessage, kBallStateBytes);
}

void walkOffers(MessageWalk& walk) {
  walk.skip(kFrontBytes + 4 + 8 + 8);
  walkElements(walk, 1, kMaxBallsInMessage, kBallStateBytes);
}

void walkWorldConfig(MessageWalk& walk) {
  walk.skip(kFrontBytes + 8);
  walk.string(kMaxCanonicalBytes);
}

void walkStatistics(MessageWalk& walk) {
  walk.skip(kFrontBytes + 10 * 8 + 3 * 4 + 3 * 8 + 2 * 8 + 2 * 8 + 4 * 8 + 5 * 8 + 3 * 8);
  const std::int32_t reasons = walk.count(0, kMaxDropReasonsInMessage);
  for (std::int32_t i = 0; i < reasons; ++i) {
    walk.string(kMaxDropReason);
    walk.skip(8);
  }
  walkElements(walk, 0, kMaxViewsInMessage, kPeerViewBytes);
}

void walkSettings(MessageWalk& walk) {
  walk.skip(kFrontBytes);
  const std::int32_t settings = walk.count(1, kMaxSettingsInMessage);
  for (std::int32_t i = 0; i < settings; ++i) {
    walk.string(kMaxSettingKey);
    walk.string(kMaxSettingValue);
    walk.skip(8 + 8);
    walk.string(kMaxSettingAuthor);
    walk.skip(8);
  }
}

}  // namespace wells
