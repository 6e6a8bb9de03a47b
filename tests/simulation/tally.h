// What happened in a run, or in many: counts that add up.
#pragma once

#include <array>
#include <cstdint>

#include "simulation/fault.h"

namespace wells::simulation {

/// How often each kind of fault hit a peer that was in each state.
using Coverage = std::array<std::array<std::int64_t, kPeerStates>, kFaultKinds>;

struct Tally {
  std::int64_t runs = 0;
  double seconds = 0;  // simulated
  std::int64_t messagesSent = 0;
  std::int64_t messagesReceived = 0;
  std::int64_t messagesLostInBuffers = 0;
  std::int64_t messagesRefused = 0;
  std::int64_t handovers = 0;       // balls taken
  std::int64_t leastHandovers = 0;  // of a run
  std::int64_t adoptions = 0;
  std::int64_t fences = 0;
  std::int64_t resyncs = 0;
  double ballSeconds = 0;         // in which at least one peer ran
  double doubledBallSeconds = 0;  // more than one peer acted as owner
  std::int64_t groupChecks = 0;   // of peers that had heard each other for two leases
  std::int64_t incomplete = 0;    // runs that could not be compared at the end
  std::array<std::int64_t, kFaultKinds> faults{};
  Coverage coverage{};

  Tally& operator+=(const Tally& other);
};

}  // namespace wells::simulation
