// All that can happen to a ball in a group, and what must hold at all times. The rules themselves
// are the real ones (transitions.h).
//
// The balls do not touch each other: a ball's moves depend on the group and on that ball, and the
// group heeds the balls only where a peer becomes active, for which it must have heard of every one
// of them. So whatever a ball goes through among many, it can go through alone: what holds for one
// ball in every state of a search with one ball holds for each of any number of them. The search
// with two balls checks this argument, and nothing else.
//
// Hearing a message changes nothing but the hearer's record of the ball, and the message stays in
// the network: it changes places with everything that others do. So each run can be put in an order
// in which a peer hears nothing until just before it does something with what it has heard, and
// passes through the same doings (Hearing::BeforeActions). What it leaves out are the states in
// between, in which somebody has heard something that it has done nothing with: check() looks at
// all of these as well, for every state it makes one of each choice of what each peer has heard by
// then.
#pragma once

#include <array>
#include <deque>
#include <span>
#include <vector>

#include "search/flaw.h"
#include "search/groups.h"
#include "search/knowledge.h"
#include "search/limits.h"
#include "search/numbering.h"
#include "search/transitions.h"

namespace wells {

struct BallMove {
  Event event;
  Knowledge to;
  std::uint32_t group = 0;  // afterwards
};

class Model {
 public:
  Model(const Limits& limits, const Protocol& protocol)
      : limits_(limits), protocol_(protocol), groups_(limits, protocol.conduct) {}

  Groups& groups() { return groups_; }
  const Groups& groups() const { return groups_; }

  /// What may become of a ball with the group's step of this place; replaces `moves`. None when the
  /// ball, or a limit, forbids the step.
  void follow(std::uint32_t group, std::size_t step, const Knowledge& ball,
              std::vector<BallMove>& moves);

  /// What may happen to a ball while the group stays as it is, suspicions aside; replaces `moves`.
  void ballMoves(std::uint32_t group, const Knowledge& ball, std::vector<BallMove>& moves);

  /// True when a term of the ball was begun by this peer, in whichever incarnation.
  bool hasAdopted(int peer, const Knowledge& ball) const;

  /// Throws Flaw when a state is wrong:
  ///  - two owners of one tenure among all records and messages;
  ///  - two peers that act as owners in one term of one adopter; or, as long as the group is calm,
  ///    at all;
  ///  - an active peer without a sensible record of the ball;
  ///  - a group that does not heal (healing.h).
  void check(std::uint32_t group, const Knowledge& ball);

  /// Different cases that were checked: who is what, and has which record of a ball.
  std::size_t cases() const { return checked_.size(); }
  std::size_t bytes() const;

  Entry entry(Word record) const;
  Telling telling(Word message) const;

 private:
  using Words = std::vector<Word>;

  /// What a peer may do to a ball, whatever the others know of it.
  struct Act {
    Event event;
    Word record = 0, sent = 0;  // its own afterwards; the message, 0: none
    std::uint32_t group = 0;    // afterwards
  };
  using Acts = std::vector<Act>;

  Word wordOf(const Entry& entry);
  Word raised(Word before, const Entry& entry);
  Word messageOf(News news, const Version& version);

  // With the record that the act has at first; they change it.
  void publish(const Party& self, Act& act);
  void begin(const Party& self, const Record& next, Act& act);
  bool adopt(const Party& self, Life life, Act& act);

  const Acts& actsOf(std::uint32_t group, int peer, Word record);
  void tryToTake(const Group& group, int peer, const Act& still, Acts& acts);
  void tryToAdopt(const Group& group, int peer, const Act& still, Acts& acts);
  void tryToPublish(const Group& group, int peer, const Act& still, Acts& acts);
  void tryToWithdraw(const Group& group, int peer, const Act& still, Acts& acts);
  void tryToOffer(const Group& group, int peer, const Act& still, Acts& acts);
  const Acts& resultOf(std::uint32_t group, std::size_t step, Word record);
  void carryOut(const Act& act, const Knowledge& ball, std::vector<BallMove>& moves) const;

  Word learn(Word record, Word message);
  Word hear(const Group& group, int peer, Word record, Word message);
  void hearAll(const Group& group, int peer, Word record, std::span<const Word> messages,
               Words& records);
  void hear(std::uint32_t group, int peer, const Knowledge& ball, std::vector<BallMove>& moves);
  void activate(std::uint32_t group, const GroupStep& step, const Knowledge& ball,
                std::vector<BallMove>& moves);
  void prune(std::uint32_t group, Knowledge& ball);

  void checkTenures(const Knowledge& ball) const;
  void checkCase(const Group& group, const std::array<Word, kMaxPeers>& records);

  Limits limits_;
  Protocol protocol_;
  Groups groups_;
  Versions versions_;

  // The functions are pure: what they return is kept.
  struct ActsKey {
    std::uint32_t group = 0;
    std::uint16_t what = 0;  // a peer, or kMaxPeers + step
    Word record = 0;
    bool operator==(const ActsKey&) const = default;
  };
  Numbering<ActsKey> actsKeys_;
  std::deque<Acts> acts_;
  std::vector<Words> learned_;  // by record, then message

  Numbering<std::uint64_t> checked_;  // core of the group and each peer's record
  RowNumbering choices_;              // of records
  Numbering<std::array<std::uint32_t, 1 + kMaxPeers>> checkedChoices_;  // core, each peer's choices
  std::array<Words, kMaxPeers> records_;
  std::vector<std::uint32_t> marks_ = std::vector<std::uint32_t>(1 << 16);  // by record
  std::uint32_t mark_ = 0;
};

}  // namespace wells
