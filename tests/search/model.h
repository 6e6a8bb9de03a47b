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
#include <optional>
#include <string>
#include <vector>

#include "search/group.h"
#include "search/knowledge.h"
#include "search/limits.h"
#include "search/numbering.h"
#include "search/transitions.h"

namespace wells {

/// Thrown when the rules break a promise.
struct Flaw {
  std::string what;
  std::optional<Event> event{};  // in which it shows; nothing: the state itself is wrong ...
  std::optional<std::array<Word, kMaxPeers>> heard{};  // ... when the peers have heard so much
};

struct BallMove {
  Event event;
  Knowledge to;
  Group group;  // the same but for a suspicion
};

class Model {
 public:
  Model(const Limits& limits, const Protocol& protocol) : limits_(limits), protocol_(protocol) {}

  std::vector<GroupMove> groupMoves(const Group& group) const {
    return movesOf(group, limits_, protocol_.conduct);
  }

  /// What may become of a ball when `from` moves to `to` by `event`; replaces `moves`. None when
  /// the ball, or a limit, forbids that.
  void follow(const Group& from, const Group& to, const Event& event, const Knowledge& ball,
              std::vector<BallMove>& moves);

  /// What may happen to a ball while the group stays as it is, suspicions aside; adds to `moves`.
  void ballMoves(const Group& group, const Knowledge& ball, std::vector<BallMove>& moves);

  /// Throws Flaw when a state is wrong:
  ///  - two owners of one tenure among all records and messages;
  ///  - two peers that act as owners in one term of one adopter; or, as long as the group is calm,
  ///    at all;
  ///  - an active peer without a sensible record of the ball;
  ///  - a group that does not heal (healing.h).
  void check(const Group& group, const Knowledge& ball);

  /// Different states of one ball that were checked: who is what, and has which record.
  std::size_t checked() const { return checked_.size(); }
  std::size_t bytes() const { return checked_.bytes(); }

  Entry entry(Word record) const;
  Telling telling(Word message) const;

 private:
  using Words = std::vector<Word>;
  using Core = std::array<std::uint16_t, 10>;

  Word wordOf(const Entry& entry);
  Word raised(Word before, const Entry& entry);
  void send(Knowledge& ball, News news, const Version& version);
  void publish(const Group& group, int peer, Knowledge& ball);
  void begin(const Group& group, int peer, const Record& next, Knowledge& ball);
  bool adopt(const Group& group, int peer, Life life, Knowledge& ball);
  Word learn(Word record, Word message);
  Word hear(const Group& group, int peer, Word record, Word message);
  void hearAll(const Group& group, int peer, Word record, std::span<const Word> messages,
               Words& records);
  void activate(const Group& from, const Group& to, const Event& event, const Knowledge& ball,
                std::vector<BallMove>& moves);
  void prune(const Group& group, Knowledge& ball);

  void hear(const Group& group, int peer, const Knowledge& ball, std::vector<BallMove>& moves);
  void act(const Group& group, int peer, const Knowledge& ball, std::vector<BallMove>& moves);
  void offer(const Group& group, int peer, const Knowledge& ball, std::vector<BallMove>& moves);

  void checkTenures(const Knowledge& ball) const;
  void checkCore(const Group& group, const std::array<Word, kMaxPeers>& records);

  Limits limits_;
  Protocol protocol_;
  Versions versions_;
  std::vector<Words> learned_;  // by record, then message
  Numbering<Core> checked_;
  Words records_;
};

}  // namespace wells
