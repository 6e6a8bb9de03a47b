#include "setting_checks.h"

#include <gtest/gtest.h>

namespace wells {
namespace {

TEST(WellSetting, IsAPeerAndAName) {
  const auto strength = wellSetting("2.WellStrength");
  ASSERT_TRUE(strength);
  EXPECT_EQ(strength->peer, PeerId{2});
  EXPECT_EQ(strength->name, "WellStrength");
  EXPECT_EQ(wellSetting("255.Well")->peer, PeerId{255});
  for (const char* key :
       {"", ".", "Well", ".Well", "0.Well", "256.Well", "02.Well", "+2.Well", "-1.Well", " 2.Well",
        "2.", "2.well", "2.WellSoftening", "2.2.Well", "2.Gravity", "99999999999999999999.Well"}) {
    EXPECT_FALSE(wellSetting(key)) << key;
  }
}

TEST(PeerSetting, TakesWhatTheConfigTakes) {
  using Setting = std::pair<const char*, const char*>;
  for (const auto& [key, value] :
       {Setting{"NetworkRate", "10"}, Setting{"NetworkRate", "1000"}, Setting{"1.Well", "off"},
        Setting{"1.Well", "attract"}, Setting{"1.Well", "repel"},
        Setting{"3.WellStrength", "-40.f"}, Setting{"3.WellStrength", "0"},
        Setting{"2.WellPosition", "1, -2.5,3e2"}, Setting{"2.WellPath", "still"},
        Setting{"2.WellPath", "circle,20,-8"}}) {
    EXPECT_EQ(checkPeerSetting(key, value), std::nullopt) << key << "=" << value;
  }
}

TEST(PeerSetting, NamesKeyValueAndWhatIsAllowed) {
  EXPECT_EQ(checkPeerSetting("NetworkRate", "5"),
            "NetworkRate is 5; it must be a number 10 to 1000, in Hz");
  EXPECT_EQ(checkPeerSetting("2.Well", "on"), "2.Well is on; it must be attract, repel or off");
  EXPECT_EQ(checkPeerSetting("2.WellPosition", "1,2"),
            "2.WellPosition is 1,2; it must be x,y,z: three numbers -1e6 to 1e6, in m");
  EXPECT_EQ(checkPeerSetting("2.WellStrength", "nan"),
            "2.WellStrength is nan; it must be a number -1e15 to 1e15, in m^3/s^2");
  // A file of one machine is none of another's.
  for (const char* path : {"path.csv", "/etc/passwd", "circle", "circle,1", ""}) {
    EXPECT_EQ(checkPeerSetting("2.WellPath", path),
              std::string("2.WellPath is ") + path +
                  "; it must be still, or circle,R,period with R 0 to 1e6 (m) and a period of 0.1 "
                  "to 1e9 s (negative: the other way round)");
  }
}

TEST(PeerSetting, RefusesKeysThatAreNotItsOwn) {
  for (const char* key : {"", "Gravity", "networkrate", "Well", "0.Well", "PeerID", "BallsFile"}) {
    EXPECT_EQ(checkPeerSetting(key, "1"), std::string(key) + ": no such setting");
  }
}

}  // namespace
}  // namespace wells
