#include "search/search.h"
#include "planted/catching.h"
#include "planted/choice.h"

namespace wells::planted {

Searched search(const Defect& defect) {
  choice = defect.number;
  const Limits limits{.peers = 3,
                      .balls = 1,
                      .epochs = 2,
                      .terms = 2,
                      .suspicions = 1,
                      .crashes = 1,
                      .restarts = 1,
                      .fences = 0,
                      .foundings = 1};
  const Result result = Search(limits, {}).run();
  choice = 0;
  Searched searched{result.progress.states, std::nullopt};
  if (result.outcome == Outcome::Violated) searched.caught = {result.violation, result.trace};
  return searched;
}

}  // namespace wells::planted
