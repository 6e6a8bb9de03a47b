#include "run_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

namespace wells {
namespace {

using Json = nlohmann::ordered_json;

Json rateAsJson(const LoopRate& rate) {
  return {{"target_Hz", rate.target}, {"actual_Hz", rate.actual}};
}

Json ownersAsJson(const RunReport& r) {
  Json owners = Json::object();
  for (const auto& [peer, balls] : r.owners) owners[std::to_string(peer)] = balls;
  return owners;
}

Json dropsAsJson(const RunReport& r) {
  Json drops = Json::object();
  for (const auto& [reason, count] : r.dropsByReason) drops[reason] = count;
  return drops;
}

}  // namespace

std::string reportAsJson(const RunReport& r) {
  const Json json = {
      {"format", 1},
      {"engine", r.engine},
      {"integrator", r.integrator},
      {"contacts", r.contacts},
      {"dt", r.dt},
      {"threads", r.threads},
      {"steps", r.steps},
      {"sim_time_s", r.simulatedTime},
      {"wall_time_s", r.wallTime},
      {"energy_start_J", r.energyStart},
      {"energy_end_J", r.energyEnd},
      {"max_overlap_m", r.maxOverlap},
      {"escaped", r.escaped},
      {"state_hash", r.stateHash},
      {"late_pairs", r.latePairs},
      {"transport", r.transport},
      {"peer", r.peer},
      {"peers", r.peers},
      {"generation", r.generation},
      {"owners", ownersAsJson(r)},
      {"balls_owned", r.ballsOwned},
      {"balls_owned_max", r.ballsOwnedMax},
      {"handovers", r.handoversGiven},
      {"handovers_taken", r.handoversTaken},
      {"adoptions", r.adoptions},
      {"view_difference_max_m", r.viewDifference},
      {"settled", r.settled},
      {"messages_sent", r.messagesSent},
      {"messages_received", r.messagesReceived},
      {"messages_dropped", r.messagesDropped},
      {"messages_dropped_by_reason", dropsAsJson(r)},
      {"bytes_sent", r.bytesSent},
      {"bytes_received", r.bytesReceived},
      {"rates",
       {{"simulation", rateAsJson(r.simulation)},
        {"network", rateAsJson(r.network)},
        {"graphics", rateAsJson(r.graphics)}}},
      {"frames_drawn", r.framesDrawn},
      {"frames_repeated", r.framesRepeated},
  };
  return json.dump(2) + "\n";
}

std::string reportAsText(const RunReport& r) {
  std::string text = fmt::format(
      "step {}, {:.2f} s of simulated time, in {:.2f} s ({}, {}, {})\n"
      "energy {:.6g} J, then {:.6g} J; worst overlap {:.3g} m; {} of {} balls escaped; state {}\n",
      r.steps, r.simulatedTime, r.wallTime, r.engine, r.integrator, r.contacts, r.energyStart,
      r.energyEnd, r.maxOverlap, r.escaped, r.balls.size(), r.stateHash);
  if (r.peers.empty() || r.transport == "none") return text;
  return text +
         fmt::format(
             "peer {} owns {} balls; it handed over {}, took over {}, adopted {}; living peers: "
             "{}\n"
             "messages: {} sent, {} received, {} dropped; largest prediction error {:.3g} m\n",
             r.peer, r.ballsOwned, r.handoversGiven, r.handoversTaken, r.adoptions,
             fmt::join(r.peers, ", "), r.messagesSent, r.messagesReceived, r.messagesDropped,
             r.viewDifference);
}

}  // namespace wells
