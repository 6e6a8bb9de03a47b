// One run of a schedule: the loop over what happens next, the faults, and what is watched.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "simulation/process.h"
#include "simulation/simulator.h"
#include "simulation/wire.h"

namespace wells::simulation {

class Run {
 public:
  Run(const Schedule& schedule, Trace::Keeping keeping);
  Outcome outcome();

 private:
  using Bytes = std::span<const std::byte>;

  // run.cpp: what happens next.
  void run();
  bool isOver() const;
  double nextTime() const;
  void advanceTo(double time);
  void beginFaults();
  void endFaults();
  void heal();
  void stopWhenSeenEnough();
  void endPause();
  void stop();
  void tick(Process& process);
  void receive(Process& process);
  void bury();

  // run_faults.cpp: what goes wrong.
  void strikeWhenReady(Process& process);
  void strike(const Fault& fault, Process& process);
  void strikeNetwork(const Fault& fault);
  void last(const Fault& fault);
  void restore(const Fault& fault);
  void start(int slot, FaultKind kind);
  void launch(int slot, PeerId id);
  void kill(Process& process, const Fault& fault);
  void comeBack(const Process& process);
  void count(FaultKind kind, const Process& hit);
  void countAll(FaultKind kind, const Process* except);
  void applyToWire();
  std::vector<const Process*> oneOfEachGeneration() const;
  void ask(std::string_view key, const std::string& value);
  void ask(const Process& member, std::string_view key, const std::string& value);
  void askToReset();
  PeerStates statesOf(const Process& process) const;
  Process* inSlot(int slot);

  // run_watch.cpp: what is seen.
  bool sending(Process& process, std::string_view channel, Bytes bytes);
  bool sent(Process& process, std::string_view channel, Bytes bytes);
  void received(Process& process, std::string_view channel, Bytes bytes);
  void claims(Process& process, const Message& message);
  void answer(std::size_t ball, const Version& version);
  void observe(Process& process);
  void noteChanges(Process& process);
  void checkGroups();
  bool isAwake(const Process& process, double seconds) const;
  bool haveHeardEachOther(const Process& a, const Process& b, double seconds) const;
  /// The same, without a silence that hides where a well went.
  bool areClose(const Process& a, const Process& b, double seconds) const;
  std::vector<PeerView> views() const;
  void countDoubled(double seconds);
  void addCounts(const Process& process);

  Schedule schedule_;
  Trace trace_;
  Wire wire_;
  Invariants invariants_;
  Tally tally_;
  double now_ = 0;  // s
  std::vector<std::unique_ptr<Process>> processes_;
  int started_ = 0;                     // processes so far
  std::map<int, double> clockOffsets_;  // s, by slot
  std::size_t nextFault_ = 0;
  std::vector<Fault> waiting_;          // for their state, until at + kPatience
  std::vector<Fault> lasting_;          // until at + duration
  std::vector<Fault> comebacks_;        // of peers that have died or left
  std::int64_t nextAsked_ = 0;          // number of the next request
  std::optional<std::int64_t> stopAt_;  // step
  bool isForged_ = false;               // some messages are not honest
  bool isHealed_ = false;
  static constexpr int kMostExtensions = 20;
  double nextEndOfPause_ = 0;  // s
  int extensions_ = 0;         // of the run
  bool isStopped_ = false;
  bool isComplete_ = false;
};

}  // namespace wells::simulation
