#include "search/search.h"

#include <algorithm>

#include "search/trace.h"

namespace wells {
namespace {

constexpr std::size_t kLookInterval = 4096;  // states between two looks at time and memory
constexpr std::size_t kBatch = 512;          // states that are entered at a time
constexpr std::size_t kAhead = 8;            // of them, looked up in advance
constexpr double kReportInterval = 5;        // s
constexpr std::size_t kGroupBytes = 1000;    // about so much does a group take, its steps included

/// Thrown with the place of the ball that is wrong.
struct FlawOfBall {
  Flaw flaw;
  int place = 0;
};

}  // namespace

Search::Search(const Limits& limits, const Protocol& protocol)
    : limits_(limits), model_(limits, protocol) {}

std::uint32_t Search::ballNumber(const Knowledge& ball) {
  words_.clear();
  ball.appendTo(words_);
  return balls_.number(words_);
}

void Search::computeSteps(const Pair& pair, Row& row) {
  row.clear();
  const Knowledge ball(balls_[pair.ball]);
  model_.check(pair.group, ball);
  for (std::size_t step = 0; step < model_.groups().steps(pair.group).size(); ++step) {
    model_.follow(pair.group, step, ball, moves_);
    row.push_back(static_cast<std::uint32_t>(moves_.size()));
    for (const BallMove& move : moves_) row.push_back(ballNumber(move.to));
  }
  model_.ballMoves(pair.group, ball, moves_);
  for (const BallMove& move : moves_) {
    row.push_back(move.group);
    row.push_back(ballNumber(move.to));
  }
}

std::span<const std::uint32_t> Search::stepsOfBall(const Pair& pair, int place) {
  Row& row = rows_[place];
  try {
    if (limits_.balls == 1) {
      computeSteps(pair, row);
      return row;
    }
    const std::uint32_t number = pairs_.number(pair);
    if (number > pairRows_.size()) {
      computeSteps(pair, row);
      std::uint32_t* const to = pairSteps_.extend(row.size());
      std::ranges::copy(row, to);
      pairRows_.push_back({to, row.size()});
    }
    return pairRows_[number - 1];
  } catch (const Flaw& flaw) {
    throw FlawOfBall{flaw, place};
  }
}

void Search::add(State state, std::uint32_t parent) {
  if (limits_.balls == 2 && state.balls[0] > state.balls[1])
    std::swap(state.balls[0], state.balls[1]);
  const std::uint64_t hash = Numbering<State>::hashOf(state);
  states_.prefetch(hash);
  pending_.push_back({state, parent, hash});
}

void Search::flush() {
  for (std::size_t i = 0; i < pending_.size(); ++i) {
    if (i + kAhead < pending_.size()) states_.prefetchItem(pending_[i + kAhead].hash);
    const std::size_t before = states_.size();
    states_.number(pending_[i].state, pending_[i].hash);
    if (states_.size() > before) parents_.push_back(pending_[i].parent);
  }
  transitions_ += pending_.size();
  pending_.clear();
}

bool Search::isWorthwhile(const GroupStep& step, const State& state) const {
  if (!step.isReordering) return true;
  return std::any_of(state.balls.begin(), state.balls.begin() + limits_.balls,
                     [&](std::uint32_t ball) {
                       return model_.hasAdopted(step.event.peer, Knowledge(balls_[ball]));
                     });
}

void Search::expand(std::uint32_t number) {
  const State state = states_[number];
  std::array<std::span<const std::uint32_t>, kMaxBalls> rows;
  for (int place = 0; place < limits_.balls; ++place)
    rows[place] = stepsOfBall({state.group, state.balls[place]}, place);

  for (const GroupStep& step : model_.groups().steps(state.group)) {
    std::array<std::span<const std::uint32_t>, kMaxBalls> outcomes;
    for (int place = 0; place < limits_.balls; ++place) {
      outcomes[place] = rows[place].subspan(1, rows[place].front());
      rows[place] = rows[place].subspan(1 + rows[place].front());
    }
    if (!isWorthwhile(step, state)) continue;
    for (const std::uint32_t first : outcomes[0]) {
      if (limits_.balls == 1) add({step.to, {first}}, number);
      for (const std::uint32_t second : outcomes[1]) add({step.to, {first, second}}, number);
    }
  }
  for (int place = 0; place < limits_.balls; ++place)
    for (std::size_t i = 0; i < rows[place].size(); i += 2) {
      State next = state;
      next.group = rows[place][i];
      next.balls[place] = rows[place][i + 1];
      add(next, number);
    }
}

std::size_t Search::bytes() const {
  return balls_.bytes() + states_.bytes() + parents_.bytes() + pairs_.bytes() + pairSteps_.bytes() +
         pairRows_.bytes() + model_.bytes() + model_.groups().size() * kGroupBytes;
}

Progress Search::progress() const {
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
  return {states_.size(), expanded_,      transitions_,    depth_, model_.groups().size(),
          balls_.size(),  model_.cases(), seconds.count(), bytes()};
}

Result Search::run(const std::function<void(const Progress&)>& report) {
  start_ = std::chrono::steady_clock::now();
  const std::uint32_t nothing = ballNumber(Knowledge{});
  State first{model_.groups().number(newGroup(limits_)), {}};
  for (int place = 0; place < limits_.balls; ++place) first.balls[place] = nothing;
  add(first, 0);
  flush();
  transitions_ = 0;

  double nextReport = kReportInterval;
  std::size_t levelEnd = states_.size();
  for (std::size_t number = 1; number <= states_.size(); ++number) {
    if (number > levelEnd) {
      levelEnd = states_.size();
      ++depth_;
    }
    try {
      expand(static_cast<std::uint32_t>(number));
    } catch (const FlawOfBall& found) {
      return {Outcome::Violated, progress(), found.flaw.what,
              trace(static_cast<std::uint32_t>(number), found.flaw, found.place)};
    }
    ++expanded_;
    if (pending_.size() >= kBatch || number == levelEnd) flush();
    if (number % kLookInterval != 0) continue;
    const Progress now = progress();
    if (report && now.seconds >= nextReport) {
      report(now);
      nextReport = now.seconds + kReportInterval;
    }
    if (now.seconds > limits_.seconds) return {Outcome::OutOfTime, now, "", ""};
    if (now.bytes > limits_.memory) return {Outcome::OutOfMemory, now, "", ""};
  }
  return {Outcome::Closed, progress(), "", ""};
}

/// The event that leads from one state to the other. `names` are the balls at the places of `from`,
/// and become those of `to`.
Search::TraceStep Search::stepBetween(const State& from, const State& to, Names& names) {
  const auto leads = [&](State next) {
    Names named = names;
    if (limits_.balls == 2 && next.balls[0] > next.balls[1]) {
      std::swap(next.balls[0], next.balls[1]);
      std::swap(named[0], named[1]);
    }
    if (next != to) return false;
    names = named;
    return true;
  };
  std::array<std::vector<BallMove>, kMaxBalls> moves;
  const std::vector<GroupStep>& steps = model_.groups().steps(from.group);
  for (std::size_t step = 0; step < steps.size(); ++step) {
    moves[1].assign(1, {});
    for (int place = 0; place < limits_.balls; ++place)
      model_.follow(from.group, step, Knowledge(balls_[from.balls[place]]), moves[place]);
    for (const BallMove& first : moves[0])
      for (const BallMove& second : moves[1]) {
        State next{steps[step].to, {ballNumber(first.to)}};
        if (limits_.balls == 2) next.balls[1] = ballNumber(second.to);
        if (leads(next)) return {steps[step].event};
      }
  }
  for (int place = 0; place < limits_.balls; ++place) {
    const Knowledge ball(balls_[from.balls[place]]);
    model_.ballMoves(from.group, ball, moves[0]);
    for (const BallMove& move : moves[0]) {
      State next = from;
      next.group = move.group;
      next.balls[place] = ballNumber(move.to);
      const int name = names[place];
      if (leads(next)) return {move.event, name, ball.records[move.event.peer]};
    }
  }
  return {};
}

std::string Search::trace(std::uint32_t number, const Flaw& flaw, int place) {
  std::vector<std::uint32_t> path;
  for (std::uint32_t at = number; at != 0; at = parents_[at - 1]) path.push_back(at);
  std::ranges::reverse(path);

  Names names{0, 1};
  std::string text;
  std::vector<std::string> shown;
  const auto show = [&](const State& state, const std::array<Word, kMaxPeers>* heard) {
    std::vector<Knowledge> balls(limits_.balls);
    for (int i = 0; i < limits_.balls; ++i) balls[names[i]] = Knowledge(balls_[state.balls[i]]);
    if (heard) balls[names[place]].records = *heard;
    auto lines = describe(model_.groups()[state.group].group, balls, model_, limits_);
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (i >= shown.size() || lines[i] != shown[i]) text += "     " + lines[i] + "\n";
    shown = std::move(lines);
  };
  for (std::size_t i = 1; i < path.size(); ++i) {
    const State from = states_[path[i - 1]], to = states_[path[i]];
    const TraceStep step = stepBetween(from, to, names);
    text += std::to_string(i) + ". " +
            describe(step.event, model_.groups()[from.group].group, model_.groups()[to.group].group,
                     step.ball, step.record, model_) +
            "\n";
    show(to, nullptr);
  }
  const State last = states_[number];
  const Knowledge ball(balls_[last.balls[place]]);
  if (flaw.event) {
    const Group& group = model_.groups()[last.group].group;
    text +=
        std::to_string(path.size()) + ". " +
        describe(*flaw.event, group, group, names[place], ball.records[flaw.event->peer], model_) +
        "\n";
  } else if (flaw.heard && *flaw.heard != ball.records) {
    text += "   With what they may have heard of ball " + std::to_string(names[place]) + ":\n";
    show(last, &*flaw.heard);
  }
  return text;
}

}  // namespace wells
