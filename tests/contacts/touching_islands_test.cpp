#include "contacts/touching_islands.h"

#include <gtest/gtest.h>

#include <vector>

namespace wells {
namespace {

Contact acting(std::uint32_t a, std::uint32_t b) {
  Contact c{.a = a, .b = b};
  c.acts = true;
  return c;
}

// 0-1, 3-4, 1-2 and 5 on the ground; 2-3 does not act, and the ground ties nothing together.
TEST(TouchingIslands, HangTogetherByBallsThatAct) {
  std::vector<Contact> balls = {acting(0, 1), acting(1, 2), acting(3, 4)};
  balls.push_back({.a = 2, .b = 3});
  std::vector<Contact> arena = {acting(0, kGround), acting(4, kGround), acting(5, kGround)};
  TouchingIslands islands;
  for (int again = 0; again < 2; ++again) {
    islands.find(balls, arena, 6);
    ASSERT_EQ(islands.count(), 3u);
    const std::vector<std::vector<Contact*>> expected = {
        {&balls[0], &balls[1], &arena[0]}, {&balls[2], &arena[1]}, {&arena[2]}};
    for (std::size_t n = 0; n < 3; ++n) {
      const auto found = islands.contacts(n);
      EXPECT_EQ(std::vector<Contact*>(found.begin(), found.end()), expected[n]) << n;
    }
  }
  islands.find({}, {}, 6);
  EXPECT_EQ(islands.count(), 0u);
}

}  // namespace
}  // namespace wells
