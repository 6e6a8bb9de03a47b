#include "state/contact_shares.h"

namespace wells {
namespace {

double share(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0;
}

}  // namespace

void ContactShares::add(const StepCounts& step, std::size_t balls) {
  ballSteps += static_cast<std::int64_t>(balls);
  exactBalls += step.exactBalls;
  substepBalls += step.substepBalls;
  asleepBalls += step.asleep;
  impacts += step.impacts;
  clusters += step.clusters;
  handedOver += step.handedOver;
  directContacts += step.directContacts;
  unsolvedIslands += step.unsolvedIslands;
}

double ContactShares::exact() const {
  return share(exactBalls, ballSteps);
}

double ContactShares::substep() const {
  return share(substepBalls, ballSteps);
}

double ContactShares::asleep() const {
  return share(asleepBalls, ballSteps);
}

}  // namespace wells
