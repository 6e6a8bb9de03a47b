// Where threads run and what they are called, as the system sees them.
#pragma once

#include <span>
#include <string>
#include <thread>
#include <vector>

namespace wells {

/// The cores on which this thread may run (the system counts logical ones, from 0), rising.
std::vector<int> allowedCores();

/// From now on `thread` runs on these cores only. False: the system does not let it, and nothing
/// has changed.
bool pinThread(std::thread::native_handle_type thread, std::span<const int> cores);

/// From now on this thread, and those that it starts, run on these cores only. False: the system
/// does not let it, and nothing has changed.
bool pinThisThread(std::span<const int> cores);

/// For top -H and debuggers; what is longer than 15 bytes is cut.
void nameThisThread(const std::string& name);

}  // namespace wells
