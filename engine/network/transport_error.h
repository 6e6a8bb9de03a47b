// The network cannot be used as asked. what() names the reason and, where there is one, the command
// that mends it.
#pragma once

#include <stdexcept>

namespace wells {

class TransportError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace wells
