#include "clocks.h"

#include <chrono>

namespace wells {

Times readClocks() {
  using namespace std::chrono;
  return {.monotonic = duration<double>(steady_clock::now().time_since_epoch()).count(),
          .wallUs = duration_cast<microseconds>(system_clock::now().time_since_epoch()).count()};
}

}  // namespace wells
