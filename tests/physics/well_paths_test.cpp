// Paths about softened wells, free and with impacts on the ground: distance and order.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "scenes/catalogue.h"
#include "scenes/exact_answers.h"
#include "support/order.h"
#include "support/run_world.h"
#include "world/measures.h"

namespace wells {
namespace {

using Errors = std::vector<std::pair<double, double>>;  // (s, m)

/// Errors of our engine over step rates n, 2 n, ... (Hz), six of them. Near a sharp well a step's
/// flight is divided into stretches; then the order is that in the stretch.
Errors errorsOf(const std::string& integrator, const char* scene, int rate, std::int64_t impacts) {
  Errors errors;
  for (int n = rate; n < rate * 64; n *= 2) {
    World world = makeScene(findScene(scene));
    world.settings.integrator = integrator;
    world.settings.dt = 1.0 / n;
    const RunCounts counts = runFor(world, findAccuracyCase(scene).duration);
    EXPECT_EQ(counts.impacts, impacts) << integrator;
    errors.emplace_back(1.0 / (n * static_cast<double>(counts.flightStretches)),
                        positionError(findAccuracyCase(scene), world));
  }
  return errors;
}

// Six revolutions at the default step: the bound that the fourth order is to reach.
TEST(Orbit, IsFollowedForSixRevolutions) {
  World world = makeScene(findScene("orbit"));
  const double energy = measure(world).energy();
  runFor(world, 20);
  EXPECT_LE(positionError(findAccuracyCase("orbit"), world), 1e-5);
  // Symplectic: the energy error is that of one step, (omega dt)^4 of the well's work, and does not
  // grow; omega^2 = S / s^3 at r_min = 3.04 gives (4.6 / 60)^4 = 3e-5 and a small factor.
  EXPECT_NEAR(measure(world).energy() / energy, 1, 1e-6);
}

TEST(Orbit, HasFourthOrderOverSixRevolutions) {
  EXPECT_GE(fittedOrder(errorsOf("pefrl", "orbit", 30, 0)), 3.8);
}

// Force and radius constant: the period is 6.470753752069365 s. A symplectic method of order 4 errs
// in the angular speed omega, by below 0.1 (omega dt)^4 = 7e-9 of it: with omega = 0.97 / s, after
// 20 s at 10 m below 1.4e-6 m. The radius only wavers.
TEST(CircularOrbit, StaysACircle) {
  World world = makeScene(findScene("circular-orbit"));
  runFor(world, 20);
  EXPECT_LE(positionError(findAccuracyCase("circular-orbit"), world), 1.4e-6);
  const Vec3 d = world.balls.position[0] - Vec3(0, 20, 0);
  EXPECT_NEAR(length(d), 10, 7e-8);
  EXPECT_NEAR(length(world.balls.velocity[0]), 9.7101289091247, 7e-8);
  EXPECT_GE(fittedOrder(errorsOf("pefrl", "circular-orbit", 30, 0)), 3.8);
}

// Period 0.561993081369989: an almost harmonic swing of amplitude A = 0.01 m with omega dt = 0.186.
// Phase error of the fourth-order method, 1e-3 (omega dt)^4 omega T A with T = 10 s.
TEST(ThroughTheCentre, KeepsItsPeriod) {
  World world = makeScene(findScene("through-the-centre"));
  runFor(world, 10);
  EXPECT_LE(positionError(findAccuracyCase("through-the-centre"), world), 1.5e-6);
  EXPECT_GE(fittedOrder(errorsOf("pefrl", "through-the-centre", 60, 0)), 3.8);
}

// T = 2, so short that the error is in the range of its leading term. (Explicit Euler is an
// integrator of the custom engine: tests/reference/order_test.cpp.)
TEST(OrbitOrder, IsThatOfEachIntegrator) {
  for (const auto& [integrator, order, rate] : {std::tuple{"symplectic-euler", 1, 128},
                                                {"leapfrog", 2, 128},
                                                {"heun", 2, 128},
                                                {"rk4", 4, 32},
                                                {"pefrl", 4, 32}})
    EXPECT_NEAR(fittedOrder(errorsOf(integrator, "orbit-short", rate, 0)), order, 0.1)
        << integrator;
}

// The order survives four impacts, and eleven.
TEST(OrderThroughImpacts, Survives) {
  for (const auto& [scene, impacts] : {std::pair{"well-bounces", 4}, {"well-bounces-long", 11}})
    for (const auto& [integrator, bound, rate] : {std::tuple{"leapfrog", 1.9, 60},
                                                  {"heun", 1.9, 240},
                                                  {"rk4", 3.8, 30},
                                                  {"pefrl", 3.8, 30}}) {
      const Errors errors = errorsOf(integrator, scene, rate, impacts);
      EXPECT_GE(fittedOrder(errors), bound) << integrator << " " << scene;
      EXPECT_LT(errors.back().second, errors.front().second) << integrator << " " << scene;
    }
}

}  // namespace
}  // namespace wells
