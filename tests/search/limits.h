// How much the search lets happen. Everything that could go on for ever has a bound here; within
// the bounds the search is complete.
#pragma once

#include <cstddef>
#include <cstdint>

namespace wells {

/// When a message that came is heeded; model.h says why the second is enough.
enum class Hearing : std::uint8_t {
  AtAnyTime,      // every interleaving is a path of its own
  BeforeActions,  // just before something is done that depends on it
};

/// Which promises are held to.
enum class Promises : std::uint8_t {
  All,
  Safety,  // not that every state heals
};

struct Limits {
  int peers = 3;  // 2 .. 3
  int balls = 1;  // 1 .. 2; one stands for any number (model.h)

  int epochs = 3;      // of a term, counted from 0: one hand-over less. >= 1
  int terms = 2;       // of a generation, counted from 0: one adoption in a row less. >= 1
  int suspicions = 2;  // of incarnations that live: one listener's lease of one incarnation ends
  int crashes = 1;     // a leave is the same thing (group.h)
  int restarts = 1;    // of peers that crashed; restarts + fences <= 3
  int fences = 0;      // a peer starts over with a new incarnation: it stood still, or nobody is
                       // left in its generation
  int foundings = 1;   // by peers that heard nobody, >= 1
  int resets = 0;      // by active peers; foundings + resets <= 3

  Promises promises = Promises::All;
  Hearing hearing = Hearing::BeforeActions;
  double seconds = 600;
  std::size_t memory = std::size_t{12} << 30;  // bytes
};

}  // namespace wells
