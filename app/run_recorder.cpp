#include "run_recorder.h"

#include <algorithm>

#include "math/instruction_set.h"
#include "world/measures.h"

namespace wells {

RunRecorder::RunRecorder(const PeerOptions& options, Pictures* pictures, RunProgress& progress)
    : options_(options), pictures_(pictures), progress_(progress) {
  report_.engine = options.engine;
  report_.instructions = name(instructionSet());
  report_.peer = options.config.peerId;
}

void RunRecorder::begin(const World& world) {
  report_.dt = world.settings.dt;
  progress_.firstStep = progress_.step = world.step;
  if (measures()) report_.energyStart = measure(world).energy();
  sample(world);
}

void RunRecorder::sample(const World& world) {
  sampledSecond_ = static_cast<std::int64_t>(world.time());
  if (measures()) report_.maxOverlap = std::max(report_.maxOverlap, measure(world).worstOverlap());
}

void RunRecorder::show(const World& world, const Owners& owners, WhenBusy whenBusy) {
  if (!pictures_ || !pictures_->isDue(world.time())) return;
  const Pictures::Counts counts = pictures_->counts();
  notes_.graphics = {pictures_->targetRate(), counts.recentRate};
  pictures_->show(world.time(), makeView(world, owners(), notes_), whenBusy);
}

void RunRecorder::stepped(const World& world, const Stepper& stepper) {
  const StepCounts counts = stepper.counts();
  report_.latePairs += counts.latePairs;
  report_.shares.add(counts, world.balls.size());
  report_.threads = std::max(report_.threads, counts.threads);
  report_.flightStretches = std::max(report_.flightStretches, counts.flightStretches);
  progress_.step = world.step;
  if (static_cast<std::int64_t>(world.time()) != sampledSecond_) sample(world);
}

void RunRecorder::end(const World& world, const Stepper& stepper) {
  report_.integrator = stepper.integrator();
  report_.contacts = stepper.contactMethod();
  report_.steps = world.step;
  report_.simulatedTime = world.time();
  report_.stateHash = hashText(stateHash(world));
  report_.balls = world.balls;
  report_.quarantined.assign(stepper.quarantined().begin(), stepper.quarantined().end());
  if (const Books* const books = stepper.books()) report_.books = *books;
  if (!measures()) return;
  const Measures last = measure(world);
  report_.energyEnd = last.energy();
  report_.maxOverlap = std::max(report_.maxOverlap, last.worstOverlap());
  report_.escaped = last.escaped;
}

void RunRecorder::setRates(const LoopRate& simulation, const LoopRate& network) {
  notes_.simulation = simulation;
  notes_.network = network;
}

}  // namespace wells
