#include "memory_growth.h"

#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <string_view>

namespace wells {
namespace {

/// MiB, of a line of /proc/self/status, which counts KiB; 0 where there is no such line. It knows
/// of this program alone; rusage counts what the process was before exec(), too.
double processMiB(std::string_view key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) return std::stod(line.substr(key.size())) / 1024;
  return 0;
}

}  // namespace

MemoryGrowth::MemoryGrowth() {
  ::malloc_trim(0);  // else free memory is used again, which is no growth
  std::ofstream("/proc/self/clear_refs") << 5;  // the peak starts from what is there now: proc(5)
  before_ = processMiB("VmRSS:");
}

double MemoryGrowth::most() const {
  return std::max(0.0, processMiB("VmHWM:") - before_);
}

}  // namespace wells
