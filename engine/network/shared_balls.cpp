#include "network/shared_balls.h"

#include <algorithm>

namespace wells {

SharedBalls::SharedBalls(const World& initial, Predictor predict)
    : predict_(std::move(predict)),
      initial_(initial.balls),
      records_(initial.balls.size()),
      watches_(initial.balls.size()),
      gathered_(initial.balls.size(), -1),
      missing_(initial.balls.size()),
      ghosts_(initial.balls.size()) {}

void SharedBalls::found(World& world, const Generation& generation, const Incarnation& founder) {
  for (std::size_t i = 0; i < records_.size(); ++i) {
    records_[i] = wells::found(generation, founder, world.step);
    setRole(world, i, Role::Owned);
  }
}

void SharedBalls::enter(World& world, const Generation& generation) {
  drop(world);
  openOffers_.clear();
  world.balls = initial_;
  std::ranges::fill(records_, unknown(generation));
}

void SharedBalls::drop(World& world) {
  for (std::size_t i = 0; i < records_.size(); ++i) setRole(world, i, Role::Ghost);
  std::ranges::fill(watches_, HandoverWatch{});
  std::ranges::fill(gathered_, -1);
  missing_ = records_.size();
  early_.clear();
  views_.clear();
}

std::int64_t SharedBalls::latestStep() const {
  return gathered_.empty() ? 0 : std::max<std::int64_t>(0, std::ranges::max(gathered_));
}

void SharedBalls::activate(World& world) {
  for (std::size_t i = 0; i < gathered_.size(); ++i)
    if (gathered_[i] >= 0) place(world, i, world.balls.state(i), gathered_[i]);
}

std::optional<Drop> SharedBalls::check(const World& world, const BallNews& news) const {
  if (!isPossible(news.version)) return Drop::ImpossibleVersion;
  if (contradicts(records_[news.ball], news.version)) return Drop::NotOwner;
  if (news.version.step > world.step + kMaxAhead) return Drop::TooFarAhead;
  return std::nullopt;
}

std::optional<Drop> SharedBalls::gather(World& world, const BallNews& news, Standing standing) {
  const std::size_t i = news.ball;
  if (const auto drop = check(world, news)) return drop;
  const auto next = standing == Standing::Heard ? learnState(records_[i], news.version)
                                                : learnOffer(records_[i], news.version);
  if (next) records_[i] = *next;
  if (!next && gathered_[i] >= 0) return std::nullopt;
  world.balls.setState(i, news.state);
  if (gathered_[i] < 0) --missing_;
  gathered_[i] = news.version.step;
  return std::nullopt;
}

std::optional<Drop> SharedBalls::hearState(World& world, const BallNews& news, double now) {
  if (const auto drop = check(world, news)) return drop;
  const auto next = learnState(records_[news.ball], news.version);
  if (!next) return std::nullopt;
  records_[news.ball] = *next;
  setRole(world, news.ball, Role::Ghost);
  if (news.version.step > world.step) {
    early_[{news.version.step, news.ball}] = news;
  } else {
    compareWithView(world, news, now);
    place(world, news.ball, news.state, news.version.step);
  }
  return std::nullopt;
}

std::optional<Drop> SharedBalls::hearOffer(World& world, const BallNews& news, const Party& self,
                                           double now, double patience) {
  if (const auto drop = check(world, news)) return drop;
  const auto next = learnOffer(records_[news.ball], news.version);
  if (!next) return std::nullopt;
  records_[news.ball] = *next;
  setRole(world, news.ball, Role::Ghost);
  if (news.version.owner != self.self)
    openOffers_.push_back({news.ball, news.version, news.state, now + patience});
  if (news.version.step > world.step) {
    early_[{news.version.step, news.ball}] = news;
    return std::nullopt;
  }
  compareWithView(world, news, now);
  place(world, news.ball, news.state, news.version.step);
  takeBall(world, news.ball, self);
  return std::nullopt;
}

void SharedBalls::applyDue(World& world, const Party& self) {
  while (!early_.empty() && early_.begin()->first.first <= world.step) {
    const BallNews news = early_.begin()->second;
    early_.erase(early_.begin());
    const Record& record = records_[news.ball];
    const bool isOvertaken = !sameTenure(record.version, news.version);
    if (isOvertaken || owns(record, self.self)) continue;
    place(world, news.ball, news.state, news.version.step);
    takeBall(world, news.ball, self);
  }
}

void SharedBalls::place(World& world, std::size_t ball, const BallState& state, std::int64_t step) {
  const std::int64_t from = std::max(step, world.step - kMaxPredicted);
  world.balls.setState(ball, predict_(world, ball, state, from, world.step));
}

void SharedBalls::takeBall(World& world, std::size_t ball, const Party& self) {
  if (!mayTake(records_[ball], self)) return;
  records_[ball] = take(records_[ball], self);
  setRole(world, ball, Role::Owned);
  ++counts_.handoversTaken;
}

void SharedBalls::setRole(World& world, std::size_t ball, Role role) {
  if (world.roles[ball] == role) return;
  world.roles[ball] = role;
  ghosts_ += role == Role::Ghost ? 1 : -1;
  watches_[ball] = {};
}

void SharedBalls::offerNearer(World& world, const Party& self, std::span<const PeerWell> wells,
                              std::span<const Party> receivers, const HandoverRule& rule,
                              double now) {
  for (std::size_t i = 0; i < records_.size(); ++i) {
    if (!owns(records_[i], self.self)) continue;
    const PeerId nearer = nearerPeer(world.balls.position[i], self.self.peer, wells, rule);
    watches_[i] = watch(watches_[i], nearer, world.step);
    if (!isDue(watches_[i], world.step, rule)) continue;
    const auto receiver =
        std::ranges::find(receivers, nearer, [](const Party& party) { return party.self.peer; });
    if (receiver == receivers.end() || !mayOffer(records_[i], self, *receiver)) continue;
    records_[i] = offer(records_[i], self, *receiver, world.step);
    setRole(world, i, Role::Ghost);
    openOffers_.push_back({i, records_[i].version, world.balls.state(i), now});
    ++counts_.handoversGiven;
  }
}

void SharedBalls::adoptOrphans(World& world, const Party& self, Leases& leases,
                               std::span<const PeerWell> wells, double lease, double now) {
  // Few owners, many balls: the lease of the last owner looked at is kept.
  Incarnation owner = self.self;
  std::optional<double> ended;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    if (records_[i].version.owner != owner) {
      owner = records_[i].version.owner;
      leases.expect(owner, lease, now);
      ended = leases.endedAt(owner, now);
    }
    if (!mayAdopt(records_[i], self, ended ? Life::Ended : Life::Lasts)) continue;
    const std::size_t rank = adoptionRank(world.balls.position[i], self.self.peer, wells);
    if (now >= *ended + adoptionWait(rank, wells.size(), lease)) adoptBall(world, i, self);
  }
}

