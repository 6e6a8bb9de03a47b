#include "search/groups.h"

#include <stdexcept>

namespace wells {

std::uint32_t Groups::number(const Group& group) {
  const auto [entry, isNew] =
      numbers_.try_emplace(group, static_cast<std::uint32_t>(groups_.size()));
  if (!isNew) return entry->second;
  KnownGroup known{.group = group, .isPassing = isPassing(group, limits_)};
  Core core{.members = group.members, .isCalm = isCalm(group)};
  for (int generation = 1; generation <= group.eras; ++generation) {
    const std::uint8_t founded = group.generations[generation - 1].founded;
    core.generations[generation - 1] = generationOf(group, generation);
    if (mayAwaitNewcomers(group, generation, limits_)) known.awaited |= 1u << founded;
  }
  if (cores_.size() > 0xffff) throw std::length_error("search: too many groups");
  known.core = cores_.try_emplace(core, static_cast<std::uint16_t>(cores_.size())).first->second;
  groups_.push_back(known);
  steps_.emplace_back();
  return entry->second;
}

const std::vector<GroupStep>& Groups::steps(std::uint32_t number) {
  if (steps_[number].empty()) {
    std::vector<GroupStep> steps;
    for (const GroupMove& move : movesOf(groups_[number].group, limits_, conduct_))
      steps.push_back({move.event, this->number(move.to), move.isReordering});
    steps_[number] = std::move(steps);
  }
  return steps_[number];
}

}  // namespace wells
