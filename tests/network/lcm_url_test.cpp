#include "network/lcm_url.h"

#include <gtest/gtest.h>

namespace wells {
namespace {

TEST(LcmUrl, OursNamesPortTtlAndReceiveBuffer) {
  EXPECT_EQ(lcmUrl(9171, 0), "udpm://239.255.76.67:9171?ttl=0&recv_buf_size=2097152");
}

TEST(LcmUrl, WhatIsLeftOutKeepsItsDefault) {
  EXPECT_EQ(parseLcmUrl("udpm://").text(), LcmUrl{}.text());
  EXPECT_EQ(parseLcmUrl("udpm://239.1.2.3").text(),
            "udpm://239.1.2.3:7667?ttl=0&recv_buf_size=2097152");
  EXPECT_EQ(parseLcmUrl("udpm://239.1.2.3:4000?ttl=2").text(),
            "udpm://239.1.2.3:4000?ttl=2&recv_buf_size=2097152");
  EXPECT_EQ(parseLcmUrl("udpm://?recv_buf_size=1000&ttl=1").text(),
            "udpm://239.255.76.67:7667?ttl=1&recv_buf_size=1000");
}

TEST(LcmUrl, AWrongPartIsNamedWithItsValueAndWhatIsAllowed) {
  struct Case {
    const char* url;
    std::vector<const char*> named;
  };
  const Case cases[] = {
      {"", {"udpm://"}},
      {"memq://", {"memq://", "udpm://"}},
      {"udpm://10.0.0.1:7667", {"group", "10.0.0.1", "224.0.0.0 to 239.255.255.255"}},
      {"udpm://host:7667", {"group", "host"}},
      {"udpm://239.1.2.3:0", {"port", "\"0\"", "1 to 65535"}},
      {"udpm://239.1.2.3:70000", {"port", "70000"}},
      {"udpm://239.1.2.3:80x", {"port", "80x"}},
      {"udpm://239.1.2.3:80?ttl=256", {"ttl", "256", "0 to 255"}},
      {"udpm://239.1.2.3:80?ttl=", {"ttl", "\"\""}},
      {"udpm://239.1.2.3:80?recv_buf_size=-1", {"recv_buf_size", "-1"}},
      {"udpm://239.1.2.3:80?hops=1", {"hops", "ttl and recv_buf_size"}},
  };
  for (const auto& [url, named] : cases) {
    try {
      parseLcmUrl(url);
      ADD_FAILURE() << url << " was accepted";
    } catch (const LcmUrlError& error) {
      for (const char* part : named)
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
            << error.what() << " does not name " << part;
    }
  }
  EXPECT_THROW(lcmUrl(0, 0), LcmUrlError);
  EXPECT_THROW(lcmUrl(65536, 0), LcmUrlError);
  EXPECT_THROW(lcmUrl(9171, -1), LcmUrlError);
}

}  // namespace
}  // namespace wells
