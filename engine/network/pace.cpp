#include "network/pace.h"

#include <algorithm>

namespace wells {
namespace {

// s; a few heartbeats, so that losing one or two does not matter.
constexpr double kMaxExtrapolation = 0.25;
constexpr double kMaxSilence = 0.5;

}  // namespace

std::int64_t estimatedStep(const PeerPace& peer, const PaceRule& rule, double now) {
  if (peer.progress == Progress::Paused) return peer.step;
  const double since = std::clamp(now - peer.heardAt, 0.0, kMaxExtrapolation);
  return peer.step + static_cast<std::int64_t>(since * rule.stepRate);
}

std::optional<std::int64_t> frontStep(std::span<const PeerPace> peers, const PaceRule& rule,
                                      double now) {
  std::optional<std::int64_t> front;
  for (const PeerPace& peer : peers)
    front = std::max(front.value_or(0), estimatedStep(peer, rule, now));
  return front;
}

int stepsDue(std::int64_t step, double stepTime, std::span<const PeerPace> peers,
             const PaceRule& rule, double now) {
  for (const PeerPace& peer : peers) {
    const bool isSilent = now - peer.heardAt > kMaxSilence;
    if (peer.progress == Progress::Paused || isSilent) continue;
    if (step - estimatedStep(peer, rule, now) > rule.maxAhead) return 0;
  }
  const std::int64_t behind = frontStep(peers, rule, now).value_or(step) - step;
  if (behind <= rule.slack) return 1;
  // Heavy steps are not caught up with: the others wait, and the shared pace drops.
  const double bearable = stepTime > 0 ? rule.longestTick / stepTime : rule.maxCatchUp;
  const int most = static_cast<int>(std::clamp<double>(bearable, 1, rule.maxCatchUp));
  return static_cast<int>(std::min<std::int64_t>(behind, most));
}

int stepsDueInPause(std::int64_t step, std::span<const PeerPace> peers, const PaceRule& rule) {
  std::int64_t furthest = step;
  for (const PeerPace& peer : peers) furthest = std::max(furthest, peer.step);
  return static_cast<int>(std::min<std::int64_t>(furthest - step, rule.maxCatchUp));
}

}  // namespace wells
