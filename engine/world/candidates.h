// The contacts that are possible within a step: the broadphase's pairs, narrowed by how far each
// ball may move, in an order that does not depend on the broadphase's history.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/broadphase.h"
#include "state/world.h"
#include "threads/thread_pool.h"

namespace wells {

/// Ghosts whose gap is at most this, of the sum of their radii, count as touching.
inline constexpr double kLeaningGap = 0.05;

class Candidates {
 public:
  /// What a ball may touch in the step lies within this.
  struct Sphere {
    Vec3 center;    // m
    double radius;  // m
  };

  /// Lists the pairs that may touch in a step. reach[i] (m) bounds how far ball i moves in it; NaN:
  /// the ball is in no pair. `among` are the balls that take part, rising ids, as Broadphase has
  /// it.
  void find(const World& world, std::span<const double> reach, std::span<const std::uint32_t> among,
            ThreadPool& threads);
  /// The same, by the caller's thread alone.
  void find(const World& world, std::span<const double> reach,
            std::span<const std::uint32_t> among) {
    ThreadPool alone;
    find(world, reach, among, alone);
  }

  /// These take no part from the next find() on, until they are among its balls again.
  void remove(std::span<const std::uint32_t> balls) { broadphase_.remove(balls); }

  /// When balls have moved since find(world, reach, among): those that went beyond their reach and
  /// met a ball, ground or wall that is not listed, if all moved straight on. Rising ids.
  std::span<const std::uint32_t> findSurprised(const World& world, std::span<const double> reach,
                                               std::span<const std::uint32_t> among,
                                               ThreadPool& threads);

  // Of the last find(), all by (a, b), each once.

  std::span<const BallPair> ballPairs() const {
    return areBroadphases_ ? broadphase_.ballPairs() : ballPairs_;
  }
  /// b is kGround or kWall.
  std::span<const BallPair> arenaPairs() const { return arenaPairs_; }
  /// Ghosts that touch ghosts or nearly do; see isLeaning().
  std::span<const BallPair> leaningPairs() const { return leaningPairs_; }

  /// By ball, 1 for ghosts that touch ghosts: a contact between other peers' balls is theirs to
  /// compute. Here such balls only stop falling, because what holds them is not known.
  std::span<const std::uint8_t> isLeaning() const { return isLeaning_; }

  /// By ball; about where it was then. Only those of its balls are valid.
  std::span<const Sphere> spheres() const { return spheres_; }

  /// Pairs of the broadphase; where there is none, because balls are few, all that were found.
  std::int64_t pairs() const;

 private:
  void findBalls(ThreadPool& threads);
  /// All at once, without the broadphase.
  void findAmongFew(const World& world, std::span<const double> reach,
                    std::span<const std::uint32_t> among);
  void findBallsAndLeaning(const World& world);
  void findArena(const World& world, std::span<const double> reach,
                 std::span<const std::uint32_t> among, ThreadPool& threads);
  void findBeyond(const World& world, std::span<const double> reach,
                  std::span<const std::uint32_t> among, ThreadPool& threads);
  /// Of one that went beyond its reach; nobody did so by more than `excess` (m).
  bool isSurprised(const World& world, std::span<const std::uint32_t> among, std::uint32_t ball,
                   double reach, double excess);
  /// m, of a ball since find().
  Vec3 wayOf(const World& world, std::uint32_t ball) const {
    return world.balls.position[ball] - spheres_[ball].center;
  }

  Broadphase broadphase_;
  bool areFew_ = false;
  bool areBroadphases_ = false;  // the pairs of balls: all of its pairs are near
  std::vector<BallPair> ballPairs_;
  std::vector<BallPair> arenaPairs_;
  std::vector<BallPair> leaningPairs_;
  // By ball; only those of the last find() are valid.
  std::vector<std::uint8_t> isLeaning_;
  std::vector<std::uint8_t> nearArena_;  // bits
  std::vector<Sphere> spheres_;
  // Of the last findSurprised().
  std::vector<std::vector<std::uint32_t>> beyond_;  // by range of balls
  std::vector<std::uint32_t> surprised_;
  std::vector<std::uint32_t> around_;  // scratch
};

}  // namespace wells
