#include "search/search.h"

#include <algorithm>

#include "search/trace.h"

namespace wells {
namespace {

constexpr std::size_t kLookInterval = 4096;  // states between two looks at time and memory
constexpr double kReportInterval = 5;        // s

/// Thrown with the place of the ball whose part is wrong.
struct FlawOfBall {
  Flaw flaw;
  std::uint32_t ball = 0;
};

std::uint16_t packed(const Member& member) {
  return static_cast<std::uint16_t>(static_cast<int>(member.phase) << 12 | member.number << 4 |
                                    member.generation);
}

}  // namespace

Search::Search(const Limits& limits, const Protocol& protocol)
    : limits_(limits), protocol_(protocol), model_(limits, protocol) {}

std::uint32_t Search::groupNumber(const Group& group) {
  const auto [entry, isNew] =
      groupNumbers_.try_emplace(group, static_cast<std::uint32_t>(groups_.size()));
  if (isNew) {
    groups_.push_back(&entry->first);
    groupSteps_.emplace_back();
  }
  return entry->second;
}

std::uint32_t Search::ballNumber(const Knowledge& ball) {
  words_.clear();
  ball.appendTo(words_);
  return balls_.number(words_);
}

const std::vector<Search::GroupStep>& Search::stepsOfGroup(std::uint32_t group) {
  if (groupSteps_[group].empty()) {
    std::vector<GroupStep> steps;
    for (const GroupMove& move : model_.groupMoves(*groups_[group]))
      steps.push_back({move.event, groupNumber(move.to)});
    groupSteps_[group] = std::move(steps);
  }
  return groupSteps_[group];
}

void Search::heal(const Group& group, const Knowledge& ball) {
  std::array<std::uint16_t, 10> key{};
  std::array<Entry, kMaxPeers> entries;
  for (int peer = 0; peer < kMaxPeers; ++peer) {
    key[peer] = packed(group.members[peer]);
    key[3 + peer] = ball.records[peer];
    key[6 + peer] = group.generations[peer].founded;
    entries[peer] = model_.entry(ball, peer);
  }
  const std::size_t known = healed_.size();
  healed_.number(key);
  if (healed_.size() == known) return;
  for (const Turns turns : {Turns::LowestFirst, Turns::HighestFirst, Turns::AllAtOnce})
    if (const auto failure = failureToHeal(group, entries, limits_, protocol_, turns))
      throw Flaw{"does not heal: " + *failure, {}};
}

void Search::computeSteps(const Pair& pair, std::vector<std::uint32_t>& follows,
                          std::vector<std::uint32_t>& own) {
  follows.clear();
  own.clear();
  const std::vector<GroupStep>& steps = stepsOfGroup(pair.group);
  const Group& group = *groups_[pair.group];
  const Knowledge ball(balls_[pair.ball]);
  model_.check(group, ball);
  heal(group, ball);
  for (const GroupStep& step : steps) {
    const auto next = model_.follow(*groups_[step.to], step.event, ball);
    follows.push_back(next ? ballNumber(*next) : 0);
  }
  model_.ballMoves(group, ball, moves_);
  for (const BallMove& move : moves_) own.push_back(ballNumber(move.to));
}

Search::Steps Search::stepsOfBall(const Pair& pair, int place) {
  Scratch& scratch = scratch_[place];
  try {
    if (limits_.balls == 1) {
      computeSteps(pair, scratch.follows, scratch.own);
      return {scratch.follows, scratch.own};
    }
    const std::uint32_t number = pairs_.number(pair);
    if (number > pairStarts_.size()) {
      computeSteps(pair, scratch.follows, scratch.own);
      std::uint32_t* to = pairSteps_.extend(scratch.follows.size() + scratch.own.size() + 1);
      pairStarts_.push_back(pairSteps_.size() - scratch.follows.size() - scratch.own.size() - 1);
      *to++ = static_cast<std::uint32_t>(scratch.own.size());
      to = std::ranges::copy(scratch.follows, to).out;
      std::ranges::copy(scratch.own, to);
    }
    const std::uint32_t* const row = &pairSteps_[pairStarts_[number - 1]];
    const std::size_t follows = stepsOfGroup(pair.group).size();
    return {{row + 1, follows}, {row + 1 + follows, *row}};
  } catch (const Flaw& flaw) {
    throw FlawOfBall{flaw, static_cast<std::uint32_t>(place)};
  }
}

void Search::add(State state) {
  if (limits_.balls == 2 && state.balls[0] > state.balls[1])
    std::swap(state.balls[0], state.balls[1]);
  const std::uint64_t hash = Numbering<State>::hashOf(state);
  states_.prefetch(hash);
  pending_.emplace_back(state, hash);
}

void Search::flush(std::uint32_t parent) {
  for (const auto& [state, hash] : pending_) {
    const std::size_t before = states_.size();
    states_.number(state, hash);
    if (states_.size() > before) parents_.push_back(parent);
  }
  transitions_ += pending_.size();
  pending_.clear();
}

void Search::expand(std::uint32_t number) {
  const State state = states_[number];
  std::array<Steps, kMaxBalls> steps;
  for (int ball = 0; ball < limits_.balls; ++ball)
    steps[ball] = stepsOfBall({state.group, state.balls[ball]}, ball);
  const std::vector<GroupStep>& group = stepsOfGroup(state.group);
  for (std::size_t i = 0; i < group.size(); ++i) {
    State next{group[i].to, {}};
    bool isAllowed = true;
    for (int ball = 0; ball < limits_.balls; ++ball) {
      next.balls[ball] = steps[ball].follows[i];
      isAllowed = isAllowed && next.balls[ball] != 0;
    }
    if (isAllowed) add(next);
  }
  for (int ball = 0; ball < limits_.balls; ++ball)
    for (const std::uint32_t to : steps[ball].own) {
      State next = state;
      next.balls[ball] = to;
      add(next);
    }
  flush(number);
}

std::size_t Search::bytes() const {
  return balls_.bytes() + states_.bytes() + parents_.bytes() + pairs_.bytes() + pairSteps_.bytes() +
         pairStarts_.capacity() * sizeof(std::size_t) + healed_.bytes() + groups_.size() * 1000;
}

Progress Search::progress() const {
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
  return {states_.size(), expanded_,     transitions_,    depth_,
          groups_.size(), balls_.size(), seconds.count(), bytes()};
}

Result Search::run(const std::function<void(const Progress&)>& report) {
  start_ = std::chrono::steady_clock::now();
  const std::uint32_t nothing = ballNumber(Knowledge{});
  State first{groupNumber(newGroup(limits_)), {}};
  for (int ball = 0; ball < limits_.balls; ++ball) first.balls[ball] = nothing;
  add(first);
  flush(0);
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
              trace(static_cast<std::uint32_t>(number), found.flaw.event, found.ball)};
    }
    ++expanded_;
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

