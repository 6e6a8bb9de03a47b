// What a run of a peer measured, and its JSON form for --report. Data only.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "state/contact_shares.h"
#include "thread_places.h"

namespace wells {

/// Of one loop, Hz.
struct LoopRate {
  double target = 0;  // 0: none
  double actual = 0;  // mean over the run; 0: the loop did not run
};

/// How the settings were chosen, with --target-error.
struct TrialReport {
  double targetError = 0;  // m
  double error = 0;        // m, of the choice in the trial
  double duration = 0;     // s, of the trial
  int substeps = 0;        // chosen; the rest of the choice is what the run has
};

struct RunReport {
  std::string engine;
  std::string integrator;
  std::string contacts;      // method
  double dt = 0;             // s
  int threads = 1;           // the most that a step ran on
  std::string instructions;  // of the processor, see math/instruction_set.h
  ThreadPlaces places;
  std::optional<TrialReport> trial;

  std::int64_t steps = 0;    // the world's step at the end
  double simulatedTime = 0;  // s, at the end
  double wallTime = 0;       // s, from the first tick to the last
  double energyStart = 0;    // J, kinetic and potential, of all balls
  double energyEnd = 0;      // J
  double maxOverlap = 0;     // m, worst of the start, of each simulated second, and of the end
  std::int64_t escaped = 0;  // balls, at the end
  std::string stateHash;
  std::int64_t latePairs = 0;
  ContactShares shares;
  std::int64_t flightStretches = 1;        // most into which the flight of a step was divided
  std::vector<std::uint32_t> quarantined;  // balls whose state is not finite, at the end
  std::optional<Books> books;              // since the start, with --measures

  std::string transport = "none";
  std::int64_t peer = 0;
  std::vector<std::int64_t> peers;              // living ones at the end, this one included
  std::map<std::int64_t, std::int64_t> owners;  // peer -> balls that it owns, at the end
  std::int64_t ballsOwned = 0;                  // by this peer, at the end
  std::int64_t ballsOwnedMax = 0;               // by this peer, at any time
  std::int64_t handoversGiven = 0;              // balls
  std::int64_t handoversTaken = 0;              // balls
  std::int64_t adoptions = 0;                   // balls
  double doubledBallSeconds = 0;                // simulated here and by an adopter who won
  std::int64_t fences = 0;                      // times that this peer stood still for too long
  std::int64_t resyncs = 0;                     // times that it joined another session
  double viewDifference = 0;                    // m, largest at equal step
  std::string generation;
  bool complete = true;  // at the end every ball had its owner's last state
  std::int64_t messagesSent = 0;
  std::int64_t messagesReceived = 0;  // accepted
  std::int64_t messagesDropped = 0;
  std::int64_t droppedByKernel = 0;
  std::int64_t droppedInQueue = 0;
  std::int64_t droppedByChecks = 0;
  std::vector<std::pair<std::string, std::int64_t>> dropsByReason;
  std::int64_t bytesSent = 0;
  std::int64_t bytesReceived = 0;

  LoopRate simulation;
  LoopRate network;
  LoopRate graphics;
  std::int64_t framesDrawn = 0;
  std::int64_t framesRepeated = 0;

  Balls balls;  // at the end, for --state-out; not part of the JSON
};

/// Pretty-printed, with a last line end.
std::string reportAsJson(const RunReport& report);

/// What a person wants to know at the end of a run: a few lines.
std::string reportAsText(const RunReport& report);

}  // namespace wells
