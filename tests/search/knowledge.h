// What everybody knows of one ball, and what the network may still tell: the other half of a state
// of the search. Versions are numbered, so that a record or a message is a 16-bit word.
//
// The network is the set of all messages that were ever sent. Each may come to anybody at any time,
// in any order, again, or never: loss, delay, duplication, reordering and replay are all in that.
// Who sent a message does not matter to what it does here, so that an offer that is repeated by
// another peer is the same message. A peer refuses more than is refused here (unknown, silent or
// dead senders, numbers that it has seen); the search lets all of that through.
//
// Steps are all 0. Within a tenure the offer has the least step, and states only higher ones; the
// comparison of versions gets to the steps only within a tenure. So "state of the tenure heard" is
// all that steps decide, and with equal steps learnState() decides the same by Standing.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "ownership/records.h"
#include "search/group.h"

namespace wells {

using Word = std::uint16_t;

/// Whether a record of Standing::Named is acted upon: its holder made the offer or heard it while
/// it was active, and so repeats it, or takes the ball when the offer's step has come.
enum class Offer : std::uint8_t { Closed, Open };

struct Entry {
  Record record{};
  Offer offer = Offer::Closed;
};

enum class News : std::uint8_t { State, Offer };

struct Telling {
  News news = News::State;
  Version version{};
};

/// Numbers of versions, from 1, in the order in which they are met.
class Versions {
 public:
  /// Throws std::out_of_range for a version that the search cannot make.
  Word number(const Version& version);
  const Version& operator[](Word number) const { return versions_[number]; }
  /// Equal for versions of the same tenure.
  Word tenure(Word number) const { return tenures_[number]; }
  /// Rank of its generation's founding.
  std::uint8_t founded(Word number) const { return founded_[number]; }
  /// Who began its term, counted from 0; -1: nobody.
  int adopter(Word number) const { return value(versions_[number].adopter.peer) - 1; }

 private:
  std::vector<Version> versions_{1};
  std::vector<Word> tenures_{0};
  std::vector<std::uint8_t> founded_{0};
  std::unordered_map<std::uint64_t, Word> numbers_, tenureNumbers_;
};

struct Knowledge {
  static constexpr std::size_t kMaxMessages = 93;

  std::array<Word, kMaxPeers> records{};  // 0: no record
  Word messageCount = 0;
  std::array<Word, kMaxMessages> messageWords;  // rising

  Knowledge() = default;
  explicit Knowledge(std::span<const Word> words);
  Knowledge(const Knowledge& other) { *this = other; }
  Knowledge& operator=(const Knowledge& other);

  bool operator==(const Knowledge& other) const;

  std::span<const Word> messages() const { return {messageWords.data(), messageCount}; }
  /// Adds a message if it is not there.
  void send(Word message);
  /// All of it.
  void appendTo(std::vector<Word>& words) const;
};

// A record's word: version, then whether it is open and heard. A message's: version, then its kind.
inline constexpr Word kHeardBit = 1, kOpenBit = 2;
inline Word versionOfRecord(Word word) {
  return word >> 2;
}
inline Word versionOfMessage(Word word) {
  return word >> 1;
}
inline News newsOf(Word message) {
  return message & 1 ? News::Offer : News::State;
}

}  // namespace wells
