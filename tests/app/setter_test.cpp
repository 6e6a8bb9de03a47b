#include "setter.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "app/watched.h"
#include "errors.h"
#include "network/memory_transport.h"
#include "network/session_group.h"
#include "settable_keys.h"
#include "setting_checks.h"
#include "setting_list.h"

namespace wells {
namespace {

constexpr std::int64_t kWall = 1'700'000'100'000'000;  // us
const SettingAuthor kAuthor{4711, "ann@lab1"};

enum class Hearing { Good, Deaf };

// As much of a peer as a Setter sees.
class FakePeer {
 public:
  FakePeer(int id, std::shared_ptr<MemoryNetwork> network, const Generation& generation)
      : speaker_(id, generation), transport_(std::move(network)) {}

  void tick(double now) {
    transport_.poll([&](std::string_view channel, std::span<const std::byte> bytes) {
      if (channel == "WELLS_REQUEST") hear(bytes);
    });
    if (now >= nextHeartbeat_) {
      nextHeartbeat_ = now + 0.1;
      say(transport_, speaker_.heartbeat(step, phase, settings));
    }
    if (now >= nextSettings_ && !settings.registers().empty()) {
      nextSettings_ = now + 1;
      for (const auto& [key, value] : settings.registers()) {
        SharedSettings one;
        one.learn(key, value);
        say(transport_, speaker_.settings(step, one));
      }
    }
  }

  Hearing hearing = Hearing::Good;
  Phase phase = Phase::Active;
  std::int64_t step = 1000;
  SharedSettings settings;
  std::vector<gravity_wells::request_t> requests;

 private:
  void hear(std::span<const std::byte> bytes) {
    const auto decoded = decode("WELLS_REQUEST", bytes, {});
    const auto* message = std::get_if<Message>(&decoded);
    ASSERT_TRUE(message) << "peers refuse it: " << name(std::get<Drop>(decoded));
    requests.push_back(std::get<gravity_wells::request_t>(*message));
    if (hearing == Hearing::Deaf) return;
    for (const auto& s : requests.back().settings)
      if (settings.learn(s.key, {s.value, s.version, s.setter, s.set_by, s.from_step}))
        nextSettings_ = 0;
  }

  Speaker speaker_;
  MemoryTransport transport_;
  double nextHeartbeat_ = 0, nextSettings_ = 0;  // s
};

struct Lab {
  FakePeer& add(int id, const Generation& generation = kGeneration) {
    peers.push_back(std::make_unique<FakePeer>(id, network, generation));
    return *peers.back();
  }

  /// Runs the setter to its end; s that it took.
  double run(Setter& setter) {
    const double start = network->now();
    while (!setter.isOver() && network->now() < start + 20) {
      network->advance(0.005);
      for (auto& peer : peers) peer->tick(network->now());
      setter.tick({network->now(), kWall});
    }
    return network->now() - start;
  }

  std::vector<std::string> set(std::vector<WantedSetting> wanted) {
    MemoryTransport transport(network);
    Setter setter(transport, std::move(wanted), kAuthor);
    seconds = run(setter);
    isConfirmed = setter.isConfirmed();
    std::vector<std::string> texts;
    for (const SettingChange& change : setter.changes()) texts.push_back(changeText(change));
    return texts;
  }

  std::string refusal(std::vector<WantedSetting> wanted) {
    try {
      set(std::move(wanted));
    } catch (const RunError& error) {
      for (const auto& peer : peers) EXPECT_TRUE(peer->requests.empty()) << "nothing was sent";
      return error.what();
    }
    return "";
  }

