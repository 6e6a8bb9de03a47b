// Runs in a network namespace of its own that has no route for multicast.
#include <gtest/gtest.h>

#include "network/lcm_transport.h"

namespace wells {
namespace {

TEST(LcmTransport, WithoutAMulticastRouteTheErrorNamesTheCommandThatAddsOne) {
  testing::internal::CaptureStderr();
  try {
    LcmTransport transport(lcmUrl(9220, 0), 60);
    ADD_FAILURE() << "was opened";
  } catch (const TransportError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("239.255.76.67:9220"), std::string::npos) << what;
    EXPECT_NE(what.find("sudo ip route add 224.0.0.0/4 dev <interface>"), std::string::npos)
        << what;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace wells
