// The part of a step that needs no broadphase: flight, substeps and contacts of balls whose
// possible contacts are known. Shared by the simulation and by the prediction of single balls, so
// that both compute the same bits.
#pragma once

#include <cstdint>
#include <vector>

#include "contacts/path.h"
#include "contacts/sequential_impulses.h"
#include "state/books.h"
#include "state/world.h"
#include "threads/thread_pool.h"

namespace wells {

/// The possible contacts of one step and the balls they leave alone.
struct StepPlan {
  std::vector<Contact> ballContacts;    // by (a, b)
  std::vector<Contact> arenaContacts;   // by (a, b)
  std::vector<std::uint32_t> free;      // balls that can touch nothing in this step
  std::vector<std::uint32_t> touching;  // the others
  std::vector<std::uint32_t> drifting;  // ghosts that move on at their velocity, whatever pulls
  std::vector<Vec3> velocityBefore;     // by ball, scratch
  ContactWorkspace workspace;
};

/// Of the radius, for what an impact within the step changes. At 0.1 two pairs in 400 steps of
/// ten-thousand.txt came late.
inline constexpr double kReachMargin = 0.25;

/// m/s, by how much the field changes the velocity of a ball at that place within a step.
double pullOf(const Field& field, const Vec3& position, double dt);

/// How far a ball may move during a step (m): by its speed, by twice what its present acceleration
/// could add, and by kReachMargin. Two balls
/// may touch when their gap is at most the sum of their reaches.
double reachOf(const Field& field, const BallState& ball, double radius, double dt);

/// For a ball that stood at `start` (m), has `now`, and went further than `reach`: enlarges that
/// (m) to at least twice its size.
void enlargeReach(const Vec3& start, const BallState& now, double dt, double& reach);

/// True when a ball may touch the partner (kGround or kWall) of the arena in this step.
bool mayTouchArena(const Arena& arena, const Vec3& position, double radius, double reach,
                   std::uint32_t partner);

/// True when a ball that stood at `start` (m) and now is at `now` met a part of the arena that it
/// could not touch by its reach: straight ways are nowhere nearer to one than at their ends.
bool hasMissedArena(const Arena& arena, const Vec3& start, const Vec3& now, double radius,
                    double reach);

/// Advances all balls of the plan by settings.dt: the free ones in one flight, the others in
/// substeps. Books it unless `books` is null. Returns the sums over the substeps.
ResolvedCounts advance(const Settings& settings, const PathModel& model, StepPlan& plan,
                       Balls& balls, ThreadPool& pool, Books* books = nullptr);

}  // namespace wells
