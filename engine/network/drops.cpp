#include "network/drops.h"

namespace wells {

std::string_view name(Drop reason) {
  switch (reason) {
    case Drop::UnknownChannel:
      return "unknown channel";
    case Drop::WrongSize:
      return "wrong size";
    case Drop::BadCount:
      return "bad count";
    case Drop::Undecodable:
      return "undecodable";
    case Drop::WrongProtocol:
      return "wrong protocol";
    case Drop::OutOfRange:
      return "out of range";
    case Drop::Echo:
      return "echo";
    case Drop::NotJoined:
      return "not joined";
    case Drop::DuplicateId:
      return "duplicate id";
    case Drop::ClockApart:
      return "clock apart";
    case Drop::ForeignWorld:
      return "foreign world";
    case Drop::UnknownSender:
      return "unknown sender";
    case Drop::DeadSender:
      return "dead sender";
    case Drop::Replayed:
      return "replayed";
    case Drop::ForeignGeneration:
      return "foreign generation";
    case Drop::NotActive:
      return "not active";
    case Drop::ImpossibleVersion:
      return "impossible version";
    case Drop::NotOwner:
      return "not owner";
    case Drop::TooFarAhead:
      return "too far ahead";
  }
  return "unknown";
}

std::vector<std::pair<Drop, std::int64_t>> DropCounts::faults() const {
  std::vector<std::pair<Drop, std::int64_t>> faults;
  for (std::size_t i = 0; i < kDropReasons; ++i) {
    const auto reason = static_cast<Drop>(i);
    if (reason == Drop::Echo || reason == Drop::NotJoined || counts_[i] == 0) continue;
    faults.emplace_back(reason, counts_[i]);
  }
  return faults;
}

std::int64_t DropCounts::total() const {
  std::int64_t sum = 0;
  for (const auto& [reason, count] : faults()) sum += count;
  return sum;
}

}  // namespace wells
