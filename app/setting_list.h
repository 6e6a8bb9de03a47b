// What is set in a session, as text. Pure.
#pragma once

#include <string>

#include "session_watch.h"

namespace wells {

/// The session, each key that it obeys with what holds, since when and by whom, and what is to
/// come. Lines that each end with a newline. `now` in s, by the clock that the watch was given.
std::string settingList(const WatchedSession& session, double now);

}  // namespace wells
