// What a session tells of itself, for people: nobody's behaviour depends on it.
#include <algorithm>
#include <cmath>

#include "network/session.h"

namespace wells {
namespace {

std::int32_t milliseconds(double seconds) {
  constexpr double kMost = 2e9;
  return static_cast<std::int32_t>(std::clamp(std::round(seconds * 1000), -kMost, kMost));
}

}  // namespace

void Session::sendStatistics(const World& world, Times now) {
  const TransportCounts transport = transport_.counts();
  const BallCounts& balls = balls_.counts();
  gravity_wells::statistics_t m{};
  m.header = header(world, now);
  m.sim_time = world.time();
  m.simulation_rate = measures_.simulationRate;
  m.simulation_target = measures_.simulationTarget;
  m.network_rate = measures_.networkRate;
  m.network_target = measures_.networkTarget;
  m.graphics_rate = measures_.graphicsRate;
  m.graphics_target = measures_.graphicsTarget;
  m.kinetic_energy = measures_.kineticEnergy;
  m.potential_energy = measures_.potentialEnergy;
  m.max_overlap = measures_.maxOverlap;
  m.balls_owned = static_cast<std::int32_t>(ballsOwnedHere());
  m.balls_ghost = static_cast<std::int32_t>(balls_.ghosts());
  m.peers_heard = static_cast<std::int32_t>(peers_.living(now.monotonic).size());
  m.handovers_given = balls.handoversGiven;
  m.handovers_taken = balls.handoversTaken;
  m.adoptions = balls.adoptions;
  m.view_difference_max = viewDifference();
  m.doubled_ball_seconds = balls.doubledBallSeconds;
  m.fences = counts_.fences;
  m.resyncs = counts_.resyncs;
  m.messages_sent = transport.messagesSent;
  m.messages_received = counts_.accepted;
  m.bytes_sent = transport.bytesSent;
  m.bytes_received = transport.bytesReceived;
  addTrafficRates(m, now);
  addDrops(m, transport);
  addPeerViews(m, world, now);
  send(m);
}

void Session::addTrafficRates(gravity_wells::statistics_t& m, Times now) {
  const Traffic sofar{now.monotonic, m.messages_sent, m.messages_received, m.bytes_sent,
                      m.bytes_received};
  if (const double seconds = sofar.time - traffic_.time; traffic_.time > 0 && seconds > 0) {
    const auto rate = [&](std::int64_t Traffic::*count) {
      return static_cast<double>(sofar.*count - traffic_.*count) / seconds;
    };
    m.messages_sent_rate = rate(&Traffic::messagesSent);
    m.messages_received_rate = rate(&Traffic::messagesReceived);
    m.bytes_sent_rate = rate(&Traffic::bytesSent);
    m.bytes_received_rate = rate(&Traffic::bytesReceived);
  }
  traffic_ = sofar;
}

void Session::addDrops(gravity_wells::statistics_t& m, const TransportCounts& transport) const {
  m.dropped_by_kernel = transport.droppedByKernel;
  m.dropped_in_queue = transport.droppedSending + transport.droppedReceiving;
  m.dropped_by_checks = counts_.drops.total();
  m.messages_dropped = m.dropped_by_kernel + m.dropped_in_queue + m.dropped_by_checks;
  for (const auto& [reason, count] : counts_.drops.faults())
    m.drops.push_back({std::string(name(reason)), count});
  std::ranges::stable_sort(m.drops, std::ranges::greater{}, &gravity_wells::drop_count_t::count);
  m.drops.resize(std::min<std::size_t>(m.drops.size(), kMaxDropReasonsInMessage));
  m.reasons = static_cast<std::int32_t>(m.drops.size());
}

void Session::addPeerViews(gravity_wells::statistics_t& m, const World& world, Times now) const {
  for (const Peer* other : peers_.members()) {
    if (m.views.size() == kMaxViewsInMessage) break;
    const double left =
        std::max(0.0, peers_.leases().runsOutAt(other->who, now.monotonic) - now.monotonic);
    m.views.push_back({.peer_id = value(other->who.peer),
                       .phase = static_cast<std::int32_t>(other->phase),
                       .lease_left_ms = milliseconds(left),
                       .clock_offset_ms = milliseconds(other->clockOffset),
                       .steps_behind = world.step - other->step});
  }
  m.peers = static_cast<std::int32_t>(m.views.size());
}

}  // namespace wells
