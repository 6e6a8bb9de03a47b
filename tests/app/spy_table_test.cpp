#include "spy_table.h"

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

#include "app/watched.h"

namespace wells {
namespace {

constexpr std::int64_t kWall = 1'700'000'100'000'000;  // us

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string tableOf(const SessionWatch& watch, double now, double quiet = 0) {
  const auto sessions = watch.sessions();
  return spyTable(sessions, now, quiet);
}

gravity_wells::statistics_t statistics(Speaker& speaker, int owned) {
  auto m = speaker.statistics(1234);
  m.balls_owned = owned;
  m.balls_ghost = 30 - owned;
  m.simulation_rate = 59.87;
  m.simulation_target = 60;
  m.messages_sent_rate = 512.4;
  m.messages_received_rate = 1024;
  m.bytes_sent_rate = 402'000;
  m.bytes_received_rate = 1'234'567;
  m.dropped_by_kernel = 3;
  m.dropped_in_queue = 4;
  m.dropped_by_checks = 123'456;
  m.handovers_given = 7;
  m.handovers_taken = 8;
  m.adoptions = 9;
  m.doubled_ball_seconds = 12.34;
  m.view_difference_max = 1.5e-9;
  return m;
}

TEST(SpyTable, ShowsEachPeerAndTheTotals) {
  SessionWatch watch;
  Speaker a(1), b(2);
  SharedSettings settings;
  settings.learn("Gravity", {"off", 2, 77, "ann@lab1", 1000});
  settings.learn("Pause", {"true", 1, 78, "bob@lab2", 1260});
  say(watch, a.heartbeat(1234, Phase::Active, settings), {10, kWall});
  say(watch, b.heartbeat(1230), {10, kWall});
  say(watch, a.settings(1234, settings), {10, kWall});
  auto ofA = statistics(a, 12), ofB = statistics(b, 18);
  ofA.views = {{2, 2, 1850, -16, 4}};
  ofB.views = {{1, 2, 1700, 250, -4}};
  ofA.peers = ofB.peers = 1;
  say(watch, ofA, {10, kWall});
  say(watch, ofB, {10, kWall});
  EXPECT_EQ(tableOf(watch, 10.5),
            R"(Session 0-1700000000000000-00000000000000ff, step 1234, 2 peers
peer phase     owned ghosts  actual target lease  clock behind  doubled    view
               balls  balls steps/s            s     ms  steps   ball s  diff m
   1 active       12     18    59.9     60   1.7   +250     -4     12.3 1.5e-09
   2 active       18     12    59.9     60   1.9    -16     +4     12.3 1.5e-09
peer     sent        received         dropped by       handed over   adopted
     msgs/s   kB/s  msgs/s   kB/s  kernel queue checks   given taken   balls
   1    512    402    1024   1235       3     4   123k       7     8       9
   2    512    402    1024   1235       3     4   123k       7     8       9
all   30 of 30 balls owned; 1025 msgs/s, 804 kB/s sent
Settings that somebody changed:
Gravity = off, since step 1000, set by ann@lab1
Pause = true, from step 1260, set by bob@lab2
)");
}

TEST(SpyTable, ShowsTheWorstThatOthersSayOfAPeer) {
  SessionWatch watch;
  Speaker a(1), b(2), c(3);
  for (Speaker* speaker : {&a, &b, &c}) say(watch, speaker->heartbeat(100), {10, kWall});
  auto ofA = a.statistics(100), ofB = b.statistics(100);
  ofA.views = {{3, 2, 400, 100, 2}};
  ofB.views = {{3, 2, 1900, -300, 9}};
  ofA.peers = ofB.peers = 1;
  say(watch, ofA, {10, kWall});
  say(watch, ofB, {10, kWall});
  const auto line = linesOf(tableOf(watch, 10)).at(5);
  EXPECT_NE(line.find("   3 active       30      -       -      -   0.4   -300     +9"),
            std::string::npos)
      << line;
}

TEST(SpyTable, SaysThatAPeerIsSilentOrHasLeftAndThatNobodyIsHeard) {
  SessionWatch watch;
  EXPECT_EQ(tableOf(watch, 3, 3), "no peer heard for 3 s (how to check: ./run.sh peers)\n");
  Speaker a(1), b(2);
  say(watch, a.heartbeat(100), {10, kWall});
  say(watch, a.statistics(100), {10, kWall});
  say(watch, b.heartbeat(100, Phase::Leaving), {10, kWall});
  const auto lines = linesOf(tableOf(watch, 14, 4));
  EXPECT_EQ(lines.at(0), "Session 0-1700000000000000-00000000000000ff, step 100, 0 peers");
  EXPECT_EQ(lines.at(3).substr(0, 12), "   1 silent ");
  EXPECT_EQ(lines.at(4).substr(0, 10), "   2 left ");
  EXPECT_EQ(lines.back(), "no peer heard for 4 s (how to check: ./run.sh peers)");
}

TEST(SpyTable, NamesSeveralWorldsOnOneGroup) {
  SessionWatch watch;
  Speaker a(1), b(2, {0, 1'700'000'000'000'001, 9});
  auto foreign = b.heartbeat(50);
  foreign.world_hash = 0x1234'5678'9abc;
  say(watch, a.heartbeat(100), {10, kWall});
  say(watch, foreign, {10, kWall});
  const std::string table = tableOf(watch, 10);
  EXPECT_NE(table.find(", world 0000002a, 1 peer\n"), std::string::npos) << table;
  EXPECT_NE(table.find(", world 56789abc, 1 peer\n"), std::string::npos) << table;
}

TEST(SpyTable, IsNeverWiderThanEightyColumns) {
  constexpr auto kMost = std::numeric_limits<std::int64_t>::max() / 4;
  constexpr auto kMany = std::numeric_limits<std::int32_t>::max() / 2;
  SessionWatch watch;
  const Generation late{1'000'000'000, kMost, -1};
  Speaker a(255, late), b(254, late);
  SharedSettings settings;
  settings.learn("255.WellPosition", {std::string(120, '7'), 1, 77, std::string(60, 'n'), 1});
  constexpr std::int64_t kStep = std::int64_t{1} << 53;
  auto heartbeat = a.heartbeat(kStep, Phase::Active, settings);
  heartbeat.balls_owned = kMany;
  say(watch, heartbeat, {10, kWall});
  say(watch, b.heartbeat(0), {10, kWall});
  say(watch, a.settings(kStep, settings), {10, kWall});
  for (const double sign : {1.0, -1.0}) {
    for (Speaker* speaker : {&a, &b}) {
      auto m = speaker->statistics(kStep);
      m.balls_owned = m.balls_ghost = kMany;
      m.simulation_rate = m.simulation_target = sign * 123'456.7;
      m.messages_sent_rate = m.messages_received_rate = sign * 99'999.4;
      m.bytes_sent_rate = m.bytes_received_rate = sign * 1e300;
      m.dropped_by_kernel = m.dropped_in_queue = m.dropped_by_checks = kMost;
      m.handovers_given = m.handovers_taken = m.adoptions = kMost;
      m.doubled_ball_seconds = m.view_difference_max = sign * 1e300;
      for (const int peer : {254, 255})
        m.views.push_back({peer, 2, kMany, static_cast<std::int32_t>(-kMany), -kMost});
      m.peers = 2;
      say(watch, m, {10, kWall});
    }
    for (const std::string& line : linesOf(tableOf(watch, 10)))
      EXPECT_LE(line.size(), kSpyColumns) << line;
  }
}

}  // namespace
}  // namespace wells
