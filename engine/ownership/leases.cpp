#include "ownership/leases.h"

#include <limits>

namespace wells {

bool Leases::hear(const Incarnation& who, std::int64_t step, Progress progress, double duration,
                  double now) {
  const auto [entry, isNew] = leases_.try_emplace(who, Lease{step, duration, now});
  Lease& lease = entry->second;
  if (lease.isOver) return false;
  lease.duration = duration;
  if (!isNew && step <= lease.step && progress == Progress::Running) return false;
  lease.step = step;
  lease.renewed = now;
  lease.ended.reset();
  return true;
}

void Leases::expect(const Incarnation& who, double duration, double time) {
  // Below every step, so that the first message heard renews it.
  leases_.try_emplace(who, Lease{std::numeric_limits<std::int64_t>::min(), duration, time});
}

void Leases::end(const Incarnation& who, double now) {
  Lease& lease = leases_.try_emplace(who, Lease{0, 0, now}).first->second;
  lease.ended = endedAt(lease, now).value_or(now);
  lease.isOver = true;
}

void Leases::supersede(const Incarnation& newest, double now) {
  for (auto& [who, lease] : leases_)
    if (who.peer == newest.peer && who.number != newest.number && !lease.ended &&
        now - lease.renewed > lease.duration / 2)
      lease.ended = endedAt(lease, now).value_or(now);
}

bool Leases::isOver(const Incarnation& who) const {
  const auto entry = leases_.find(who);
  return entry != leases_.end() && entry->second.isOver;
}

std::optional<double> Leases::endedAt(const Incarnation& who, double now) const {
  const auto entry = leases_.find(who);
  if (entry == leases_.end()) return -std::numeric_limits<double>::infinity();
  return endedAt(entry->second, now);
}

std::optional<double> Leases::endedAt(const Lease& lease, double now) const {
  if (lease.ended) return lease.ended;
  const double runsOut = lease.renewed + lease.duration;
  if (now >= runsOut) return runsOut;
  return std::nullopt;
}

double Leases::runsOutAt(const Incarnation& who, double now) const {
  if (const auto ended = endedAt(who, now)) return *ended;
  const Lease& lease = leases_.at(who);
  return lease.renewed + lease.duration;
}

void Leases::forget(double time, double now) {
  std::erase_if(leases_, [&](const auto& entry) {
    const auto ended = endedAt(entry.second, now);
    return ended && *ended < time;
  });
}

}  // namespace wells
