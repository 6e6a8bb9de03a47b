#include <gtest/gtest.h>

#include <memory>

#include "app/watched.h"
#include "network/memory_transport.h"
#include "probe_message.h"
#include "probe_round.h"
#include "probe_table.h"

namespace wells {
namespace {

constexpr std::int64_t kWall = 1'700'000'100'000'000;  // us

// Machines in one multicast group.
struct Lan {
  explicit Lan(const MemoryFaults& faults = {})
      : network(std::make_shared<MemoryNetwork>(1, faults)) {}

  ProbeRound& add(const std::string& host) {
    transports.push_back(std::make_unique<MemoryTransport>(network));
    rounds.push_back(std::make_unique<ProbeRound>(*transports.back(), host, 1000 + rounds.size()));
    return *rounds.back();
  }

  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 1000 + 0.5); ++i) {
      network->advance(0.001);
      for (auto& round : rounds) round->tick({network->now(), kWall});
    }
  }

  std::shared_ptr<MemoryNetwork> network;
  std::vector<std::unique_ptr<MemoryTransport>> transports;
  std::vector<std::unique_ptr<ProbeRound>> rounds;
};

ProbeSurroundings surroundings(int ttl) {
  LcmUrl url;
  url.port = 9171;
  url.ttl = ttl;
  return {url, MulticastRoute{"eth0", "10.0.0.5"}, "lab1", 5};
}

TEST(Reception, CountsWhatCameOfWhatWasSent) {
  Reception reception;
  EXPECT_EQ(reception.sent(), 0);
  EXPECT_TRUE(reception.take(10)) << "what was sent before we listened does not count";
  EXPECT_FALSE(reception.take(10)) << "a copy";
  EXPECT_TRUE(reception.take(13));
  EXPECT_FALSE(reception.take(12)) << "late";
  EXPECT_FALSE(reception.take(9)) << "from before the first";
  EXPECT_EQ(reception.heard(), 3);
  EXPECT_EQ(reception.sent(), 4);
  EXPECT_EQ(reception.latest(), 13);
}

TEST(ProbeRound, TwoMachinesHearEachOther) {
  Lan lan({.delay = 0.02});
  ProbeRound& a = lan.add("lab1");
  ProbeRound& b = lan.add("lab2");
  lan.run(5);
  ASSERT_EQ(a.hosts().size(), 1u) << "nobody hears himself";
  const ProbedHost& other = *a.hosts().front();
  EXPECT_EQ(other.name, "lab2");
  EXPECT_EQ(other.reception.heard(), other.reception.sent());
  EXPECT_GE(other.reception.heard(), 45);
  EXPECT_TRUE(other.hearsUs());
  // Two journeys of 20 ms, and a poll after each within a millisecond.
  EXPECT_NEAR(other.roundTrip.value(), 0.040, 0.002 + 1e-9);
  EXPECT_TRUE(passesBothWays(a));
  EXPECT_TRUE(passesBothWays(b));
}

TEST(ProbeRound, MeasuresLossInBothDirections) {
  Lan lan({.loss = 0.3, .duplication = 0.2, .delay = 0.01, .jitter = 0.3});
  ProbeRound& a = lan.add("lab1");
  lan.add("lab2");
  lan.run(120);
  const ProbedHost& other = *a.hosts().front();
  const auto share = [](std::int64_t heard, std::int64_t sent) {
    return static_cast<double>(heard) / static_cast<double>(sent);
  };
  // Each copy is lost by itself: 1 - 0.3 * (0.8 + 0.2 * 0.3) = 0.742, or 0.7 if lost before it is
  // copied; 1200 probes scatter by 0.013.
  EXPECT_NEAR(share(other.reception.heard(), other.reception.sent()), 0.72, 0.06);
  EXPECT_NEAR(share(other.us->heard, other.us->sent), 0.72, 0.06);
}

TEST(ProbeRound, TellsOneWayFromBoth) {
  Lan lan;
  ProbeRound& a = lan.add("lab1");
  ProbeRound& b = lan.add("lab2");
  lan.network->setLink(0, 1, MemoryLink::Cut);  // lab2 does not hear lab1
  lan.run(2);
  ASSERT_EQ(a.hosts().size(), 1u);
  EXPECT_FALSE(a.hosts().front()->hearsUs());
  EXPECT_FALSE(a.hosts().front()->roundTrip);
  EXPECT_FALSE(passesBothWays(a));
  EXPECT_TRUE(b.hosts().empty());
  const std::string report = probeReport(surroundings(1), a);
  EXPECT_NE(report.find("lab2                                   100 %   no"), std::string::npos)
      << report;
  EXPECT_NE(report.find("does not get back to it"), std::string::npos) << report;
}

