#include "network/memory_transport.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "network/transport_test_tools.h"

namespace wells {
namespace {

TEST(MemoryTransport, EveryEndpointHearsEveryMessageItsSenderToo) {
  const auto network = std::make_shared<MemoryNetwork>();
  MemoryTransport a(network), b(network);
  a.publish("WELLS_A", bytesOf("one"));
  b.publish("WELLS_B", bytesOf("two"));
  const Received expected{{"WELLS_A", "one"}, {"WELLS_B", "two"}};
  EXPECT_EQ(drain(a), expected);
  EXPECT_EQ(drain(b), expected);
  EXPECT_EQ(drain(b), Received{});
  EXPECT_EQ(b.counts().messagesSent, 1);
  EXPECT_EQ(b.counts().bytesSent, 3);
  EXPECT_EQ(b.counts().messagesReceived, 2);
  EXPECT_EQ(b.counts().bytesReceived, 6);
  EXPECT_EQ(a.description(), "memory");
}

TEST(MemoryTransport, AHandlerMayPublishWithoutPollingForEver) {
  MemoryTransport solo(std::make_shared<MemoryNetwork>());
  solo.publish("WELLS_A", bytesOf("x"));
  int heard = 0;
  const auto echo = [&](std::string_view, std::span<const std::byte>) {
    ++heard;
    solo.publish("WELLS_A", bytesOf("x"));
  };
  solo.poll(echo);
  EXPECT_EQ(heard, 1);
  solo.poll(echo);
  EXPECT_EQ(heard, 2);
}

TEST(MemoryTransport, RefusesAndCountsAMessageThatIsTooLarge) {
  MemoryTransport solo(std::make_shared<MemoryNetwork>());
  solo.publish("WELLS_A", bytesOf(std::string(kMaxMessageBytes, 'x')));
  solo.publish("WELLS_A", bytesOf(std::string(kMaxMessageBytes + 1, 'x')));
  EXPECT_EQ(solo.counts().messagesSent, 1);
  EXPECT_EQ(solo.counts().droppedSending, 1);
  EXPECT_EQ(drain(solo).size(), 1u);
}

TEST(MemoryTransport, BoundsTheQueueOfAnEndpointThatDoesNotPoll) {
  MemoryTransport solo(std::make_shared<MemoryNetwork>());
  for (std::size_t i = 0; i < MemoryNetwork::kCapacity + 3; ++i) solo.publish("WELLS_A", {});
  EXPECT_EQ(solo.counts().droppedReceiving, 3);
  EXPECT_EQ(drain(solo).size(), MemoryNetwork::kCapacity);
}

TEST(MemoryTransport, ASmallBufferLosesWhatComesWhileItIsFull) {
  const auto network = std::make_shared<MemoryNetwork>();
  MemoryTransport small(network), large(network);
  network->setCapacity(small.endpoint(), 2);
  for (const char* text : {"1", "2", "3"}) large.publish("WELLS_A", bytesOf(text));
  EXPECT_EQ(drain(small), (Received{{"WELLS_A", "1"}, {"WELLS_A", "2"}}));
  EXPECT_EQ(small.counts().droppedReceiving, 1);
  network->setCapacity(small.endpoint(), MemoryNetwork::kCapacity);
  for (const char* text : {"4", "5", "6"}) large.publish("WELLS_A", bytesOf(text));
  EXPECT_EQ(drain(small).size(), 3u);
  EXPECT_EQ(drain(large).size(), 6u);
  EXPECT_EQ(large.counts().droppedReceiving, 0);
}

TEST(MemoryTransport, AMessageArrivesWhenItsDelayIsOver) {
  const auto network = std::make_shared<MemoryNetwork>(1, MemoryFaults{.delay = 0.5});
  MemoryTransport a(network);
  a.publish("WELLS_A", bytesOf("x"));
  network->advance(0.375);
  EXPECT_EQ(drain(a).size(), 0u);
  network->advance(0.125);
  EXPECT_EQ(drain(a).size(), 1u);
}

TEST(MemoryTransport, JitterReordersWithinItsBoundsOnly) {
  const auto network =
      std::make_shared<MemoryNetwork>(3, MemoryFaults{.delay = 0.01, .jitter = 0.05});
  MemoryTransport a(network);
  constexpr int kMessages = 1000;
  std::vector<double> arrival(kMessages, -1);
  std::vector<int> order;
  for (int tick = 0; tick < kMessages + 100; ++tick) {
    if (tick < kMessages) a.publish("WELLS_A", bytesOf(std::to_string(tick)));
    for (const auto& [channel, text] : drain(a)) {
      order.push_back(std::stoi(text));
      arrival[static_cast<std::size_t>(order.back())] = network->now();
    }
    network->advance(0x1p-10);
  }
  ASSERT_EQ(order.size(), static_cast<std::size_t>(kMessages));
  for (int i = 0; i < kMessages; ++i) {
    const double took = arrival[static_cast<std::size_t>(i)] - i * 0x1p-10;
    EXPECT_GE(took, 0.01);
    EXPECT_LT(took, 0.06 + 0x1p-10);
  }
  EXPECT_FALSE(std::is_sorted(order.begin(), order.end()));
}

TEST(MemoryTransport, LossAndDuplicationHaveTheirProbabilities) {
  const auto network =
      std::make_shared<MemoryNetwork>(7, MemoryFaults{.loss = 0.3, .duplication = 0.1});
  MemoryTransport a(network);
  constexpr int kMessages = 100'000;
  std::vector<int> copies(kMessages, 0);
  for (int i = 0; i < kMessages; ++i) {
    a.publish("WELLS_A", bytesOf(std::to_string(i)));
    for (const auto& [channel, text] : drain(a))
      ++copies[static_cast<std::size_t>(std::stoi(text))];
  }
  const auto share = [&](int n) {
    return static_cast<double>(std::count(copies.begin(), copies.end(), n)) / kMessages;
  };
  // Five standard deviations of a binomial share.
  const auto bound = [](double p) { return 5 * std::sqrt(p * (1 - p) / kMessages); };
  EXPECT_NEAR(share(0), 0.3, bound(0.3));
  EXPECT_NEAR(share(2), 0.07, bound(0.07));
  EXPECT_NEAR(share(1), 0.63, bound(0.63));
}

TEST(MemoryTransport, ACutIsOneWayAndSparesWhatIsUnderWay) {
  const auto network = std::make_shared<MemoryNetwork>(1, MemoryFaults{.delay = 1});
  MemoryTransport a(network), b(network);
  a.publish("WELLS_A", bytesOf("before"));
  network->setLink(a.endpoint(), b.endpoint(), MemoryLink::Cut);
  a.publish("WELLS_A", bytesOf("during"));
  b.publish("WELLS_B", bytesOf("back"));
  network->setLink(a.endpoint(), b.endpoint(), MemoryLink::Up);
  a.publish("WELLS_A", bytesOf("after"));
  network->advance(1);
  EXPECT_EQ(drain(b), (Received{{"WELLS_A", "before"}, {"WELLS_B", "back"}, {"WELLS_A", "after"}}));
  EXPECT_EQ(drain(a).size(), 4u);
}

TEST(MemoryTransport, ACrashedEndpointsMessagesStillArriveAndItsNumberIsNotUsedAgain) {
  const auto network = std::make_shared<MemoryNetwork>(1, MemoryFaults{.delay = 1});
  MemoryTransport a(network);
  auto b = std::make_unique<MemoryTransport>(network);
  b->publish("WELLS_B", bytesOf("last words"));
  const int before = b->endpoint();
  b.reset();
  b = std::make_unique<MemoryTransport>(network);
  network->advance(1);
  EXPECT_NE(b->endpoint(), before);
  EXPECT_EQ(drain(a), (Received{{"WELLS_B", "last words"}}));
  EXPECT_EQ(drain(*b), Received{});
}

Received runWithSeed(std::uint64_t seed) {
  const auto network = std::make_shared<MemoryNetwork>(
      seed, MemoryFaults{.loss = 0.2, .duplication = 0.2, .delay = 0.01, .jitter = 0.1});
  MemoryTransport a(network), b(network), c(network);
  Received all;
  for (int tick = 0; tick < 200; ++tick) {
    a.publish("WELLS_A", bytesOf(std::to_string(tick)));
    b.publish("WELLS_B", bytesOf(std::to_string(tick)));
    network->advance(0.01);
    for (const auto& message : drain(c)) all.push_back(message);
  }
  return all;
}

TEST(MemoryTransport, TheSameSeedGivesTheSameArrivals) {
  EXPECT_EQ(runWithSeed(11), runWithSeed(11));
  EXPECT_NE(runWithSeed(11), runWithSeed(12));
}

TEST(MemoryTransport, RefusesImpossibleFaults) {
  EXPECT_THROW(MemoryNetwork(1, {.loss = 1.5}), std::invalid_argument);
  EXPECT_THROW(MemoryNetwork(1, {.duplication = -0.1}), std::invalid_argument);
  EXPECT_THROW(MemoryNetwork(1, {.delay = -1}), std::invalid_argument);
  EXPECT_THROW(MemoryNetwork(1, {.jitter = std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace wells
