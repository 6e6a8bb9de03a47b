#include "interrupt.h"

#include <signal.h>

namespace wells {
namespace {

volatile sig_atomic_t signalled = 0;

void note(int) {
  signalled = 1;
}

}  // namespace

void catchInterrupts() {
  struct sigaction action {};
  action.sa_handler = note;
  sigemptyset(&action.sa_mask);
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  ::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of the write
}

bool interrupted() {
  return signalled != 0;
}

}  // namespace wells
