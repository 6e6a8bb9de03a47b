#include "network/message_queue.h"

#include <gtest/gtest.h>

#include "network/transport_test_tools.h"

namespace wells {
namespace {

TEST(MessageQueue, GivesBackWhatWasPushedInOrder) {
  MessageQueue queue(3);
  EXPECT_TRUE(queue.push("WELLS_A", bytesOf("one")));
  EXPECT_TRUE(queue.push("", bytesOf("")));
  EXPECT_TRUE(queue.push("WELLS_LONG_NAME", bytesOf(std::string(1400, 'x'))));
  ASSERT_EQ(queue.size(), 3u);
  EXPECT_EQ(queue.channel(0), "WELLS_A");
  EXPECT_STREQ(queue.channel(0).data(), "WELLS_A");
  EXPECT_EQ(textOf(queue.bytes(0)), "one");
  EXPECT_EQ(queue.channel(1), "");
  EXPECT_EQ(queue.bytes(1).size(), 0u);
  EXPECT_EQ(queue.channel(2), "WELLS_LONG_NAME");
  EXPECT_EQ(textOf(queue.bytes(2)), std::string(1400, 'x'));
}

TEST(MessageQueue, RefusesBeyondItsCapacityAndIsFreeAgainWhenCleared) {
  MessageQueue queue(1);
  EXPECT_TRUE(queue.push("A", bytesOf("first")));
  EXPECT_FALSE(queue.push("A", bytesOf("second")));
  EXPECT_EQ(queue.size(), 1u);
  queue.clear();
  EXPECT_TRUE(queue.empty());
  EXPECT_TRUE(queue.push("B", bytesOf("third")));
  EXPECT_EQ(queue.channel(0), "B");
  EXPECT_EQ(textOf(queue.bytes(0)), "third");
}

}  // namespace
}  // namespace wells
