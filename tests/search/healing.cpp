#include "search/healing.h"

#include <algorithm>
#include <vector>

namespace wells {
namespace {

constexpr std::int64_t kStep = 0;
constexpr int kMaxRounds = 16;        // far more than it takes
constexpr std::int64_t kLate = 1000;  // after every founding and incarnation before

class Healing {
 public:
  Healing(const Group& group, const std::array<Entry, kMaxPeers>& entries, const Limits& limits,
          const Protocol& protocol, Turns turns)
      : rules_(protocol.transitions), conduct_(protocol.conduct), turns_(turns) {
    for (int peer = 0; peer < limits.peers; ++peer) {
      const Member& member = group.members[peer];
      if (member.number != 0)
        peers_.push_back({partyOf(group, peer), generationOf(group, member.generation),
                          entries[peer].record, entries[peer].offer == Offer::Open});
    }
    if (turns_ == Turns::HighestFirst) std::ranges::reverse(peers_);
  }

  std::optional<std::string> failure() {
    for (int round = 0; round < kMaxRounds; ++round) {
      const std::vector<Peer> before = peers_;
      joinTheGreatest();
      goOnAlone();
      foundIfNobodyHas();
      exchange();
      activate();
      adoptOrphans();
      exchange();
      if (peers_ != before) continue;
      if (conduct_.agreement == Conduct::Agreement::ForAWhile) activateUnagreed();
      if (peers_ == before) return verdict();
    }
    return "never comes to rest";
  }

 private:
  struct Peer {
    Party party{};
    Generation generation{};
    Record record{};
    bool isOpen = false;

    bool operator==(const Peer& other) const {
      return party.self == other.party.self && party.phase == other.party.phase &&
             generation == other.generation && record == other.record && isOpen == other.isOpen;
    }
  };

  static bool isIn(const Peer& peer, const Generation& generation) {
    return peer.generation == generation &&
           (peer.party.phase == Phase::Active || peer.party.phase == Phase::Syncing);
  }

  bool owns(const Peer& peer) const {
    return peer.party.phase == Phase::Active && rules_.owns(peer.record, peer.party.self);
  }

  void joinTheGreatest() {
    Generation greatest{};
    for (const Peer& peer : peers_)
      if (peer.party.phase == Phase::Active) greatest = std::max(greatest, peer.generation);
    for (Peer& peer : peers_) {
      if (peer.generation >= greatest) continue;
      peer.generation = greatest;
      peer.record = rules_.unknown(greatest);
      peer.party.phase = Phase::Syncing;
    }
  }

  /// Those who sync with nobody: they enter a lesser generation that has somebody active, or go on
  /// alone.
  void goOnAlone() {
    const std::vector<Peer> before = peers_;
    for (Peer& peer : peers_) {
      if (peer.party.phase != Phase::Syncing) continue;
      const std::vector<Peer>& heard = turns_ == Turns::AllAtOnce ? before : peers_;
      Generation greatest{};
      for (const Peer& other : heard)
        if (other.party.phase == Phase::Active) greatest = std::max(greatest, other.generation);
      if (greatest == peer.generation) continue;
      if (greatest.exists()) {
        peer.party.self.number += kLate;
        peer.generation = greatest;
        peer.record = rules_.unknown(greatest);
      } else {
        peer.party.phase = Phase::Active;
        adopt(peer);
      }
    }
  }

  void foundIfNobodyHas() {
    const bool nobodyHas = std::ranges::all_of(
        peers_, [](const Peer& peer) { return peer.party.phase == Phase::Joining; });
    if (!nobodyHas) return;
    std::int64_t time = kLate;
    for (Peer& peer : peers_) {
      peer.generation = {.foundedUs = time++};
      peer.record = rules_.found(peer.generation, peer.party.self, kStep);
      peer.party.phase = Phase::Active;
      if (turns_ != Turns::AllAtOnce) return;
    }
  }

  static bool mayActivate(const Peer& peer) {
    return peer.party.phase == Phase::Syncing && peer.record.version.owner != Incarnation{};
  }

