// What a step needs to know besides the state: physics and method. Part of the world, the same for
// all peers of a session.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "math/vector.h"

namespace wells {

/// The choice whose name stands at its place in `names`; nothing where there is no such name.
template <class Choice>
constexpr std::optional<Choice> choiceNamed(std::span<const std::string_view> names,
                                            std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Choice>(found - names.begin());
}

/// How contacts are resolved.
enum class ContactMethod {
  Substep,  // all by sequential impulses at the end of substeps; first order through impacts
  Exact,    // impacts at their own times within the step, one ball's rolling and sliding in reduced
            // coordinates, in the integrator's order; islands in which several contacts last are
            // left to the substeps
  Auto      // Exact, but many balls whose contacts last stay in substeps for a while
};

inline constexpr std::array<std::string_view, 3> kContactMethodNames = {"substep", "exact", "auto"};

constexpr std::string_view name(ContactMethod method) {
  return kContactMethodNames.at(static_cast<std::size_t>(method));
}

/// Nothing where there is no such method.
constexpr std::optional<ContactMethod> contactMethod(std::string_view name) {
  return choiceNamed<ContactMethod>(kContactMethodNames, name);
}

/// How candidate pairs are found. The results are the same, to the bit.
enum class BroadphaseKind {
  Auto,  // a grid where the radii are about the same, else a tree
  Tree,  // Bullet's btDbvtBroadphase
  Grid   // cells as large as a ball and its way, by SpherePairs
};

inline constexpr std::array<std::string_view, 3> kBroadphaseNames = {"auto", "tree", "grid"};

constexpr std::string_view name(BroadphaseKind kind) {
  return kBroadphaseNames.at(static_cast<std::size_t>(kind));
}

/// Nothing where there is no such kind.
constexpr std::optional<BroadphaseKind> broadphaseKind(std::string_view name) {
  return choiceNamed<BroadphaseKind>(kBroadphaseNames, name);
}

struct Settings {
  // Physics.
  double dt = 1.0 / 60;              // s, > 0; one step
  Vec3 gravity = Vec3{0, -9.81, 0};  // m/s^2; zero for none
  double drag = 1;                   // velocity factor per second, in (0, 1]; 1: none
  double elasticity = 0.8;           // coefficient of restitution, 0 .. 1
  double friction = 0.3;             // Coulomb's coefficient, >= 0
  double rollingResistance = 0;      // m, >= 0; at a contact pressed by the force N, a torque of up
                                     // to this times N opposes the rolling

  // Method.
  std::string integrator = "pefrl";  // a name of flight/integrators.h
  ContactMethod contactMethod = ContactMethod::Auto;
  int substeps = 4;                      // of a ball that may touch something, >= 1
  int iterations = 4;                    // solver passes a substep, >= 1
  std::int64_t mostImpacts = 1'000'000;  // elastic ones of an island in a step, >= 1; more stop
                                         // the step (Exact) or are left to the substeps (Auto)
  double sleepSpeed = 1e-5;  // m/s, >= 0; lasting contacts slower than this rest, and islands at
                             // rest sleep (world/sleep.h); 0: none ever does
  BroadphaseKind broadphase = BroadphaseKind::Auto;
};

}  // namespace wells
