// gravity-wells-search: all that can happen to the ownership of balls, within limits.
#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "search/search.h"

int main(int argc, char** argv) {
  using namespace wells;
  Limits limits;
  double gibibytes = 12;
  CLI::App app(
      "Searches all interleavings of the ownership rules for a violation. Exit status: 0 closed "
      "without one, 1 a violation (its shortest trace is printed), 2 a wrong option, 3 out of time "
      "or "
      "memory.");
  app.option_defaults()->always_capture_default();
  app.add_option("--peers", limits.peers, "peers")->check(CLI::Range(2, kMaxPeers));
  app.add_option("--balls", limits.balls, "balls")->check(CLI::Range(1, 2));
  app.add_option("--epochs", limits.epochs, "epochs of a term")->check(CLI::Range(1, 8));
  app.add_option("--terms", limits.terms, "terms of a generation")->check(CLI::Range(1, 8));
  app.add_option("--suspicions", limits.suspicions, "false suspicions")->check(CLI::Range(0, 9));
  app.add_option("--crashes", limits.crashes, "crashes")->check(CLI::Range(0, 9));
  app.add_option("--restarts", limits.restarts, "restarts")->check(CLI::Range(0, 3));
  app.add_option("--fences", limits.fences, "peers that stand still and start over")
      ->check(CLI::Range(0, 3));
  app.add_option("--foundings", limits.foundings, "generations that are founded")
      ->check(CLI::Range(1, kMaxGenerations));
  app.add_option("--resets", limits.resets, "times that the world is started over")
      ->check(CLI::Range(0, kMaxGenerations - 1));
  bool everyOrder = false;
  app.add_flag("--every-order", everyOrder,
               "each hearing of a message is a step of its own: slow, and finds the same");
  app.add_option("--seconds", limits.seconds, "time limit, s")->check(CLI::PositiveNumber);
  app.add_option("--memory", gibibytes, "memory limit of the tables, GiB")
      ->check(CLI::PositiveNumber);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (limits.restarts + limits.fences > 3) {
    fmt::print(stderr, "--restarts and --fences are {} together; at most 3 are allowed\n",
               limits.restarts + limits.fences);
    return 2;
  }
  if (limits.foundings + limits.resets > kMaxGenerations) {
    fmt::print(stderr, "--foundings and --resets are {} together; at most {} are allowed\n",
               limits.foundings + limits.resets, kMaxGenerations);
    return 2;
  }
  if (everyOrder) limits.hearing = Hearing::AtAnyTime;
  limits.memory = static_cast<std::size_t>(gibibytes * 1024 * 1024 * 1024);

  Search search(limits, {});
  const Result result = search.run([](const Progress& now) {
    fmt::print(stderr,
               "\r{:6.0f} s  depth {:3}  states {:11}  left {:11}  transitions {:12}  groups {:7}  "
               "{:5.2f} GiB ",
               now.seconds, now.depth, now.states, now.states - now.expanded, now.transitions,
               now.groups, static_cast<double>(now.bytes) / (1 << 30));
  });
  fmt::print(stderr, "\n");
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const Progress& end = result.progress;
  fmt::print(
      "peers {}, balls {}, epochs {}, terms {}, suspicions {}, crashes {}, restarts {}, fences {}, "
      "foundings {}, resets {}\n",
      limits.peers, limits.balls, limits.epochs, limits.terms, limits.suspicions, limits.crashes,
      limits.restarts, limits.fences, limits.foundings, limits.resets);
  fmt::print("outcome               {}\n", name(result.outcome));
  fmt::print("states                {}\n", end.states);
  fmt::print("transitions           {}\n", end.transitions);
  fmt::print("depth                 {}\n", end.depth);
  fmt::print("groups                {}\n", end.groups);
  fmt::print("knowledge of a ball   {}\n", end.knowledge);
  fmt::print("cases of a ball       {}\n", end.cases);
  fmt::print("time                  {:.1f} s\n", end.seconds);
  fmt::print("peak memory           {:.2f} GiB\n",
             static_cast<double>(usage.ru_maxrss) / (1024 * 1024));
  fmt::print("violations            {}\n", result.violation.empty() ? 0 : 1);
  if (!result.violation.empty())
    fmt::print("\nviolation: {}\n\n{}", result.violation, result.trace);
  switch (result.outcome) {
    case Outcome::Closed:
      return 0;
    case Outcome::Violated:
      return 1;
    default:
      return 3;
  }
}