TEST(ProbeReport, NamesTheOneThatDoesNotHearUs) {
  Lan lan;
  const ProbeRound& a = lan.add("lab1");
  lan.add("lab2");
  lan.add("lab3");
  lan.network->setLink(0, 2, MemoryLink::Cut);
  lan.run(2);
  EXPECT_TRUE(passesBothWays(a));
  const std::string report = probeReport(surroundings(1), a);
  EXPECT_NE(
      report.find("Multicast passes both ways.\nlab3 does not hear this machine: let UDP port "
                  "9171 and IGMP in there.\n"),
      std::string::npos)
      << report;
}

TEST(ProbeRound, ManyMachinesAnswerInTurns) {
  Lan lan;
  constexpr int kMachines = kMaxEchoesInMessage + 6;
  for (int i = 0; i < kMachines; ++i) lan.add("lab" + std::to_string(i));
  lan.run(2);
  for (const auto& round : lan.rounds) {
    ASSERT_EQ(round->hosts().size(), static_cast<std::size_t>(kMachines - 1));
    for (const ProbedHost* host : round->hosts()) EXPECT_TRUE(host->hearsUs()) << host->name;
  }
}

TEST(ProbeRound, NoticesPeersOfASession) {
  Lan lan;
  ProbeRound& a = lan.add("lab1");
  MemoryTransport peer(lan.network);
  Speaker speaker(3);
  say(peer, speaker.heartbeat(100));
  speaker.header(0);  // one is lost
  say(peer, speaker.statistics(101));
  lan.run(0.5);
  ASSERT_EQ(a.peers().size(), 1u);
  EXPECT_EQ(a.peers().front()->id, PeerId{3});
  EXPECT_EQ(a.peers().front()->reception.heard(), 2);
  EXPECT_EQ(a.peers().front()->reception.sent(), 3);
  EXPECT_FALSE(passesBothWays(a));
  const std::string report = probeReport(surroundings(1), a);
  EXPECT_NE(report.find("peer 3 of a session"), std::string::npos) << report;
  EXPECT_NE(report.find("run it on their machines"), std::string::npos) << report;
}

TEST(ProbeRound, IgnoresWhatIsNoProbe) {
  Lan lan;
  ProbeRound& a = lan.add("lab1");
  MemoryTransport other(lan.network);
  gravity_wells::probe_t probe{};
  probe.header.incarnation = 7;
  probe.header.sequence = 1;
  probe.host = "lab2";
  MessageBuffer buffer;
  const auto good = encodeProbe(probe, buffer);
  for (std::size_t size = 0; size < good.size(); ++size)
    other.publish(kProbeChannel, good.first(size));
  MessageBuffer spoilt = buffer;
  spoilt[good.size() - 4] = std::byte{0x7f};  // claims 2^31 echoes
  other.publish(kProbeChannel, std::span(spoilt).first(good.size()));
  const auto refuse = [&](auto change) {
    auto wrong = probe;
    change(wrong);
    other.publish(kProbeChannel, encodeProbe(wrong, spoilt));
  };
  refuse([](auto& p) { p.host = ""; });
  refuse([](auto& p) { p.host = "\033[2J"; });
  refuse([](auto& p) { p.host = std::string(kMaxHostName + 1, 'x'); });
  refuse([](auto& p) { p.header.incarnation = 0; });
  refuse([](auto& p) { p.header.sequence = 0; });
  refuse([](auto& p) {
    p.count = 1;
    p.echoes = {{1000, 2, 1, 1, 0}};  // more heard than sent
  });
  lan.run(0.1);
  EXPECT_TRUE(a.hosts().empty());
  other.publish(kProbeChannel, good);
  // An echo of what we have not sent yet measures nothing.
  probe.header.sequence = 2;
  probe.count = 1;
  probe.echoes = {{1000, 1, 1, 999, 0}};
  other.publish(kProbeChannel, encodeProbe(probe, buffer));
  lan.run(0.1);
  ASSERT_EQ(a.hosts().size(), 1u);
  EXPECT_FALSE(a.hosts().front()->roundTrip);
}

TEST(ProbeReport, SaysWhatToCheckWhenNobodyIsHeard) {
  Lan lan;
  const ProbeRound& a = lan.add("lab1");
  lan.run(1);
  const std::string report = probeReport(surroundings(0), a);
  for (const char* text :
       {"lab1: group 239.255.76.67:9171, ttl 0 (stays on this machine), by eth0 (10.0.0.5)\n",
        "Nobody else was heard in 5 s.\n", "ttl=1", "sudo ip route add 224.0.0.0/4",
        "udp dport 9171 accept", "use a cable"}) {
    EXPECT_NE(report.find(text), std::string::npos) << text << " is not in:\n" << report;
  }
  const std::string reaching = probeReport(surroundings(1), a);
  EXPECT_EQ(reaching.find("ttl=0"), std::string::npos) << reaching;
}

}  // namespace
}  // namespace wells