std::string Search::trace(std::uint32_t number, const std::optional<Event>& last,
                          std::uint32_t ball) {
  std::vector<std::uint32_t> path;
  for (std::uint32_t at = number; at != 0; at = parents_[at - 1]) path.push_back(at);
  std::ranges::reverse(path);

  // Which ball of the trace stands at which place of the state: states have their balls in order.
  std::array<int, kMaxBalls> names{0, 1};
  std::string text;
  const auto show = [&](const State& state) {
    std::vector<Knowledge> balls(limits_.balls);
    for (int i = 0; i < limits_.balls; ++i) balls[names[i]] = Knowledge(balls_[state.balls[i]]);
    text += describe(*groups_[state.group], balls, model_, limits_);
  };
  const auto eventBetween = [&](const State& from, const State& to) {
    const auto isNext = [&](State next, std::array<int, kMaxBalls> named) {
      if (limits_.balls == 2 && next.balls[0] > next.balls[1]) {
        std::swap(next.balls[0], next.balls[1]);
        std::swap(named[0], named[1]);
      }
      if (next != to) return false;
      names = named;
      return true;
    };
    const Group& group = *groups_[from.group];
    for (const GroupStep& step : stepsOfGroup(from.group)) {
      State next{step.to, {}};
      for (int i = 0; i < limits_.balls; ++i) {
        const auto ballThen =
            model_.follow(*groups_[step.to], step.event, Knowledge(balls_[from.balls[i]]));
        next.balls[i] = ballThen ? ballNumber(*ballThen) : 0;
      }
      if (isNext(next, names)) return describe(step.event, group, *groups_[step.to], {}, model_);
    }
    for (int i = 0; i < limits_.balls; ++i) {
      std::vector<BallMove> moves;
      model_.ballMoves(group, Knowledge(balls_[from.balls[i]]), moves);
      for (const BallMove& move : moves) {
        State next = from;
        next.balls[i] = ballNumber(move.to);
        const int named = names[i];
        if (isNext(next, names)) return describe(move.event, group, group, named, model_);
      }
    }
    return std::string("?");
  };

  for (std::size_t i = 1; i < path.size(); ++i) {
    const State from = states_[path[i - 1]], to = states_[path[i]];
    text += std::to_string(i) + ". " + eventBetween(from, to) + "\n";
    show(to);
  }
  if (last) {
    const Group& group = *groups_[states_[number].group];
    text += std::to_string(path.size()) + ". " +
            describe(*last, group, group, names[ball], model_) + "\n";
  }
  return text;
}

}  // namespace wells
