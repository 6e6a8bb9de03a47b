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

std::int64_t DropCounts::total() const {
  std::int64_t sum = 0;
  for (const std::int64_t count : counts_) sum += count;
  return sum - (*this)[Drop::Echo] - (*this)[Drop::NotJoined];
}

}  // namespace wells