void SharedBalls::adoptAll(World& world, const Party& self, const Leases& leases, double now) {
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const bool lives = leases.isLiving(records_[i].version.owner, now);
    if (mayAdopt(records_[i], self, lives ? Life::Lasts : Life::Ended)) adoptBall(world, i, self);
  }
}

void SharedBalls::adoptBall(World& world, std::size_t ball, const Party& self) {
  records_[ball] = adopt(records_[ball], self, world.step);
  setRole(world, ball, Role::Owned);
  ++counts_.adoptions;
}

Version SharedBalls::publish(const World& world, std::size_t ball, const Party& self) {
  records_[ball] = wells::publish(records_[ball], self, world.step);
  return records_[ball].version;
}

void SharedBalls::recordView(const World& world) {
  if (ghosts_ > 0) views_.record(world.step, world.balls.position);
}

void SharedBalls::compareWithView(const World& world, const BallNews& news, double now) {
  const auto shown = news.version.step == world.step
                         ? std::optional(world.balls.position[news.ball])
                         : views_.at(news.version.step, news.ball);
  if (shown) viewDifference_.add(length(*shown - news.state.position), now);
}

void SharedBalls::closeOffers() {
  std::erase_if(openOffers_, [&](const OpenOffer& open) {
    const Record& record = records_[open.ball];
    return record.version != open.version || record.standing == Standing::Heard;
  });
}

bool SharedBalls::isSettled(const World& world) const {
  if (!openOffers_.empty() || !early_.empty()) return false;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const Record& record = records_[i];
    if (record.standing != Standing::Heard) return false;
    if (world.roles[i] == Role::Ghost && record.version.step != world.step) return false;
  }
  return true;
}

}  // namespace wells