  std::shared_ptr<MemoryNetwork> network = std::make_shared<MemoryNetwork>();
  std::vector<std::unique_ptr<FakePeer>> peers;
  double seconds = 0;
  bool isConfirmed = false;
};

using Texts = std::vector<std::string>;

TEST(Setter, ChangesASettingOfAllPeers) {
  Lab lab;
  FakePeer& a = lab.add(1);
  FakePeer& b = lab.add(2);
  b.step = 1004;
  EXPECT_EQ(lab.set({{"Gravity", "off"}}),
            Texts{"Gravity: on -> off, from step 1034, confirmed by peers 1, 2"});
  EXPECT_TRUE(lab.isConfirmed);
  EXPECT_LT(lab.seconds, 1);
  EXPECT_EQ(a.settings.registers().at("Gravity"), (Register{"off", 1, 4711, "ann@lab1", 1034}));
  EXPECT_EQ(a.settings.digest(), b.settings.digest());
  const auto& header = a.requests.front().header;
  EXPECT_EQ(header.peer_id, 0);
  EXPECT_EQ(header.incarnation, 4711);
  EXPECT_EQ(header.generation_nonce, kGeneration.nonce);
  EXPECT_EQ(header.utime, kWall);
}

TEST(Setter, FollowsWhatWasSetBefore) {
  Lab lab;
  for (int id : {1, 2}) lab.add(id).settings.learn("Elasticity", {"0.5", 7, 99, "bob@lab2", 800});
  EXPECT_EQ(lab.set({{"Elasticity", "0.75"}}),
            Texts{"Elasticity: 0.5 -> 0.75, from step 1030, confirmed by peers 1, 2"});
  EXPECT_EQ(lab.peers.front()->settings.registers().at("Elasticity").version, 8);
}

TEST(Setter, SetsMoreThanOneRequestHolds) {
  Lab lab;
  FakePeer& a = lab.add(1);
  lab.set({{"Pause", "true"},
           {"Gravity", "reversed"},
           {"Elasticity", "0"},
           {"Friction", "0"},
           {"1.Well", "off"}});
  EXPECT_TRUE(lab.isConfirmed);
  EXPECT_EQ(a.settings.registers().size(), 5u);
}

TEST(Setter, InAPauseItHoldsFromTheStepAtWhichAllStand) {
  Lab lab;
  FakePeer& a = lab.add(1);
  a.settings.learn("Pause", {"true", 1, 99, "bob@lab2", 990});
  EXPECT_EQ(lab.set({{"Pause", "false"}}),
            Texts{"Pause: true -> false, from step 1000, confirmed by peer 1"});
}

TEST(Setter, BeforeAPauseThatIsToComeItHoldsFromThatOn) {
  Lab lab;
  FakePeer& a = lab.add(1);
  a.settings.learn("Pause", {"true", 1, 99, "bob@lab2", 1020});
  EXPECT_EQ(lab.set({{"Gravity", "off"}}),
            Texts{"Gravity: on -> off, from step 1020, confirmed by peer 1"});
}

TEST(Setter, AsksForOneMoreReset) {
  Lab lab;
  FakePeer& a = lab.add(1, {4, kGeneration.foundedUs, 1});
  EXPECT_EQ(lab.set({{"Reset", "now"}}),
            Texts{"Reset: number 5, the world starts over, confirmed by peer 1"});
  EXPECT_EQ(a.settings.registers().at("Reset").value, "5");
  EXPECT_EQ(lab.set({{"Reset", "now"}}),
            Texts{"Reset: number 6, the world starts over, confirmed by peer 1"})
      << "one was asked for already";
}

TEST(Setter, NamesThePeersThatDoNotConfirm) {
  Lab lab;
  lab.add(1);
  lab.add(2).hearing = Hearing::Deaf;
  lab.add(3).phase = Phase::Syncing;
  EXPECT_EQ(
      lab.set({{"Gravity", "off"}}),
      Texts{"Gravity: on -> off, from step 1030, confirmed by peer 1, not confirmed by peer 2"});
  EXPECT_FALSE(lab.isConfirmed);
  EXPECT_NEAR(lab.seconds, SessionFinder::kShortest + Setter::kPatience, 0.1);
  EXPECT_GE(lab.peers[1]->requests.size(), 10u) << "it asks again";
}

TEST(Setter, SaysWhenSomebodyElseWasStronger) {
  Lab lab;
  FakePeer& a = lab.add(1);
  MemoryTransport transport(lab.network);
  Setter setter(transport, {{"Gravity", "off"}}, kAuthor);
  while (setter.changes().empty()) {
    lab.network->advance(0.005);
    a.tick(lab.network->now());
    setter.tick({lab.network->now(), kWall});
  }
  a.settings.learn("Gravity", {"reversed", 1, 9999, "bob@lab2", 1020});
  lab.run(setter);
  EXPECT_EQ(changeText(setter.changes().front()),
            "Gravity: on -> off, from step 1030, confirmed by peer 1; bob@lab2 has meanwhile set "
            "it to reversed, and that holds");
}

TEST(Setter, RefusesWhereThereIsNotOneSession) {
  Lab lab;
  EXPECT_EQ(lab.refusal({{"Pause", "true"}}),
            "no session: no peer was heard; ./run.sh peers tells whether multicast passes");
  lab.add(1, {}).phase = Phase::Joining;
  EXPECT_EQ(lab.refusal({{"Pause", "true"}}),
            "no session yet: peer 1 is joining; try again in some seconds");
  lab.add(2);
  lab.add(3, {0, 1'600'000'000'000'000, 7});
  EXPECT_EQ(lab.refusal({{"Pause", "true"}}),
            "2 sessions are on this group: 0-1600000000000000-0000000000000007 of world 0000002a "
            "with peers 3; 0-1700000000000000-00000000000000ff of world 0000002a with peers 2; "
            "they become one in some seconds");
}

TEST(Setter, RefusesAWellWithoutAPeerAndOneSettingTooMany) {
  Lab lab;
  FakePeer& a = lab.add(1);
  lab.add(3);
  EXPECT_EQ(lab.refusal({{"Pause", "true"}, {"2.Well", "off"}}),
            "2.Well: the session has no peer 2; it has 1, 3");
  lab.peers.pop_back();
  // Of wells whose peers are gone.
  for (std::size_t i = 0; i < kMaxSharedSettings; ++i)
    a.settings.learn(std::to_string(100 + i) + ".Well", {"off", 1, 1, "bob@lab2", 1});
  EXPECT_EQ(lab.refusal({{"Friction", "0.5"}}),
            "Friction: 64 settings are set already, and no more can be");
}

TEST(SettableKeys, SayWhatThePeersCheck) {
  for (const SettableKey& key : settableKeys()) {
    const std::string name = key.isOfAWell() ? "7" + key.name.substr(1) : key.name;
    EXPECT_EQ(findSettableKey(name), &key);
    EXPECT_NE(settingFault(name, "?").find(key.allowed), std::string::npos)
        << settingFault(name, "?") << " does not say: " << key.allowed;
  }
  EXPECT_EQ(findSettableKey("N.Well"), nullptr);
}

TEST(SettableKeys, SuggestTheNearestOne) {
  EXPECT_NE(settingFault("gravity", "off").find("did you mean Gravity?"), std::string::npos);
  EXPECT_NE(settingFault("2.WellPositon", "0,0,0").find("did you mean 2.WellPosition?"),
            std::string::npos);
  EXPECT_NE(settingFault("WellPath", "still").find("did you mean N.WellPath?"), std::string::npos);
  EXPECT_EQ(settingFault("Volume", "11").find("did you mean"), std::string::npos);
}

TEST(SettableKeys, TakeGoodValuesOnly) {
  for (const auto& [key, value] :
       std::vector<std::pair<const char*, const char*>>{{"Pause", "true"},
                                                        {"Reset", "now"},
                                                        {"NetworkRate", "60"},
                                                        {"9.WellPath", "circle,5,8"}})
    EXPECT_EQ(settingFault(key, value), "");
  EXPECT_EQ(settingFault("Reset", "1"), "Reset is 1; it must be now");
  EXPECT_EQ(settingFault("Elasticity", "1.5"), "Elasticity is 1.5; it must be 0 to 1");
  EXPECT_NE(settingFault("1.WellPosition", "1,\t2,3"), "");
  EXPECT_NE(settingFault("1.WellPosition", std::string(130, ' ') + "1,2,3"), "");
}

TEST(SettingList, ShowsWhatHoldsSinceWhenByWhomAndWhatIsToCome) {
  SessionWatch watch;
  Speaker a(1);
  SharedSettings settings;
  settings.learn("Gravity", {"off", 1, 77, "ann@lab1", 900});
  settings.learn("Gravity", {"on", 2, 77, "ann@lab1", 1030});
  settings.learn("2.Well", {"repel", 1, 78, "bob@lab2", 500});
  say(watch, a.heartbeat(1000, Phase::Active, settings), {10, kWall});
  SharedSettings before;
  before.learn("Gravity", {"off", 1, 77, "ann@lab1", 900});
  say(watch, a.settings(1000, before), {10, kWall});
  say(watch, a.settings(1000, settings), {10, kWall});
  say(watch, a.config(1000), {10, kWall});
  EXPECT_EQ(settingList(watch.sessions().front(), 10),
            "Session 0-1700000000000000-00000000000000ff, step 1000, active peers 1\n"
            "In force:\n"
            "  Pause = false\n"
            "  SimulationRate = as configured\n"
            "  NetworkRate = as configured\n"
            "  Gravity = off, since step 900, set by ann@lab1\n"
            "  Elasticity = 0.8, as configured\n"
            "  Friction = 0.3, as configured\n"
            "  RollingResistance = 0, as configured\n"
            "  Reset = never\n"
            "  2.Well = repel, since step 500, set by bob@lab2\n"
            "To come:\n"
            "  Gravity = on, from step 1030, set by ann@lab1\n");
}

// Against real sessions.
TEST(Setter, ChangesRealSessionsThatLoseMessages) {
  Group group(30, 5, {.loss = 0.2, .duplication = 0.1, .delay = 0.02, .jitter = 0.05});
  for (int id : {1, 2, 3}) {
    SessionOptions options = testOptions(id);
    options.checkSetting = checkPeerSetting;
    group.add(std::move(options));
  }
  ASSERT_TRUE(group.runUntil([&] { return group.allActiveInOneGeneration(); }, 30));
  std::int64_t number = 0;
  for (const auto& [key, value] :
       std::vector<std::pair<std::string, std::string>>{{"Gravity", "reversed"},
                                                        {"3.WellStrength", "-5"},
                                                        {"Pause", "true"},
                                                        {"Pause", "false"},
                                                        {"NetworkRate", "20"}}) {
    MemoryTransport transport(group.sharedNetwork());
    Setter setter(transport, {{key, value}}, {++number, "ann@lab1"});
    ASSERT_TRUE(group.runUntil(
        [&] {
          setter.tick(group.timesOf(*group.peers().front()));
          return setter.isOver();
        },
        10));
    EXPECT_TRUE(setter.isConfirmed()) << changeText(setter.changes().front());
    group.run(1.5);
    for (const auto& peer : group.peers()) {
      const Register* holds = peer->session->settings().inForce(key, peer->world.step);
      ASSERT_TRUE(holds) << key;
      EXPECT_EQ(holds->value, value) << key;
    }
  }
  EXPECT_GT(group.peers().front()->world.settings.gravity.y(), 0);
}

}  // namespace
}  // namespace wells
