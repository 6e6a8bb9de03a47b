#include "planted/catching.h"
#include "planted/choice.h"
#include "search/search.h"

namespace wells::planted {

std::optional<Catch> search(int number) {
  choice = number;
  Search search({.peers = 3,
                 .balls = 1,
                 .epochs = 2,
                 .terms = 2,
                 .suspicions = 1,
                 .crashes = 1,
                 .restarts = 1,
                 .fences = 0,
                 .foundings = 1},
                {});
  const Result result = search.run();
  choice = 0;
  if (result.outcome != Outcome::Violated) return std::nullopt;
  return Catch{result.violation, result.progress.states};
}

}  // namespace wells::planted
