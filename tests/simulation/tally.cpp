#include "simulation/tally.h"

#include <algorithm>

namespace wells::simulation {

Tally& Tally::operator+=(const Tally& other) {
  leastHandovers =
      runs == 0 ? other.leastHandovers : std::min(leastHandovers, other.leastHandovers);
  runs += other.runs;
  seconds += other.seconds;
  messagesSent += other.messagesSent;
  messagesReceived += other.messagesReceived;
  messagesLostInBuffers += other.messagesLostInBuffers;
  messagesRefused += other.messagesRefused;
  handovers += other.handovers;
  adoptions += other.adoptions;
  fences += other.fences;
  resyncs += other.resyncs;
  ballSeconds += other.ballSeconds;
  doubledBallSeconds += other.doubledBallSeconds;
  groupChecks += other.groupChecks;
  incomplete += other.incomplete;
  for (std::size_t kind = 0; kind < kFaultKinds; ++kind) {
    faults[kind] += other.faults[kind];
    for (std::size_t state = 0; state < kPeerStates; ++state)
      coverage[kind][state] += other.coverage[kind][state];
  }
  return *this;
}

}  // namespace wells::simulation
