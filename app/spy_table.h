// The sessions on a group as text for an 80-column terminal. Pure: what is known in, lines out.
#pragma once

#include <span>
#include <string>

#include "session_watch.h"

namespace wells {

inline constexpr std::size_t kSpyColumns = 80;

/// `now` in s, by the clock that the watch was given; `quiet`: s since any peer was heard, or since
/// listening began. Each line ends with a newline and is no longer than kSpyColumns.
std::string spyTable(std::span<const WatchedSession> sessions, double now, double quiet);

}  // namespace wells
