#include "session_watch.h"

#include <gtest/gtest.h>

#include "app/watched.h"

namespace wells {
namespace {

constexpr std::int64_t kWall = 1'700'000'100'000'000;  // us, of the speakers

TEST(SessionWatch, PutsPeersOfOneWorldAndGenerationIntoOneSession) {
  SessionWatch watch;
  Speaker a(2), b(1), other(3, {0, 1'600'000'000'000'000, 7}), joiner(4, {});
  say(watch, a.heartbeat(100), {10, kWall});
  say(watch, joiner.heartbeat(0, Phase::Joining), {10, kWall});
  say(watch, b.heartbeat(103), {10, kWall});
  say(watch, other.heartbeat(5), {10, kWall});
  say(watch, b.config(103), {10, kWall});

  const auto sessions = watch.sessions();
  ASSERT_EQ(sessions.size(), 3u);
  EXPECT_EQ(sessions[0].generation.nonce, 7) << "founded first";
  EXPECT_EQ(sessions[1].generation, kGeneration);
  ASSERT_EQ(sessions[1].peers.size(), 2u);
  EXPECT_EQ(sessions[1].peers[0]->id(), PeerId{1});
  EXPECT_EQ(sessions[1].peers[1]->id(), PeerId{2});
  EXPECT_EQ(sessions[1].step, 103);
  EXPECT_NE(sessions[1].canonical.value_or("").find("NumOfBalls=30"), std::string::npos);
  EXPECT_FALSE(sessions[2].generation.exists());
  EXPECT_TRUE(sessions[2].active(10).empty());
}

TEST(SessionWatch, KnowsWhoIsHereWhoIsSilentAndWhoLeft) {
  SessionWatch watch;
  Speaker a(1), b(2);
  EXPECT_FALSE(watch.lastHeard());
  say(watch, a.heartbeat(100), {10, kWall});
  say(watch, b.heartbeat(100), {11, kWall});
  say(watch, b.heartbeat(101, Phase::Leaving), {11.5, kWall});
  EXPECT_EQ(watch.lastHeard(), 11.5);
  const auto sessions = watch.sessions();
  const auto& peers = sessions.at(0).peers;
  EXPECT_EQ(peers.at(0)->presence(12), Presence::Here);
  EXPECT_EQ(peers.at(0)->presence(12.1), Presence::Silent) << "its lease is 2 s";
  EXPECT_EQ(peers.at(1)->presence(11.6), Presence::Left);
  watch.forget(10 + SessionWatch::kMemory + 1);
  EXPECT_EQ(watch.sessions().at(0).peers.size(), 1u);
}

TEST(SessionWatch, LateMessagesDoNotCount) {
  SessionWatch watch;
  Speaker a(1);
  const auto first = a.heartbeat(100), second = a.heartbeat(106);
  say(watch, second, {10, kWall});
  say(watch, first, {10.1, kWall});
  EXPECT_EQ(watch.sessions().at(0).step, 106);
  // A record that is played again after a while.
  say(watch, first, {13, kWall});
  EXPECT_EQ(watch.sessions().at(0).step, 100);
}

TEST(SessionWatch, MeasuresTheWallClock) {
  SessionWatch watch;
  Speaker a(1);
  say(watch, a.heartbeat(100), {10, kWall - 250'000});
  EXPECT_EQ(watch.sessions().at(0).peers.at(0)->wallOffsetUs, 250'000);
}

TEST(SessionWatch, KnowsTheSettingsWhenTheDigestSaysSo) {
  SessionWatch watch;
  Speaker a(1), b(2);
  SharedSettings older, newer;
  older.learn("Gravity", {"off", 1, 77, "ann@lab", 40});
  newer = older;
  newer.learn("Pause", {"true", 1, 78, "bob@lab", 90});
  say(watch, a.heartbeat(100, Phase::Active, newer), {10, kWall});
  say(watch, b.heartbeat(100, Phase::Active, older), {10, kWall});
  EXPECT_FALSE(watch.sessions().at(0).knowsSettings(10));
  say(watch, b.settings(100, older), {10, kWall});
  EXPECT_FALSE(watch.sessions().at(0).knowsSettings(10)) << "peer 1 knows more";
  say(watch, a.settings(100, newer), {10, kWall});
  const WatchedSession session = watch.sessions().at(0);
  EXPECT_TRUE(session.knowsSettings(10));
  EXPECT_EQ(session.settings.registers(), newer.registers());
}

TEST(SessionWatch, AnotherGenerationForgetsTheSettingsOfTheOneBefore) {
  SessionWatch watch;
  Speaker a(1);
  SharedSettings settings;
  settings.learn("Gravity", {"off", 1, 77, "ann@lab", 40});
  say(watch, a.heartbeat(100, Phase::Active, settings), {10, kWall});
  say(watch, a.settings(100, settings), {10, kWall});
  a.setGeneration({1, kGeneration.foundedUs + 1, 3});
  settings.restart();
  say(watch, a.settings(0, settings), {10.1, kWall});
  say(watch, a.heartbeat(0, Phase::Active, settings), {10.2, kWall});
  EXPECT_FALSE(watch.sessions().at(0).knowsSettings(10.2));
  say(watch, a.settings(1, settings), {10.3, kWall});
  EXPECT_EQ(watch.sessions().at(0).settings.inForce("Gravity", 0)->fromStep, 0);
}

TEST(SessionWatch, IgnoresWhatIsNoMessageOfOurs) {
  SessionWatch watch;
  const std::byte junk[100]{};
  for (const char* channel : {"WELLS_HEARTBEAT", "WELLS_STATISTICS", "WELLS_NEW", "CAMERA"})
    watch.hear(channel, junk, {1, 1});
  Speaker a(1);
  say(watch, a.statistics(10), {1, 1});  // nobody has introduced itself
  EXPECT_TRUE(watch.sessions().empty());
  EXPECT_FALSE(watch.lastHeard());
}

}  // namespace
}  // namespace wells
