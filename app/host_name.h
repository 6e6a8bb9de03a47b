// Who and where we are, for others to read: printable ASCII only.
#pragma once

#include <string>

namespace wells {

/// This machine's.
std::string hostName();

/// "ann@lab1", at most `most` bytes.
std::string userAtHost(std::size_t most);

}  // namespace wells
