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

Json coresAsJson(const ThreadPlaces& p) {
  return {{"simulation", ThreadPlaces::text(p.simulation)},
          {"graphics", ThreadPlaces::text(p.graphics)},
          {"network", ThreadPlaces::text(p.network)},
          {"why", p.why}};
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

Json vectorAsJson(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

Json impulseAsJson(const ImpulseBook& book) {
  return {{"linear_N_s", vectorAsJson(book.linear)},
          {"angular_kg_m2_per_s", vectorAsJson(book.angular)}};
}

Json booksAsJson(const Books& b) {
  return {{"contacts_J", b.contacts},
          {"friction_J", b.friction},
          {"drag_J", b.drag},
          {"wells_J", b.wells},
          {"push_out_J", b.pushOut},
          {"flight_J", b.flight},
          {"sleep_J", b.sleep},
          {"outside_J", b.outside},
          {"ground", impulseAsJson(b.ground)},
          {"wall", impulseAsJson(b.wall)},
          {"fields", impulseAsJson(b.fields)},
          {"shifts", impulseAsJson(b.shifts)},
          {"rest", impulseAsJson(b.rest)},
          {"changes", impulseAsJson(b.changes)}};
}

Json sharesAsJson(const ContactShares& s) {
  return {{"exact", s.exact()},
          {"substep", s.substep()},
          {"asleep", s.asleep()},
          {"impacts", s.impacts},
          {"clusters", s.clusters},
          {"islands_handed_over", s.handedOver},
          {"direct_contacts", s.directContacts},
          {"unsolved_islands", s.unsolvedIslands}};
}

std::string sharesAsText(const ContactShares& s) {
  std::string text = fmt::format(
      "contacts: {:.1f} % of the balls' steps by exact impacts ({} of them), {:.1f} % by substeps; "
      "{} islands handed over\n",
      100 * s.exact(), s.impacts, 100 * s.substep(), s.handedOver);
  if (s.directContacts + s.unsolvedIslands > 0)
    text += fmt::format(
        "in substeps: contacts solved directly {} times; {} small islands left to the passes\n",
        s.directContacts, s.unsolvedIslands);
  return text;
}

std::string placesAsText(const RunReport& r) {
  const ThreadPlaces& p = r.places;
  return fmt::format(
      "threads of the simulation: {}; cores: simulation {}, graphics {}, network {} ({})\n",
      r.threads, ThreadPlaces::text(p.simulation), ThreadPlaces::text(p.graphics),
      ThreadPlaces::text(p.network), p.why);
}

std::string booksAsText(const Books& b) {
  return fmt::format(
      "energy booked: contacts {:.6g} J, friction {:.6g} J, drag {:.6g} J, wells {:.6g} J, "
      "push-out "
      "{:.6g} J, flight {:.3g} J, from outside {:.6g} J\n",
      b.contacts, b.friction, b.drag, b.wells, b.pushOut, b.flight, b.outside);
}

/// What a person should not miss, each on its line.
std::string remarks(const RunReport& r) {
  std::string text;
  if (r.shares.asleepBalls > 0)
    text += fmt::format("asleep for {:.1f} % of the balls' steps\n", 100 * r.shares.asleep());
  if (r.flightStretches > 1)
    text += fmt::format("flight was divided into {} stretches a step: the wells are sharp\n",
                        r.flightStretches);
  if (!r.quarantined.empty())
    text += fmt::format(
        "{} ball(s) with a state that is not finite stand still and touch nothing: {}\n",
        r.quarantined.size(), fmt::join(r.quarantined, ", "));
  return text;
}

}  // namespace

std::string reportAsJson(const RunReport& r) {
  Json json = {
      {"format", 1},
      {"engine", r.engine},
      {"integrator", r.integrator},
      {"contacts", r.contacts},
      {"dt", r.dt},
      {"threads", r.threads},
      {"instructions", r.instructions},
      {"cores", coresAsJson(r.places)},
      {"steps", r.steps},
      {"sim_time_s", r.simulatedTime},
      {"wall_time_s", r.wallTime},
      {"energy_start_J", r.energyStart},
      {"energy_end_J", r.energyEnd},
      {"max_overlap_m", r.maxOverlap},
      {"escaped", r.escaped},
      {"state_hash", r.stateHash},
      {"late_pairs", r.latePairs},
      {"contact_shares", sharesAsJson(r.shares)},
      {"flight_stretches", r.flightStretches},
      {"quarantined", r.quarantined},
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
      {"doubled_ball_seconds", r.doubledBallSeconds},
      {"fences", r.fences},
      {"resyncs", r.resyncs},
      {"view_difference_max_m", r.viewDifference},
      {"complete", r.complete},
      {"messages_sent", r.messagesSent},
      {"messages_received", r.messagesReceived},
      {"messages_dropped", r.messagesDropped},
      {"messages_dropped_by_place",
       {{"kernel", r.droppedByKernel},
        {"queues", r.droppedInQueue},
        {"checks", r.droppedByChecks}}},
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
  if (r.trial)
    json["target_error"] = {{"asked_m", r.trial->targetError},
                            {"trial_error_m", r.trial->error},
                            {"trial_s", r.trial->duration},
                            {"substeps", r.trial->substeps}};
  if (r.books) json["books"] = booksAsJson(*r.books);
  return json.dump(2) + "\n";
}

std::string reportAsText(const RunReport& r) {
  std::string text = fmt::format(
      "step {}, {:.2f} s of simulated time, in {:.2f} s ({}, {}, {})\n"
      "energy {:.6g} J, then {:.6g} J; worst overlap {:.3g} m; {} of {} balls escaped; state {}\n",
      r.steps, r.simulatedTime, r.wallTime, r.engine, r.integrator, r.contacts, r.energyStart,
      r.energyEnd, r.maxOverlap, r.escaped, r.balls.size(), r.stateHash);
  if (r.shares.exactBalls + r.shares.substepBalls > 0) text += sharesAsText(r.shares);
  if (r.books) text += booksAsText(*r.books);
  text += placesAsText(r);
  text += remarks(r);
  if (r.fences > 0)
    text += fmt::format("stood still for too long and started over: {} time(s)\n", r.fences);
  if (r.doubledBallSeconds > 0)
    text += fmt::format("{:.1f} ball-seconds were simulated twice, and those here were dropped\n",
                        r.doubledBallSeconds);
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
