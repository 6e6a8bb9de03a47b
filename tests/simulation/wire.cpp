#include "simulation/wire.h"

#include <algorithm>

namespace wells::simulation {
namespace {

bool cuts(const Fault& fault, int from, int to) {
  switch (fault.kind) {
    case FaultKind::Mute:
      return from == fault.slot;
    case FaultKind::Deaf:
      return to == fault.slot;
    case FaultKind::Isolate:
      return from == fault.slot || to == fault.slot;
    case FaultKind::CutLink:
      return from == fault.slot && to == fault.other;
    default:
      return false;
  }
}

}  // namespace

Wire::Wire(std::uint64_t seed, double latency, Recording recording)
    : latency_(latency),
      recording_(recording),
      random_(seed ^ 0xf0f0),
      network_(std::make_shared<MemoryNetwork>(seed)) {}

void Wire::apply(std::span<const Fault> lasting, std::span<const Plug> plugs) {
  MemoryFaults faults{.delay = latency_, .jitter = latency_};
  for (const Fault& fault : lasting) {
    if (fault.kind == FaultKind::Loss) faults.loss = std::max(faults.loss, fault.amount);
    if (fault.kind == FaultKind::Duplication)
      faults.duplication = std::max(faults.duplication, fault.amount);
    if (fault.kind == FaultKind::Delay) faults.jitter = std::max(faults.jitter, fault.amount);
  }
  network_->setFaults(faults);
  for (const Plug& from : plugs) {
    std::size_t capacity = MemoryNetwork::kCapacity;
    for (const Fault& fault : lasting)
      if (fault.kind == FaultKind::TinyBuffer && fault.slot == from.slot)
        capacity = std::min(capacity, static_cast<std::size_t>(fault.amount));
    network_->setCapacity(from.endpoint, capacity);
    for (const Plug& to : plugs) {
      if (from.endpoint == to.endpoint) continue;
      const bool isCut = std::ranges::any_of(
          lasting, [&](const Fault& fault) { return cuts(fault, from.slot, to.slot); });
      network_->setLink(from.endpoint, to.endpoint, isCut ? MemoryLink::Cut : MemoryLink::Up);
    }
  }
}

void Wire::record(int slot, std::string_view channel, std::span<const std::byte> bytes) {
  if (recording_ == Recording::Off) return;
  sent_.push_back({now(), slot, {std::string(channel), {bytes.begin(), bytes.end()}}});
  while (sent_.front().time < now() - kKept) sent_.pop_front();
}

void Wire::say(std::string_view channel, std::span<const std::byte> bytes) {
  MemoryTransport source(network_);
  source.publish(channel, bytes);
}

void Wire::replay(int slot, double from, double to) {
  MemoryTransport source(network_);
  std::size_t replayed = 0;
  for (const Sent& sent : sent_) {
    if (sent.time < from || sent.time > to) continue;
    if (slot != Fault::kAnySlot && sent.slot != slot) continue;
    source.publish(sent.message.channel, sent.message.bytes);
    if (++replayed == kMostReplayed) return;
  }
}

void Wire::forge(std::size_t balls) {
  MemoryTransport source(network_);
  const std::size_t recent = std::min<std::size_t>(sent_.size(), 60);
  for (int i = 0; i < kForged && recent > 0; ++i) {
    const Sent& sent = sent_[sent_.size() - 1 - random_.below(recent)];
    const RawMessage forged = simulation::forge(sent.message, balls, random_);
    source.publish(forged.channel, forged.bytes);
  }
}

}  // namespace wells::simulation
