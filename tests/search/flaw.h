// A broken promise.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "search/group.h"
#include "search/knowledge.h"

namespace wells {

/// Thrown when the rules break a promise.
struct Flaw {
  std::string what;
  std::optional<Event> event{};  // in which it shows; nothing: the state itself is wrong ...
  std::optional<std::array<Word, kMaxPeers>> heard{};  // ... when the peers have heard so much
};

inline void require(bool holds, const char* what) {
  if (!holds) throw Flaw{what};
}

/// Names the event in which a flaw shows.
template <class Action>
void during(const Event& event, const Action& action) {
  try {
    action();
  } catch (Flaw& flaw) {
    flaw.event = event;
    throw;
  }
}

}  // namespace wells
