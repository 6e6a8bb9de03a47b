// What a ProbeRound found out, for people: who was heard, and what to look at when nobody was.
#pragma once

#include <optional>
#include <string>

#include "multicast_route.h"
#include "network/lcm_url.h"
#include "probe_round.h"

namespace wells {

struct ProbeSurroundings {
  LcmUrl url;
  std::optional<MulticastRoute> route;
  std::string host;    // this machine's name
  double seconds = 0;  // s that it listened
};

/// True when somebody else was heard and hears us.
bool passesBothWays(const ProbeRound& round);

/// Lines that each end with a newline.
std::string probeReport(const ProbeSurroundings& here, const ProbeRound& round);

}  // namespace wells
