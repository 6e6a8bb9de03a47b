// Breadth-first search through everything that can happen to a group and its balls, within limits.
// States are kept whole and compared whole, so that none is ever missed: a state is the number of
// its group and that of each ball's knowledge. Balls are alike, so their order does not count.
#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "search/model.h"
#include "search/numbering.h"

namespace wells {

enum class Outcome : std::uint8_t { Closed, Violated, OutOfTime, OutOfMemory };

constexpr std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::Closed:
      return "closed";
    case Outcome::Violated:
      return "violated";
    case Outcome::OutOfTime:
      return "out of time";
    case Outcome::OutOfMemory:
      return "out of memory";
  }
  return "unknown";
}

struct Progress {
  std::size_t states = 0;
  std::size_t expanded = 0;
  std::size_t transitions = 0;
  int depth = 0;
  std::size_t groups = 0;
  std::size_t knowledge = 0;  // of a ball, distinct
  std::size_t cases = 0;      // Model::cases()
  double seconds = 0;
  std::size_t bytes = 0;  // of the tables
};

struct Result {
  Outcome outcome = Outcome::Closed;
  Progress progress;
  std::string violation;  // what was broken; empty: nothing
  std::string trace;      // how it comes to that, in the fewest events
};

class Search {
 public:
  Search(const Limits& limits, const Protocol& protocol);

  /// Calls `report` every few seconds.
  Result run(const std::function<void(const Progress&)>& report = {});

 private:
  static constexpr int kMaxBalls = 2;
  struct State {
    std::uint32_t group = 0;
    std::array<std::uint32_t, kMaxBalls> balls{};  // rising
    bool operator==(const State&) const = default;
  };
  struct Pair {
    std::uint32_t group = 0, ball = 0;
    bool operator==(const Pair&) const = default;
  };
  /// What may happen to one ball in a group. For each of the group's steps: how many balls may come
  /// of it, and these; then for each step of its own: the group and the ball.
  using Row = std::vector<std::uint32_t>;

  std::uint32_t ballNumber(const Knowledge& ball);
  std::span<const std::uint32_t> stepsOfBall(const Pair& pair, int place);
  void computeSteps(const Pair& pair, Row& row);
  bool isWorthwhile(const GroupStep& step, const State& state) const;
  void expand(std::uint32_t number);
  void add(State state, std::uint32_t parent);
  void flush();
  Progress progress() const;
  std::size_t bytes() const;
  using Names = std::array<int, kMaxBalls>;  // of the balls at a state's places
  struct TraceStep {
    Event event{};
    std::optional<int> ball{};
    Word record = 0;  // of the ball, at the one who does it
  };
  TraceStep stepBetween(const State& from, const State& to, Names& names);
  std::string trace(std::uint32_t number, const Flaw& flaw, int place);

  Limits limits_;
  Model model_;
  RowNumbering balls_;
  Numbering<State> states_;
  Chunks<std::uint32_t> parents_;
  Numbering<Pair> pairs_;
  Chunks<std::uint32_t> pairSteps_;
  Chunks<std::span<const std::uint32_t>> pairRows_;

  // Reused.
  std::array<Row, kMaxBalls> rows_;
  std::vector<BallMove> moves_;
  std::vector<Word> words_;
  struct Pending {
    State state;
    std::uint32_t parent = 0;
    std::uint64_t hash = 0;
  };
  std::vector<Pending>
      pending_;  // states to be entered, many at a time to hide the memory's latency

  std::size_t transitions_ = 0;
  std::size_t expanded_ = 0;
  int depth_ = 0;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace wells
