// Numbers of groups, from 0, and what is worth knowing of each only once.
#pragma once

#include <deque>
#include <map>
#include <vector>

#include "search/group.h"

namespace wells {

struct GroupStep {
  Event event;
  std::uint32_t to = 0;
  bool isReordering = false;
};

struct KnownGroup {
  Group group;
  bool isPassing = false;
  unsigned awaited = 0;    // generations in which newcomers may listen, bit by rank of founding
  std::uint16_t core = 0;  // equal for groups that differ in nothing that matters once faults end
};

class Groups {
 public:
  Groups(const Limits& limits, const Conduct& conduct) : limits_(limits), conduct_(conduct) {}

  std::uint32_t number(const Group& group);
  const KnownGroup& operator[](std::uint32_t number) const { return groups_[number]; }
  const std::vector<GroupStep>& steps(std::uint32_t number);
  std::size_t size() const { return groups_.size(); }

 private:
  struct Core {
    std::array<Member, kMaxPeers> members{};
    std::array<Generation, kMaxGenerations> generations{};
    bool isCalm = false;
    auto operator<=>(const Core&) const = default;
  };
  Limits limits_;
  Conduct conduct_;
  std::map<Group, std::uint32_t> numbers_;
  std::map<Core, std::uint16_t> cores_;
  std::deque<KnownGroup> groups_;  // in which references last
  std::deque<std::vector<GroupStep>> steps_;
};

}  // namespace wells
