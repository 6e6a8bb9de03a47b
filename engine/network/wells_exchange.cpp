#include "network/wells_exchange.h"

#include <algorithm>

#include "network/codec.h"

namespace wells {
namespace {

WellTrack& trackOf(Tracks& tracks, PeerId peer) {
  auto place = std::ranges::lower_bound(tracks, peer, {}, &WellTrack::peer);
  if (place == tracks.end() || place->peer != peer)
    place = tracks.insert(place, WellTrack{.keyframes = {}, .softening = 1, .peer = peer});
  return *place;
}

std::int64_t lastMultiple(std::int64_t step) {
  return step - step % kKeyframeInterval;
}

}  // namespace

void addOwnTrack(Tracks& tracks, PeerId self, const OwnWell& well, std::int64_t step,
                 Appearance appearance) {
  WellTrack& track = trackOf(tracks, self);
  track.softening = well.softening;
  track.keyframes.clear();
  const bool delayed = appearance == Appearance::Delayed;
  const std::int64_t first = lastMultiple(step) + (delayed ? kInputDelay : 0);
  // Off until then: before its first keyframe a well acts with that one's strength.
  if (delayed) {
    track.keyframes.push_back(well.at(self, first - kKeyframeInterval));
    track.keyframes.back().step = first - kKeyframeInterval;
    track.keyframes.back().strength = 0;
  }
  track.keyframes.push_back(well.at(self, first));
  track.keyframes.back().step = first;
  extendOwnTrack(tracks, self, well, step);
}

void extendOwnTrack(Tracks& tracks, PeerId self, const OwnWell& well, std::int64_t step) {
  std::vector<WellKeyframe>& keys = trackOf(tracks, self).keyframes;
  // After a pause of ours everybody has the well at rest, and it must not move in their past.
  if (keys.back().step < step) {
    keys.push_back(keys.back());
    keys.back().step = lastMultiple(step) + kInputDelay - kKeyframeInterval;
  }
  while (keys.back().step < step + kInputDelay) {
    const std::int64_t next = lastMultiple(keys.back().step) + kKeyframeInterval;
    keys.push_back(well.at(self, next));
    keys.back().step = next;
  }
}

void switchOff(Tracks& tracks, PeerId gone, std::int64_t step) {
  const auto track = std::ranges::find(tracks, gone, &WellTrack::peer);
  if (track == tracks.end()) return;
  std::vector<WellKeyframe>& keys = track->keyframes;
  const std::int64_t after = std::max(keys.back().step, step + kInputDelay);
  const std::int64_t between = lastMultiple(after) + kKeyframeInterval + kKeyframeInterval / 2;
  keys.push_back({between, keys.back().position, 0});
}

bool isSwitchedOff(const WellTrack& track) {
  return !track.keyframes.empty() && track.keyframes.back().strength == 0;
}

gravity_wells::wells_t wellMessage(const Tracks& tracks, PeerId peer) {
  const WellTrack& track = *std::ranges::find(tracks, peer, &WellTrack::peer);
  gravity_wells::wells_t message;
  message.peer = value(peer);
  message.softening = track.softening;
  const auto& keys = track.keyframes;
  message.count =
      static_cast<std::int32_t>(std::min<std::size_t>(keys.size(), kMaxKeyframesInMessage));
  for (auto key = keys.end() - message.count; key != keys.end(); ++key) {
    message.keyframes.push_back(
        {.step = key->step,
         .position = {key->position.x(), key->position.y(), key->position.z()},
         .strength = key->strength});
  }
  return message;
}

TrackNews learnTrack(Tracks& tracks, const gravity_wells::wells_t& message, std::int64_t step) {
  WellTrack& track = trackOf(tracks, PeerId{message.peer});
  track.softening = message.softening;
  auto& keys = track.keyframes;
  TrackNews news = TrackNews::None;
  for (const gravity_wells::well_keyframe_t& key : message.keyframes) {
    const auto place = std::ranges::lower_bound(keys, key.step, {}, &WellKeyframe::step);
    if (place != keys.end() && place->step == key.step) continue;
    // A repetition of what was pruned already must not come back.
    if (place == keys.begin() && !keys.empty()) continue;
    keys.insert(place,
                {key.step, Vec3{key.position[0], key.position[1], key.position[2]}, key.strength});
    news = std::max(news, key.step < step ? TrackNews::Late : TrackNews::InTime);
  }
  return news;
}

void removeTracks(Tracks& tracks, const std::function<bool(const WellTrack&)>& superfluous) {
  std::erase_if(
      tracks, [&](const WellTrack& track) { return track.peer != kNobody && superfluous(track); });
}

void pruneTracks(Tracks& tracks, std::int64_t step) {
  for (WellTrack& track : tracks) {
    if (track.peer == kNobody) continue;
    auto& keys = track.keyframes;
    const auto needed = std::ranges::upper_bound(keys, step - kKeptSteps, {}, &WellKeyframe::step);
    if (needed - keys.begin() > 1) keys.erase(keys.begin(), needed - 1);
  }
}

std::vector<PeerWell> peerWells(const World& world) {
  std::vector<PeerWell> wells;
  for (const WellTrack& track : world.tracks)
    if (track.peer != kNobody)
      wells.push_back({track.peer, wellAt(track, world.step, world.settings.dt).position});
  return wells;
}

}  // namespace wells
