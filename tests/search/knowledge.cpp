#include "search/knowledge.h"

#include <algorithm>
#include <stdexcept>

namespace wells {
namespace {

constexpr Word kMaxVersions = 1 << 14;

/// Packs small numbers into one word, and refuses others.
class Packed {
 public:
  void add(std::int64_t number, int bits) {
    if (number < 0 || number >> bits != 0)
      throw std::out_of_range("search: a version that cannot be");
    value_ = value_ << bits | static_cast<std::uint64_t>(number);
  }
  void add(const Incarnation& who) {
    add(value(who.peer), 3);
    add(who.number, 8);
  }
  std::uint64_t value_ = 0;
};

Packed packTenure(const Version& version) {
  Packed packed;
  packed.add(version.generation.foundedUs, 8);
  packed.add(version.term, 6);
  packed.add(version.adopter);
  packed.add(version.epoch, 6);
  return packed;
}

}  // namespace

Word Versions::number(const Version& version) {
  Packed packed = packTenure(version);
  const std::uint64_t tenure = packed.value_;
  packed.add(version.owner);
  packed.add(version.step + 1, 6);
  const auto [entry, isNew] =
      numbers_.try_emplace(packed.value_, static_cast<Word>(versions_.size()));
  if (isNew) {
    if (versions_.size() >= kMaxVersions) throw std::out_of_range("search: too many versions");
    versions_.push_back(version);
    founded_.push_back(static_cast<std::uint8_t>(version.generation.foundedUs));
    tenures_.push_back(
        tenureNumbers_.try_emplace(tenure, static_cast<Word>(tenureNumbers_.size())).first->second);
  }
  return entry->second;
}

Knowledge::Knowledge(std::span<const Word> words) {
  std::copy_n(words.begin(), kMaxPeers, records.begin());
  messageCount = static_cast<Word>(words.size() - kMaxPeers);
  std::copy(words.begin() + kMaxPeers, words.end(), messageWords.begin());
}

Knowledge& Knowledge::operator=(const Knowledge& other) {
  records = other.records;
  messageCount = other.messageCount;
  std::copy_n(other.messageWords.begin(), messageCount, messageWords.begin());
  return *this;
}

bool Knowledge::operator==(const Knowledge& other) const {
  return records == other.records && std::ranges::equal(messages(), other.messages());
}

void Knowledge::send(Word message) {
  Word* const end = messageWords.data() + messageCount;
  Word* const place = std::lower_bound(messageWords.data(), end, message);
  if (place != end && *place == message) return;
  if (messageCount == kMaxMessages) throw std::out_of_range("search: too many messages");
  std::copy_backward(place, end, end + 1);
  *place = message;
  ++messageCount;
}

void Knowledge::appendTo(std::vector<Word>& words) const {
  words.insert(words.end(), records.begin(), records.end());
  words.insert(words.end(), messageWords.begin(), messageWords.begin() + messageCount);
}

}  // namespace wells
