// Vector code against the formulas as they stand in the papers, one ball at a time: the same bits,
// on each instruction set, for any number of balls and whatever flies beside them.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "flight/integrators.h"
#include "math/elementary.h"
#include "math/instruction_set.h"
#include "math/random.h"

namespace wells {
namespace {

using OneStretch = std::function<void(const Flight&, Vec3& x, Vec3& v)>;

const std::map<std::string, OneStretch> kScalar = {
    {"symplectic-euler",
     [](const Flight& f, Vec3& x, Vec3& v) {
       v = (v + acceleration(*f.field, x, f.start) * f.duration) * dragFactor(f.drag, f.duration);
       x += v * f.duration;
     }},
    {"leapfrog",
     [](const Flight& f, Vec3& x, Vec3& v) {
       const double half = f.duration / 2;
       const double slowdown = dragFactor(f.drag, half);
       x += v * half;
       v = (v * slowdown + acceleration(*f.field, x, f.start + half) * f.duration) * slowdown;
       x += v * half;
     }},
    {"heun",
     [](const Flight& f, Vec3& x, Vec3& v) {
       const double h = f.duration;
       const double k = dragRate(f.drag);
       const Vec3 a = acceleration(*f.field, x, f.start) - k * v;
       const Vec3 end = v + h * a;
       const Vec3 aEnd = acceleration(*f.field, x + h * v, f.start + h) - k * end;
       x += (h / 2) * (v + end);
       v += (h / 2) * (a + aEnd);
     }},
    {"rk4",
     [](const Flight& f, Vec3& x, Vec3& v) {
       const double h = f.duration;
       const double k = dragRate(f.drag);
       const auto at = [&](const Vec3& p, const Vec3& u, double t) -> Vec3 {
         return acceleration(*f.field, p, f.start + t) - k * u;
       };
       const Vec3 a1 = at(x, v, 0);
       const Vec3 v2 = v + h / 2 * a1;
       const Vec3 a2 = at(x + h / 2 * v, v2, h / 2);
       const Vec3 v3 = v + h / 2 * a2;
       const Vec3 a3 = at(x + h / 2 * v2, v3, h / 2);
       const Vec3 v4 = v + h * a3;
       const Vec3 a4 = at(x + h * v3, v4, h);
       x += (h / 6) * (v + 2 * (v2 + v3) + v4);
       v += (h / 6) * (a1 + 2 * (a2 + a3) + a4);
     }},
    {"pefrl", [](const Flight& f, Vec3& x, Vec3& v) {
       constexpr double kXi = 0.1786178958448091;
       constexpr double kLambda = -0.2123418310626054;
       constexpr double kChi = -0.06626458266981849;
       const double h = f.duration;
       const double k = dragRate(f.drag);
       const auto kick = [&](double tau, double t) {
         const double keep = k == 0 ? 1 : exponential(-k * tau);
         const double gain = k == 0 ? tau : (1 - keep) / k;
         v = v * keep + acceleration(*f.field, x, t) * gain;
       };
       const double edge = kXi * h;
       const double near = kChi * h;
       const double middle = (1 - 2 * (kChi + kXi)) * h;
       x += v * edge;
       kick((1 - 2 * kLambda) * h / 2, f.start + edge);
       x += v * near;
       kick(kLambda * h, f.start + edge + near);
       x += v * middle;
       kick(kLambda * h, f.start + edge + near + middle);
       x += v * near;
       kick((1 - 2 * kLambda) * h / 2, f.start + h - edge);
       x += v * edge;
     }}};

struct Crowd {
  std::vector<Vec3> x;
  std::vector<Vec3> v;
};

Crowd randomCrowd(std::size_t size, std::uint64_t seed) {
  Random random(seed);
  const auto vector = [&](double scale) {
    return Vec3{random.uniform(-scale, scale), random.uniform(-scale, scale),
                random.uniform(-scale, scale)};
  };
  Crowd crowd;
  for (std::size_t i = 0; i < size; ++i) {
    crowd.x.push_back(vector(20));
    crowd.v.push_back(vector(30));
  }
  return crowd;
}

bool areSame(const Vec3& a, const Vec3& b) {
  for (int axis = 0; axis < 3; ++axis)
    if (std::bit_cast<std::uint64_t>(a[axis]) != std::bit_cast<std::uint64_t>(b[axis]) &&
        !(std::isnan(a[axis]) && std::isnan(b[axis])))
      return false;
  return true;
}

/// The same bits, but that one NaN is as good as another.
void expectSame(const Crowd& actual, const Crowd& expected, const std::string& what) {
  for (std::size_t i = 0; i < actual.x.size(); ++i) {
    ASSERT_TRUE(areSame(actual.x[i], expected.x[i])) << what << ", ball " << i;
    ASSERT_TRUE(areSame(actual.v[i], expected.v[i])) << what << ", ball " << i;
  }
}

/// In arrays of components that are too long on purpose: what follows must stay.
Crowd flownInArrays(const Integrator& integrator, const Flight& flight, Crowd crowd) {
  const std::size_t n = crowd.x.size();
  std::vector<std::vector<double>> c(6, std::vector<double>(n + 8, 777.0));
  for (std::size_t i = 0; i < n; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      c[axis][i] = crowd.x[i][axis];
      c[axis + 3][i] = crowd.v[i][axis];
    }
  flyThrough(integrator, flight,
             {c[0].data(), c[1].data(), c[2].data(), c[3].data(), c[4].data(), c[5].data(), n});
  for (std::size_t i = 0; i < n; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      crowd.x[i][axis] = c[axis][i];
      crowd.v[i][axis] = c[axis + 3][i];
    }
  for (const auto& component : c)
    for (std::size_t i = n; i < component.size(); ++i) EXPECT_EQ(component[i], 777.0);
  return crowd;
}

Crowd flownOneByOne(const Integrator& integrator, const Flight& flight, Crowd crowd,
                    const std::vector<std::uint32_t>& list) {
  const bool isParabola = flight.field->wells.empty() && flight.drag == 1;
  for (const std::uint32_t i : list) {
    Vec3& x = crowd.x[i];
    Vec3& v = crowd.v[i];
    if (isParabola) {
      const Vec3 gain = flight.field->gravity * flight.duration;
      x += (v + 0.5 * gain) * flight.duration;
      v += gain;
      continue;
    }
    Flight part = flight;
    double left = flight.duration;
    for (; left > flight.field->stretch; left -= flight.field->stretch) {
      part.duration = flight.field->stretch;
      kScalar.at(std::string(integrator.name))(part, x, v);
      part.start += flight.field->stretch;
    }
    part.duration = left;
    kScalar.at(std::string(integrator.name))(part, x, v);
  }
  return crowd;
}

class WideFlight : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override { useInstructionSet(GetParam()); }
  void TearDown() override { useInstructionSet(instructionSets().back()); }
};

const std::vector<Field>& fields() {
  static const std::vector<Field> kFields = [] {
    const Well still{.position = {3, 2, -1}, .strength = 400, .softening = 0.7};
    const Well moving{
        .position = {-4, 1, 2}, .velocity = {1, 0.5, -3}, .strength = -90, .softening = 2};
    std::vector<Field> list = {{},
                               {.gravity = {1, -9.81, 0.3}},
                               {.wells = {still}},
                               {.gravity = {0, -9.81, 0}, .wells = {still, moving}}};
    list.back().stretch = 0.006;
    list.push_back(list.back());  // more wells than a vector has lanes
    for (const Vec3& position : {Vec3{2, 9, 1}, Vec3{7, -3, 2}, Vec3{1, 1, -8}})
      list.back().wells.push_back({.position = position, .strength = 250, .softening = 1});
    return list;
  }();
  return kFields;
}

TEST_P(WideFlight, HasTheBitsOfOneBallAtATime) {
  for (const Integrator& integrator : integrators())
    for (const Field& field : fields())
      for (const double drag : {1.0, 0.6})
        for (const std::size_t size : {1, 2, 3, 7, 8, 15, 64, 150}) {
          const Flight flight{&field, 0.002, 1.0 / 60, drag};
          const std::string what = std::string(integrator.name) + ", " +
                                   std::to_string(field.wells.size()) + " wells, drag " +
                                   std::to_string(drag) + ", " + std::to_string(size) + " balls";
          Crowd crowd = randomCrowd(size, 7 + size);
          std::vector<std::uint32_t> all;
          std::vector<std::uint32_t> some;
          for (std::uint32_t i = 0; i < size; ++i) {
            all.push_back(i);
            if (i % 3 != 1) some.push_back(i);
          }
          expectSame(flownInArrays(integrator, flight, crowd),
                     flownOneByOne(integrator, flight, crowd, all), what + ", arrays");
          const Crowd expected = flownOneByOne(integrator, flight, crowd, some);
          flyThrough(integrator, flight, some, crowd.x.data(), crowd.v.data());
          expectSame(crowd, expected, what + ", list");
        }
}

TEST_P(WideFlight, WhatIsNotFiniteLeavesItsNeighboursAlone) {
  const Field& field = fields().back();
  const Flight flight{&field, 0, 1.0 / 60, 1};
  for (const Integrator& integrator : integrators()) {
    Crowd crowd = randomCrowd(13, 3);
    crowd.x[2].y() = std::numeric_limits<double>::quiet_NaN();
    crowd.v[9].x() = std::numeric_limits<double>::infinity();
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < 13; ++i) all.push_back(i);
    const Crowd expected = flownOneByOne(integrator, flight, crowd, all);
    const Crowd actual = flownInArrays(integrator, flight, crowd);
    expectSame(actual, expected, std::string(integrator.name));
    EXPECT_TRUE(std::isnan(actual.x[2].y()));
    EXPECT_TRUE(isFinite(actual.x[1]) && isFinite(actual.x[3]) && isFinite(actual.x[8]));
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, WideFlight, testing::ValuesIn(instructionSets()),
                         [](const auto& tested) { return std::string(name(tested.param)); });

}  // namespace
}  // namespace wells