  void activate() {
    for (Peer& peer : peers_) {
      const bool agrees = std::ranges::all_of(peers_, [&](const Peer& other) {
        return other.party.phase != Phase::Active || other.generation != peer.generation ||
               other.record.version == peer.record.version;
      });
      if (mayActivate(peer) && agrees) peer.party.phase = Phase::Active;
    }
  }

  /// Those whose digests have not agreed with the others' for long.
  void activateUnagreed() {
    for (Peer& peer : peers_)
      if (mayActivate(peer)) peer.party.phase = Phase::Active;
  }

  Life lifeOf(const Incarnation& owner, const Generation& generation) const {
    const bool lives = std::ranges::any_of(peers_, [&](const Peer& peer) {
      return (peer.party.self == owner ||
              (conduct_.lease == Conduct::Lease::OfPeer && peer.party.self.peer == owner.peer)) &&
             isIn(peer, generation);
    });
    return lives ? Life::Lasts : Life::Ended;
  }

  void adopt(Peer& peer) {
    const Life life = lifeOf(peer.record.version.owner, peer.generation);
    if (rules_.mayAdopt(peer.record, peer.party, life))
      peer.record = rules_.adopt(peer.record, peer.party, kStep);
  }

  void adoptOrphans() {
    for (Peer& peer : peers_) {
      adopt(peer);
      if (turns_ != Turns::AllAtOnce) exchange();
    }
  }

  void exchange() {
    for (const Peer& teller : std::vector<Peer>(peers_)) {
      if (rules_.mayPublish(teller.record, teller.party)) {
        Version version = rules_.publish(teller.record, teller.party, kStep).version;
        version.owner = teller.party.self;
        tell(teller, News::State, version);
      }
      const bool repeats = conduct_.offers == Conduct::Offers::Repeated && teller.isOpen &&
                           teller.party.phase == Phase::Active &&
                           teller.record.standing == Standing::Named &&
                           teller.record.version.owner != teller.party.self;
      if (repeats) tell(teller, News::Offer, teller.record.version);
    }
    for (Peer& peer : peers_)
      if (peer.isOpen && rules_.mayTake(peer.record, peer.party))
        peer.record = rules_.take(peer.record, peer.party);
  }

  void tell(const Peer& teller, News news, const Version& version) {
    for (Peer& peer : peers_) {
      if (peer.party.self == teller.party.self || !isIn(peer, teller.generation) ||
          !rules_.isPossible(version) || rules_.contradicts(peer.record, version))
        continue;
      const auto next = news == News::State ? rules_.learnState(peer.record, version)
                                            : rules_.learnOffer(peer.record, version);
      if (!next) continue;
      peer.record = *next;
      peer.isOpen = news == News::Offer && (peer.party.phase == Phase::Active ||
                                            conduct_.gathering == Conduct::Gathering::KeepsOffers);
    }
  }

  std::optional<std::string> verdict() const {
    if (peers_.empty()) return std::nullopt;
    for (const Peer& peer : peers_) {
      if (peer.party.phase != Phase::Active) return "a peer never becomes active";
      if (peer.record != peers_.front().record) return "the records stay unequal";
      if (peer.record.standing != Standing::Heard) return "the ball is named and never taken";
    }
    const auto owners = std::ranges::count_if(peers_, [&](const Peer& peer) { return owns(peer); });
    if (owners == 0) return "nobody owns the ball";
    if (owners > 1) return "several own the ball";
    return std::nullopt;
  }

  const Transitions& rules_;
  const Conduct& conduct_;
  Turns turns_;
  std::vector<Peer> peers_;
};

}  // namespace

std::optional<std::string> failureToHeal(const Group& group,
                                         const std::array<Entry, kMaxPeers>& entries,
                                         const Limits& limits, const Protocol& protocol,
                                         Turns turns) {
  return Healing(group, entries, limits, protocol, turns).failure();
}

}  // namespace wells
