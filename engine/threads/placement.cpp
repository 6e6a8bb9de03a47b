#include "threads/placement.h"

#include <pthread.h>
#include <sched.h>

namespace wells {

std::vector<int> allowedCores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  ::sched_getaffinity(0, sizeof set, &set);
  std::vector<int> cores;
  for (int core = 0; core < CPU_SETSIZE; ++core)
    if (CPU_ISSET(core, &set)) cores.push_back(core);
  return cores;
}

bool pinThread(std::thread::native_handle_type thread, std::span<const int> cores) {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int core : cores) {
    if (core < 0 || core >= CPU_SETSIZE) return false;
    CPU_SET(core, &set);
  }
  return ::pthread_setaffinity_np(thread, sizeof set, &set) == 0;
}

bool pinThisThread(std::span<const int> cores) {
  return pinThread(::pthread_self(), cores);
}

void nameThisThread(const std::string& name) {
  constexpr std::size_t kLongest = 15;  // the system refuses more
  ::pthread_setname_np(::pthread_self(), name.substr(0, kLongest).c_str());
}

}  // namespace wells
