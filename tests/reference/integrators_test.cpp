// One step of each integrator against arithmetic by hand, and the flaws of the published ones
// against closed forms.
#include "reference/integrators.h"

#include <gtest/gtest.h>

#include <cmath>

namespace wells {
namespace {

void expectNear(const Vec3& actual, const Vec3& expected, double tolerance) {
  EXPECT_NEAR(actual.x(), expected.x(), tolerance);
  EXPECT_NEAR(actual.y(), expected.y(), tolerance);
  EXPECT_NEAR(actual.z(), expected.z(), tolerance);
}

// A well 3 m away along x with softening 4 m: (3^2 + 4^2)^(3/2) = 125, so that S = 250 pulls with
// exactly 6 m/s^2. h = 1/2 and d = 1/4 give d^h = 1/2.
ReferenceStep stepByHand() {
  ReferenceStep step;
  step.gravity = {0, -10, 0};
  step.wells.wells = {{.position = {4, 20, 3}, .strength = 250, .softening = 4}};
  step.h = 0.5;
  step.damping = 0.25;
  step.dampingOfStep = 0.5;
  return step;
}

ReferenceBall ballByHand() {
  return {.position = {1, 20, 3},
          .velocity = {2, -1, 4},
          .lastVelocity = {4, 1, 0},
          .mass = 2,
          .inverseMass = 0.5};
}

TEST(ReferenceIntegrators, EulerByHand) {
  ReferenceBall ball = ballByHand();
  advanceEuler(stepByHand(), ball);
  expectNear(ball.position, {1 + 1, 20 - 0.5 - 1.25, 3 + 2}, 1e-14);
  expectNear(ball.velocity, {(2 + 3) * 0.5, (-1 - 5) * 0.5, 4 * 0.5}, 1e-14);
  EXPECT_EQ(ball.force, Vec3::Zero());
}

TEST(ReferenceIntegrators, ImprovedEulerByHand) {
  ReferenceBall ball = ballByHand();
  advanceImprovedEuler(stepByHand(), ball);
  expectNear(ball.position, {1 + 1.5, 20 - 1.25, 3 + 1}, 1e-14);
  expectNear(ball.velocity, {2.5, -3, 2}, 1e-14);
  EXPECT_EQ(ball.lastVelocity, Vec3(2, -1, 4)) << "v before the step";
  EXPECT_EQ(ball.force, Vec3::Zero());
}

// With constant acceleration A: k1.v = v, k2.v = v + A h/2, k3.v = v + A h, k4.v = v + 2 A h (the
// stages move v itself), so the stages move p by (v h/2) + (v h/2 + A h^2/4) ... = v 2h + (1/4 + 1)
// A h^2 and v by 2 A h; the weighted sum adds v h + 5/6 A h^2 and A h.
//   p += 3 v h + 25/12 A h^2,  v = (v + 3 A h) d
TEST(ReferenceIntegrators, PublishedRungeKuttaByHand) {
  ReferenceBall ball = ballByHand();
  advanceRungeKutta(stepByHand(), ball);  // A = (6, -10, 0)
  expectNear(ball.position, {1 + 3 + 3.125, 20 - 1.5 - 250.0 / 48, 3 + 6}, 1e-13);
  expectNear(ball.velocity, {(2 + 9) * 0.25, (-1 - 15) * 0.25, 4 * 0.25}, 1e-14);
  EXPECT_EQ(ball.force, Vec3::Zero());
}

// A very wide well is a spring of omega^2 = S / softening^3 (to 1.5 (p / softening)^2 = 2e-8), on
// which an explicit method of order q gives the Taylor polynomial of cosine and sine of theta =
// omega h up to degree q.
ReferenceStep springStep(double omega, double h) {
  const double softening = 1e4;
  ReferenceStep step;
  step.wells.wells = {
      {.strength = omega * omega * softening * softening * softening, .softening = softening}};
  step.h = h;
  return step;
}

TEST(ReferenceIntegrators, HeunByHandOnASpring) {
  const double omega = 2;
  const double h = 0.25;
  const double theta = omega * h;
  ReferenceBall ball{.position = {1, 0, 0}, .velocity = {0.5, 0, 0}};
  advanceHeun(springStep(omega, h), ball);
  const double c = 1 - theta * theta / 2;
  EXPECT_NEAR(ball.position.x(), c * 1 + theta / omega * 0.5, 1e-7);
  EXPECT_NEAR(ball.velocity.x(), c * 0.5 - theta * omega * 1, 1e-7);
}

TEST(ReferenceIntegrators, Rk4ByHandOnASpring) {
  const double omega = 2;
  const double h = 0.25;
  const double theta = omega * h;
  ReferenceBall ball{.position = {1, 0, 0}, .velocity = {0.5, 0, 0}};
  advanceRk4(springStep(omega, h), ball);
  const double c = 1 - theta * theta / 2 + theta * theta * theta * theta / 24;
  const double s = theta - theta * theta * theta / 6;
  EXPECT_NEAR(ball.position.x(), c * 1 + s / omega * 0.5, 1e-7);
  EXPECT_NEAR(ball.velocity.x(), c * 0.5 - s * omega * 1, 1e-7);
}

TEST(ReferenceIntegrators, TextbookMethodsMoveWellsWithinTheStep) {
  // A well that flies past while the ball holds still for lack of time: only its later place counts
  // at the end of the step.
  ReferenceStep step;
  step.wells.wells = {
      {.position = {3, 0, 0}, .velocity = {-6, 0, 0}, .strength = 250, .softening = 4}};
  step.h = 1;  // from +6 m/s^2 through 0 to -6 m/s^2
  ReferenceBall heun{.mass = 1e-3, .inverseMass = 1e3};
  advanceHeun(step, heun);
  EXPECT_NEAR(heun.velocity.x(), 0, 1e-14);
  ReferenceBall euler;
  advanceEuler(step, euler);
  EXPECT_NEAR(euler.velocity.x(), 6, 1e-14) << "as published: the start of the step";
}

TEST(ReferenceFlaws, EulerForceDoesNotMoveTheBallInItsStep) {
  ReferenceStep step = stepByHand();
  step.gravity.setZero();
  ReferenceBall ball{.position = {1, 20, 3}};
  advanceEuler(step, ball);
  EXPECT_EQ(ball.position, Vec3(1, 20, 3));
  EXPECT_NEAR(ball.velocity.x(), 6 * 0.5 * 0.5, 1e-14);
}

// Free fall from rest, v_k = -g h k exactly. Step 0 moves -g h^2/2; step k > 0 moves
// (v_k + v_(k-1)) h/2 - g h^2/2 = -g h^2 k. After n steps y = -g h^2/2 (n^2 - n + 1), where the
// exact -g h^2/2 n^2 is what Heun's method gives: behind by g h (t - h)/2, first order in h.
TEST(ReferenceFlaws, ImprovedEulerIsNotHeun) {
  for (const int n : {1, 2, 60, 240}) {
    const double h = 1.0 / n;
    ReferenceStep step;
    step.gravity = {0, -9.81, 0};
    step.h = h;
    ReferenceBall improved;
    ReferenceBall heun;
    for (int i = 0; i < n; ++i) {
      advanceImprovedEuler(step, improved);
      advanceHeun(step, heun);
    }
    EXPECT_NEAR(improved.position.y(), -9.81 * h * h / 2 * (n * n - n + 1), 1e-12);
    EXPECT_NEAR(heun.position.y(), -9.81 / 2, 1e-12);
  }
}

TEST(ReferenceFlaws, RungeKuttaMovesThreeStepsInOneAndDoesNotConverge) {
  for (const int n : {10, 100, 1000}) {
    ReferenceStep step;
    step.h = 1.0 / n;
    ReferenceBall ball{.velocity = {2, 0, 0}};
    for (int i = 0; i < n; ++i) advanceRungeKutta(step, ball);
    EXPECT_NEAR(ball.position.x(), 3 * 2 * 1.0, 1e-12) << "2 m/s for 1 s in " << n << " steps";
  }
}

TEST(ReferenceFlaws, RungeKuttaDampsPerStepWhateverTheStep) {
  for (const int n : {5, 10}) {
    ReferenceStep step;
    step.h = 1.0 / n;
    step.damping = 0.9;
    step.dampingOfStep = std::pow(0.9, step.h);
    ReferenceBall published{.velocity = {2, 0, 0}};
    ReferenceBall textbook{.velocity = {2, 0, 0}};
    for (int i = 0; i < n; ++i) {
      advanceRungeKutta(step, published);
      advanceRk4(step, textbook);
    }
    EXPECT_NEAR(published.velocity.x(), 2 * std::pow(0.9, n), 1e-14);
    EXPECT_NEAR(textbook.velocity.x(), 2 * 0.9, 1e-14) << "0.9 a second";
  }
}

}  // namespace
}  // namespace wells
