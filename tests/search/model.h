// All that can happen to a ball in a group, and what must hold at all times. The rules themselves
// are the real ones (transitions.h).
//
// The balls do not touch each other: a ball's moves depend on the group and on that ball, and the
// group heeds the balls only where a peer becomes active, for which it must have heard of every one
// of them. So whatever a ball goes through among many, it can go through alone: what holds for one
// ball in every state of a search with one ball holds for each of any number of them. The search
// with two balls checks this argument, and nothing else.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "search/group.h"
#include "search/knowledge.h"
#include "search/limits.h"
#include "search/transitions.h"

namespace wells {

/// Thrown when the rules break a promise.
struct Flaw {
  std::string what;
  std::optional<Event> event;  // in which it shows; nothing: the state itself is wrong
};

struct BallMove {
  Event event;
  Knowledge to;
};

class Model {
 public:
  Model(const Limits& limits, const Protocol& protocol) : limits_(limits), protocol_(protocol) {}

  std::vector<GroupMove> groupMoves(const Group& group) const {
    return movesOf(group, limits_, protocol_.conduct);
  }

  /// What becomes of a ball when the group moves to `to` by `event`. Nothing when the ball, or a
  /// limit, forbids that.
  std::optional<Knowledge> follow(const Group& to, const Event& event, const Knowledge& before);

  /// What may happen to a ball while the group stays as it is; replaces `moves`.
  void ballMoves(const Group& group, const Knowledge& ball, std::vector<BallMove>& moves);

  /// Throws Flaw when a state is wrong:
  ///  - two owners of one tenure among all records and messages;
  ///  - two peers that act as owners in one term of one adopter; or, as long as the group is calm,
  ///  at
  ///    all;
  ///  - an active peer without a sensible record of the ball.
  void check(const Group& group, const Knowledge& ball) const;

  Entry entry(const Knowledge& ball, int peer) const;
  Telling telling(Word message) const;

 private:
  using Step = std::optional<Record>;
  void set(Knowledge& ball, int peer, const Entry& entry);
  void raise(Knowledge& ball, int peer, const Entry& entry);
  void send(Knowledge& ball, News news, const Version& version);
  void publish(const Group& group, int peer, Knowledge& ball);
  void begin(const Group& group, int peer, const Record& next, Knowledge& ball);
  void beginTenure(const Record& before, const Record& next) const;
  bool adopt(const Group& group, int peer, Knowledge& ball);
  Word learn(Word record, Word message);
  void prune(const Group& group, Knowledge& ball);

  void hear(const Group& group, int peer, const Knowledge& ball, std::vector<BallMove>& moves);
  void own(const Group& group, int peer, const Knowledge& ball, std::vector<BallMove>& moves);
  void offer(const Group& group, int peer, const Knowledge& ball, std::vector<BallMove>& moves);

  Limits limits_;
  Protocol protocol_;
  Versions versions_;
  std::unordered_map<std::uint32_t, Word> learned_;  // by record and message
};

}  // namespace wells
