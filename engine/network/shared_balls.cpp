#include "network/shared_balls.h"

#include <algorithm>

namespace wells {

SharedBalls::SharedBalls(const World& initial, Predictor predict)
    : predict_(std::move(predict)),
      initial_(initial.balls),
      records_(initial.balls.size()),
      since_(initial.balls.size()),
      watches_(initial.balls.size()),
      gathering_(initial.balls.size()),
      ghosts_(initial.balls.size()) {}

void SharedBalls::found(World& world, const Generation& generation, const Incarnation& founder,
                        double now) {
  drop(world);
  world.setBalls(initial_);
  openOffers_.clear();
  for (std::size_t i = 0; i < records_.size(); ++i) {
    setRecord(i, wells::found(generation, founder, world.step), now);
    setRole(world, i, Role::Owned);
  }
}

void SharedBalls::enter(World& world, const Generation& generation) {
  forget(world, generation);
  world.setBalls(initial_);
  gathering_.restart();
}

void SharedBalls::forget(World& world, const Generation& generation) {
  drop(world);
  openOffers_.clear();
  std::ranges::fill(records_, unknown(generation));
  gathering_.keep(world.step);
}

void SharedBalls::drop(World& world) {
  for (std::size_t i = 0; i < records_.size(); ++i) setRole(world, i, Role::Ghost);
  std::ranges::fill(watches_, HandoverWatch{});
  early_.clear();
  views_.clear();
}

bool SharedBalls::knowsAllOwners() const {
  return gathering_.missing() == 0 && std::ranges::all_of(records_, [](const Record& record) {
           return record.version.owner != Incarnation{};
         });
}

void SharedBalls::activate(World& world) {
  for (std::size_t i = 0; i < records_.size(); ++i)
    if (gathering_.has(i)) place(world, i, world.balls.state(i), gathering_.stepOf(i));
}

void SharedBalls::setRecord(std::size_t ball, const Record& record, double now) {
  const Version& old = records_[ball].version;
  if (!sameTenure(old, record.version) || old.owner != record.version.owner) since_[ball] = now;
  records_[ball] = record;
}

std::optional<Drop> SharedBalls::check(const World& world, const BallNews& news) const {
  if (!isPossible(news.version)) return Drop::ImpossibleVersion;
  if (contradicts(records_[news.ball], news.version)) return Drop::NotOwner;
  if (news.version.step > world.step + kMaxAhead) return Drop::TooFarAhead;
  return std::nullopt;
}

std::optional<Drop> SharedBalls::gather(World& world, const BallNews& news, Standing standing,
                                        const Hearing& hearing) {
  const std::size_t i = news.ball;
  if (const auto drop = check(world, news)) return drop;
  const auto next = standing == Standing::Heard ? learnState(records_[i], news.version)
                                                : learnOffer(records_[i], news.version);
  if (!next) return std::nullopt;
  setRecord(i, *next, hearing.now);
  world.setState(i, news.state);
  gathering_.hear(i, news.version.step);
  if (standing == Standing::Named)
    openOffers_.push_back({i, news.version, news.state, hearing.now + hearing.patience});
  return std::nullopt;
}

std::optional<Drop> SharedBalls::hearState(World& world, const BallNews& news,
                                           const Hearing& hearing) {
  if (const auto drop = check(world, news)) return drop;
  const auto next = learnState(records_[news.ball], news.version);
  if (!next) return std::nullopt;
  countDoubled(world, news, hearing);
  setRecord(news.ball, *next, hearing.now);
  setRole(world, news.ball, Role::Ghost);
  if (news.version.step > world.step) {
    early_[{news.version.step, news.ball}] = news;
  } else {
    compareWithView(world, news, hearing.now);
    place(world, news.ball, news.state, news.version.step);
  }
  return std::nullopt;
}

std::optional<Drop> SharedBalls::hearOffer(World& world, const BallNews& news, const Party& self,
                                           const Hearing& hearing) {
  if (const auto drop = check(world, news)) return drop;
  const auto next = learnOffer(records_[news.ball], news.version);
  if (!next) return std::nullopt;
  countDoubled(world, news, hearing);
  setRecord(news.ball, *next, hearing.now);
  setRole(world, news.ball, Role::Ghost);
  if (news.version.owner != self.self)
    openOffers_.push_back({news.ball, news.version, news.state, hearing.now + hearing.patience});
  if (news.version.step > world.step) {
    early_[{news.version.step, news.ball}] = news;
    return std::nullopt;
  }
  compareWithView(world, news, hearing.now);
  place(world, news.ball, news.state, news.version.step);
  takeBall(world, news.ball, self);
  return std::nullopt;
}

void SharedBalls::countDoubled(const World& world, const BallNews& news, const Hearing& hearing) {
  const bool wasAdopted = records_[news.ball].version.adopter != news.version.adopter;
  if (world.roles[news.ball] == Role::Ghost || !wasAdopted) return;
  const double from = std::max(since_[news.ball], hearing.apartSince);
  counts_.doubledBallSeconds += std::max(0.0, hearing.now - from);
}

void SharedBalls::hearDigest(const Incarnation& peer, std::size_t bucket,
                             const BucketDigest& theirs, std::int64_t recent, const Leases& leases,
                             double now) {
  gathering_.compare(records_, peer, bucket, theirs, now,
                     [&](const Record& record, std::int64_t step) {
                       return step >= recent && leases.isLiving(record.version.owner, now);
                     });
}

std::vector<std::uint32_t> SharedBalls::wanted(std::size_t bucket, const BucketDigest& theirs,
                                               Phase theirPhase, const Incarnation& self) const {
  std::vector<std::uint32_t> balls;
  const bool agrees = digestSum(records_, bucket, theirs.known) == theirs.sum;
  const bool isSyncing = theirPhase == Phase::Syncing;
  if (agrees && !isSyncing) return balls;
  const std::size_t first = bucket * kBallsInBucket;
  const std::size_t end = std::min(first + kBallsInBucket, records_.size());
  for (std::size_t ball = first; ball < end; ++ball) {
    if (!owns(records_[ball], self)) continue;
    const bool counts = theirs.known[ball - first];
    if (counts ? !agrees : isSyncing) balls.push_back(static_cast<std::uint32_t>(ball));
  }
  return balls;
}

BucketDigest SharedBalls::digest(std::size_t bucket, Phase phase, double knownBefore) const {
  BucketDigest digest;
  const std::size_t first = bucket * kBallsInBucket;
  const std::size_t end = std::min(first + kBallsInBucket, records_.size());
  for (std::size_t ball = first; ball < end; ++ball)
    digest.known[ball - first] = phase == Phase::Active
                                     ? since_[ball] <= knownBefore
                                     : gathering_.has(ball) && records_[ball].version.step >= 0;
  digest.sum = digestSum(records_, bucket, digest.known);
  return digest;
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
  const std::int64_t steps = std::min({world.step - step, kMaxPredicted, predictionLeft_});
  predictionLeft_ -= steps;
  world.setState(ball, predict_(world, ball, state, world.step - steps, world.step));
}

void SharedBalls::takeBall(World& world, std::size_t ball, const Party& self) {
  if (!mayTake(records_[ball], self)) return;
  records_[ball] = take(records_[ball], self);
  setRole(world, ball, Role::Owned);
  ++counts_.handoversTaken;
}

void SharedBalls::setRole(World& world, std::size_t ball, Role role) {
  if (world.roles[ball] == role) return;
  world.setRole(ball, role);
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
    setRecord(i, offer(records_[i], self, *receiver, world.step), now);
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
    if (now >= *ended + adoptionWait(rank, wells.size(), lease)) adoptBall(world, i, self, now);
  }
}

void SharedBalls::adoptAll(World& world, const Party& self, const Leases& leases, double now) {
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const bool lives = leases.isLiving(records_[i].version.owner, now);
    if (mayAdopt(records_[i], self, lives ? Life::Lasts : Life::Ended))
      adoptBall(world, i, self, now);
  }
}

void SharedBalls::adoptBall(World& world, std::size_t ball, const Party& self, double now) {
  setRecord(ball, adopt(records_[ball], self, world.step), now);
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

bool SharedBalls::isComplete(const World& world) const {
  if (!openOffers_.empty() || !early_.empty()) return false;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const Record& record = records_[i];
    if (record.standing != Standing::Heard) return false;
    if (world.roles[i] == Role::Ghost && record.version.step != world.step) return false;
  }
  return true;
}

}  // namespace wells
