#include "flight/integrators.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/order.h"

namespace wells {
namespace {

struct Point {
  Vec3 x;
  Vec3 v;
};

FlightArrays arraysOf(Point& p) {
  return {&p.x.x(), &p.x.y(), &p.x.z(), &p.v.x(), &p.v.y(), &p.v.z(), 1};
}

Point fly(const Integrator& integrator, Field field, Point p, double dt, int steps,
          double drag = 1) {
  for (int i = 0; i < steps; ++i) {
    integrator.fly({&field, 0, dt, drag}, arraysOf(p));
    for (std::size_t n = 0; n < field.wells.size(); ++n) {
      Well well = field.wells[n];
      well.position += well.velocity * dt;
      field.wells.set(n, well);
    }
  }
  return p;
}

class EachIntegrator : public testing::TestWithParam<std::string> {
 protected:
  const Integrator& method() const { return findIntegrator(GetParam()); }
};

// Softened orbit: well at the origin, S = 1000, eps = 2, from (10, 0, 0) with 6 m/s along z. The
// point at t = 2 was computed with 30 digits by a Taylor-series integrator, independent of this
// code. Step sizes where the error is asymptotic: 1/32 .. 1/1024 for order 4, finer for order 1
// and 2.
TEST_P(EachIntegrator, HasItsOrderOnTheSoftenedOrbit) {
  const Field field{.wells = {{.strength = 1000, .softening = 2}}};
  const Vec3 exact{-2.653257440958655, 0, -5.234073690852200};
  std::vector<std::pair<double, double>> errors;
  const int coarsest = method().order >= 4 ? 32 : 128;
  for (int n = coarsest; n <= 32 * coarsest; n *= 2) {
    const Point end = fly(method(), field, {{10, 0, 0}, {0, 0, 6}}, 1.0 / n, 2 * n);
    errors.emplace_back(1.0 / n, length(end.x - exact));
  }
  EXPECT_NEAR(fittedOrder(errors), method().order, 0.1);
}

// A well that moves uniformly is a well at rest seen from a moving frame (Galilei).
TEST_P(EachIntegrator, FollowsAMovingWellAsWellAsOneAtRest) {
  const Vec3 u{1, 0.5, -2};
  const Field rest{.wells = {{.position = {0, 3, 0}, .strength = 50, .softening = 2}}};
  const Field moving{
      .wells = {{.position = {0, 3, 0}, .velocity = u, .strength = 50, .softening = 2}}};
  const int steps = 600;
  const double dt = 1.0 / 100;
  const Point a = fly(method(), rest, {{4, 3, 0}, {0, 0, 2}}, dt, steps);
  const Point b = fly(method(), moving, {{4, 3, 0}, Vec3(0, 0, 2) + u}, dt, steps);
  // Equal but for rounding, which the orbit magnifies.
  EXPECT_LE(length(b.x - u * (steps * dt) - a.x), 1e-9);
  EXPECT_LE(length(b.v - u - a.v), 1e-9);
}

// v' = v ln d: v = v0 d^t, x = v0 (d^t - 1) / ln d.
TEST_P(EachIntegrator, DragHasItsOrder) {
  const double d = 0.4;
  const double exact = 3 * (d - 1) / std::log(d);
  std::vector<std::pair<double, double>> errors;
  for (int n = 8; n <= 64; n *= 2) {
    const Point end = fly(method(), {}, {{0, 0, 0}, {3, 0, 0}}, 1.0 / n, n, d);
    // Drag is exact in velocity where it is split off, and a force where it is not.
    const bool isSplit = method().name != "heun" && method().name != "rk4";
    EXPECT_NEAR(end.v.x(), 3 * d, isSplit ? 1e-14 : 1e-2);
    errors.emplace_back(1.0 / n, std::abs(end.x.x() - exact));
  }
  EXPECT_NEAR(fittedOrder(errors), method().order, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Table, EachIntegrator, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const Integrator& i : integrators()) names.emplace_back(i.name);
                           return names;
                         }()),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

TEST(Leapfrog, IsExactForConstantGravity) {
  const Field field{.gravity = {0, -9.81, 0}};
  const Point end = fly(findIntegrator("leapfrog"), field, {{0, 5, 0}, {1, 2, 0}}, 0.25, 4);
  EXPECT_NEAR(end.x.y(), 5 + 2 - 9.81 / 2, 1e-14);
  EXPECT_NEAR(end.v.y(), 2 - 9.81, 1e-14);
}

TEST(Leapfrog, RunsBackwards) {
  const Field field{.wells = {{.strength = 1000, .softening = 2}}};
  const Integrator& leapfrog = findIntegrator("leapfrog");
  Point p = fly(leapfrog, field, {{10, 0, 0}, {0, 0, 6}}, 1.0 / 60, 300);
  p.v = -p.v;
  p = fly(leapfrog, field, p, 1.0 / 60, 300);
  EXPECT_LE(length(p.x - Vec3(10, 0, 0)), 1e-11);  // rounding only
}

TEST(Integrators, UnknownNameIsRefusedWithTheNamesThatExist) {
  try {
    findIntegrator("magic");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("magic"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("leapfrog"), std::string::npos);
  }
}

// Gravity alone is exact, whatever the integrator and however long the flight: a parabola.
TEST_P(EachIntegrator, FliesAParabolaUnderGravityAlone) {
  const Field field{.gravity = {1, -9.81, 2}};
  Vec3 x{1, 2, 3};
  Vec3 v{4, 5, -6};
  const std::uint32_t ball = 0;
  flyThrough(method(), {&field, 0, 3, 1}, {&ball, 1}, &x, &v);
  EXPECT_LE(length(x - Vec3(1 + 12 + 4.5, 2 + 15 - 4.5 * 9.81, 3 - 18 + 9)), 1e-14 * 50);
  EXPECT_LE(length(v - Vec3(7, 5 - 3 * 9.81, 0)), 1e-14 * 30);
}

// Three stretches and a half are flown as three flights and a half: the same bits.
TEST_P(EachIntegrator, FliesInStretches) {
  Field field{.wells = {{.velocity = {1, 0, -2}, .strength = 50, .softening = 0.5}}};
  field.stretch = 0.01;
  Point whole{{3, 0, 0}, {0, 0, 2}};
  Point parts = whole;
  flyThrough(method(), {&field, 0, 0.035, 0.9}, arraysOf(whole));
  double at = 0;
  double left = 0.035;
  for (const double h : {0.01, 0.01, 0.01, 0.0}) {
    method().fly({&field, at, h > 0 ? h : left, 0.9}, arraysOf(parts));
    at += h;
    left -= h;
  }
  EXPECT_EQ(whole.x, parts.x);
  EXPECT_EQ(whole.v, parts.v);
}

}  // namespace
}  // namespace wells
