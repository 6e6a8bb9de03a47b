// A gas of equal balls in a periodic cube, for tests: what the textbooks' formulas are about. When
// two balls meet and what an impact does to them is asked of the engine (contacts/impact_time.h,
// contacts/impacts.h); the box, its images and the order of events are here. Not a way to run a
// world: there is no ground, no wall and no step.
//
// Each ball has one event in the queue: its next impact, or that it leaves its cell. Impacts are
// looked for in the cell and the 26 around it, anew after each event of the ball (Lubachevsky, "How
// to simulate billiards and similar systems", J. Comput. Phys. 94 (1991) 255).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <queue>
#include <vector>

#include "contacts/path.h"

namespace wells {

class PeriodicGas {
 public:
  /// Balls of diameter 1 m and 1 kg on random sites of a close-packed lattice, `density` of them in
  /// a cubic metre (up to 1), all about as fast: no momentum, and kT = 1 J. Smooth and elastic.
  PeriodicGas(std::size_t balls, double density, std::uint64_t seed);
  PeriodicGas(const PeriodicGas&) = delete;
  PeriodicGas& operator=(const PeriodicGas&) = delete;

  /// The coefficient of restitution from now on.
  void setElasticity(double elasticity) { elasticity_ = elasticity; }

  /// Goes on until `hits` impacts have happened in all.
  void runToHits(std::int64_t hits);

  /// Goes on until `time` (s).
  void runToTime(double time);

  double time() const { return now_; }           // s
  std::int64_t hits() const { return hits_; }    // impacts; each is a hit of two balls
  double virial() const { return virial_; }      // J s, sum of (x_a - x_b) . (impulse on a)
  double side() const { return side_; }          // m, of the box
  Vec3 positionOf(std::uint32_t ball) const;     // now, in [0, side)^3
  const Balls& balls() const { return balls_; }  // each where its last impact was

  /// kT (J): two thirds of the kinetic energy over N - 1, the momentum being fixed.
  double temperature() const;

 private:
  using Triple = std::array<int, 3>;
  static constexpr std::uint32_t kNobody = 0xffffffff;

  struct Event {
    double time = 0;
    std::uint32_t ball = 0;
    std::uint32_t partner = kNobody;  // kNobody: leaves its cell
    std::uint64_t turn = 0;           // of `ball`, when this was foreseen: else it is void
    std::uint64_t path = 0;           // of `partner`, likewise
    Triple image = {};                // of `partner`: so many boxes away
    bool operator>(const Event& other) const { return time > other.time; }
  };

  struct Exit {
    double time = 0;
    int axis = 0;  // of the border that it crosses
  };

  void placeBalls(std::size_t balls, double density, std::uint64_t seed);
  void heatBalls(std::uint64_t seed);
  std::vector<std::uint32_t>& members(const Triple& cell);
  Triple imageIn(const Triple& cell, std::uint32_t ball) const;
  Vec3 shiftOf(const Triple& image) const;
  Path pathOf(std::uint32_t ball) const;
  Exit exitOf(std::uint32_t ball) const;
  void foresee(std::uint32_t ball);
  void cross(std::uint32_t ball);
  void hit(const Event& event);
  void happen(const Event& event);

  double elasticity_ = 1;
  double side_ = 0;      // m, of the box
  double cellSide_ = 0;  // m, >= a diameter
  int cellsPerSide_ = 0;
  Field field_;  // none
  Arena arena_;  // out of reach
  PathModel model_;

  double now_ = 0;
  std::int64_t hits_ = 0;
  double virial_ = 0;
  Balls balls_;
  std::vector<double> since_;         // s, when a ball was where balls_ has it
  std::vector<std::uint64_t> paths_;  // by ball: its impacts
  std::vector<std::uint64_t> turns_;  // by ball: its events
  std::vector<Triple> cells_;         // by ball; images of the box have cells of their own
  std::vector<std::vector<std::uint32_t>> members_;  // by cell of the box
  std::priority_queue<Event, std::vector<Event>, std::greater<>> queue_;
};

}  // namespace wells
