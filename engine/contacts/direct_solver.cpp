#include "contacts/direct_solver.h"

#include <algorithm>
#include <cmath>

#include "contacts/partners.h"
#include "math/linear_equations.h"

namespace wells {
namespace {

constexpr int kMostHalvings = 8;

/// Any unit vector in the tangent plane; along an axis for a normal along an axis, so that no
/// rounding leaks from one to the other.
Vec3 tangentOf(const Vec3& normal) {
  const bool isAlongZ = std::abs(normal.z()) > 0.9;
  const Vec3 across =
      isAlongZ ? Vec3(0, normal.z(), -normal.y()) : Vec3(normal.y(), -normal.x(), 0);
  return across / length(across);
}

}  // namespace

bool DirectSolver::solve(double friction, std::span<Contact* const> contacts, const Balls& balls,
                         double rollingResistance) {
  friction_ = friction;
  rollingResistance_ = rollingResistance;
  rowsPerContact_ = 1 + (friction > 0 ? 2 : 0) + (rollingResistance > 0 ? 2 : 0);
  setUp(contacts, balls);
  const bool isSolved = approach();
  keepImpulses(contacts, balls);
  return isSolved;
}

// Proximal points: c <- the y that solves the equations for w + proximity (y - c) in place of w.
bool DirectSolver::approach() {
  proximity_ = kLeastProximity;
  stepsLeft_ = kMostSteps;
  for (int round = 0; stepsLeft_ > 0; ++round) {
    center_ = impulse_;
    bool isReached = runNewton(Steps::Damped);
    if (!isReached && round > 0 && stepsLeft_ > 0) {
      impulse_ = center_;
      isReached = runNewton(Steps::Full);
    }
    if (!isReached) {
      impulse_ = center_;
      proximity_ = round == 0 ? kSafeProximity : std::min(kMostProximity, kGrowth * proximity_);
      continue;
    }
    double moved = 0;
    for (std::size_t i = 0; i < impulse_.size(); ++i)
      moved = std::max(moved, std::abs(impulse_[i] - center_[i]));
    if (proximity_ * moved <= kTolerance * scale_) return true;
    proximity_ = std::max(kLeastProximity, proximity_ / kShrinking);
  }
  return false;
}

void DirectSolver::setUp(std::span<Contact* const> contacts, const Balls& balls) {
  const std::size_t n = contacts.size() * rowsPerContact_;
  makeRoom(std::max(contacts.size(), kMostDirect) * rowsPerContact_);
  rows_.clear();
  cones_.clear();
  startVelocity_.clear();
  start_.clear();
  for (const Contact* c : contacts) {
    const std::size_t normal = rows_.size();
    const double normalScale = std::sqrt(normalMass(*c));
    rows_.push_back({-c->normal, Vec3::Zero(), Vec3::Zero(), normalScale});
    startVelocity_.push_back(-normalScale * (closingSpeed(balls, *c) + c->bounceSpeed));
    start_.push_back(c->normalImpulse / normalScale);
    if (rowsPerContact_ == 1) continue;
    const Vec3 first = tangentOf(c->normal);
    const Vec3 tangents[2] = {first, cross(c->normal, first)};
    withPartner(*c, [&]<class Partner>() {
      if (friction_ > 0) {
        const double scale = std::sqrt(tangentMass(*c));
        cones_.push_back({normal, rows_.size(), friction_ * std::sqrt(1 + kSpinFactor)});
        for (const Vec3& tangent : tangents) {
          const Vec3 turn = cross(c->normal, tangent);
          rows_.push_back({tangent, turn, turn, scale});
          startVelocity_.push_back(scale * dot(slipVelocity<Partner>(balls, *c), tangent));
          start_.push_back(dot(c->tangentImpulse, tangent) / scale);
        }
      }
      if (rollingResistance_ > 0) {
        const double scale = 1 / std::sqrt(inverseTurningInertia<Partner>(balls, *c));
        // None within an impact.
        cones_.push_back(
            {normal, rows_.size(), c->impact ? 0 : rollingResistance_ * normalScale / scale});
        for (const Vec3& axis : tangents) {
          rows_.push_back({Vec3::Zero(), axis / balls.radius[c->a],
                           isBall(c->b) ? Vec3(-axis / balls.radius[c->b]) : Vec3::Zero(), scale});
          startVelocity_.push_back(scale * dot(rollingVelocity<Partner>(balls, *c), axis));
          start_.push_back(dot(c->rollingImpulse, axis) / scale);
        }
      }
    });
  }
  coupling_.resize(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      coupling_[i * n + j] = rows_[i].scale * rows_[j].scale * couplingOf(contacts, i, j);
  impulse_ = start_;
  velocity_.resize(n);
  residual_.resize(n);
  before_.resize(n);
}

// Once for all islands.
void DirectSolver::makeRoom(std::size_t most) {
  if (rows_.capacity() >= most) return;
  rows_.reserve(most);
  cones_.reserve(most);
  impulses_.reserve(most);
  for (auto* list :
       {&startVelocity_, &start_, &center_, &impulse_, &velocity_, &residual_, &step_, &before_})
    list->reserve(most);
  for (auto* square : {&coupling_, &matrix_}) square->reserve(most * most);
}

/// What an impulse of 1 along row j does to the velocity along row i through the balls they share.
double DirectSolver::couplingOf(std::span<Contact* const> contacts, std::size_t i,
                                std::size_t j) const {
  const Contact& x = *contacts[i / rowsPerContact_];
  const Contact& y = *contacts[j / rowsPerContact_];
  const double pushes = dot(rows_[i].push, rows_[j].push);
  double sum = 0;
  const auto share = [&](std::uint32_t one, const Vec3& turnOne, std::uint32_t other,
                         const Vec3& turnOther, double inverseMass, double side) {
    if (one == other) sum += inverseMass * (side * pushes + kSpinFactor * dot(turnOne, turnOther));
  };
  share(x.a, rows_[i].turnA, y.a, rows_[j].turnA, x.inverseMassA, 1);
  share(x.a, rows_[i].turnA, y.b, rows_[j].turnB, x.inverseMassA, -1);
  share(x.b, rows_[i].turnB, y.a, rows_[j].turnA, x.inverseMassB, -1);
  share(x.b, rows_[i].turnB, y.b, rows_[j].turnB, x.inverseMassB, 1);
  return sum;
}

double DirectSolver::evaluate() {
  const std::size_t n = rows_.size();
  for (std::size_t i = 0; i < n; ++i) {
    double sum = startVelocity_[i] + proximity_ * (impulse_[i] - center_[i]);
    for (std::size_t j = 0; j < n; ++j) sum += coupling_[i * n + j] * (impulse_[j] - start_[j]);
    velocity_[i] = sum;
  }
  for (std::size_t i = 0; i < n; i += rowsPerContact_)
    residual_[i] = impulse_[i] - velocity_[i] > 0 ? velocity_[i] : impulse_[i];
  for (const auto& [normal, i, limit] : cones_) {
    const double pressed = std::max(0.0, impulse_[normal] - velocity_[normal]);
    const double first = impulse_[i] - velocity_[i];
    const double second = impulse_[i + 1] - velocity_[i + 1];
    const double size = std::sqrt(first * first + second * second);
    const bool slips = size > limit * pressed;
    const double cut = slips ? limit * pressed / size : 1;
    residual_[i] = slips ? impulse_[i] - cut * first : velocity_[i];
    residual_[i + 1] = slips ? impulse_[i + 1] - cut * second : velocity_[i + 1];
  }
  error_ = 0;
  scale_ = 0;
  double squares = 0;
  for (std::size_t i = 0; i < n; ++i) {
    error_ = std::max(error_, std::abs(residual_[i]));
    scale_ = std::max({scale_, std::abs(impulse_[i]), std::abs(startVelocity_[i])});
    squares += residual_[i] * residual_[i];
  }
  if (scale_ == 0) scale_ = 1;
  return squares;
}

bool DirectSolver::runNewton(Steps steps) {
  double squares = evaluate();
  for (int i = 0; i < kMostInRound; ++i) {
    if (error_ <= kTolerance * scale_) return true;
    if (stepsLeft_-- == 0) return false;
    linearise();
    if (!solveLinear(matrix_, step_)) return false;
    before_ = impulse_;
    const double squaresBefore = squares;
    double part = 1;
    for (int halvings = 0; halvings <= kMostHalvings; ++halvings, part /= 2) {
      for (std::size_t k = 0; k < step_.size(); ++k) impulse_[k] = before_[k] + part * step_[k];
      squares = evaluate();
      if (squares < squaresBefore || steps == Steps::Full) break;
    }
    if (!(squares < squaresBefore) && (steps == Steps::Damped || error_ <= kStalled * scale_)) {
      impulse_ = before_;
      evaluate();
      return error_ <= kStalled * scale_;
    }
  }
  return error_ <= kStalled * scale_;
}

/// Sets matrix_ to the derivative of the residual by the impulses, and step_ to -residual.
void DirectSolver::linearise() {
  const std::size_t n = rows_.size();
  matrix_.assign(n * n, 0);
  step_.resize(n);
  const auto row = [&](std::size_t i) { return matrix_.data() + i * n; };
  const auto coupling = [&](std::size_t i) { return coupling_.data() + i * n; };
  for (std::size_t i = 0; i < n; ++i) step_[i] = -residual_[i];
  const auto copyRow = [&](std::size_t i) {
    std::copy_n(coupling(i), n, row(i));
    row(i)[i] += proximity_;
  };
  for (std::size_t i = 0; i < n; i += rowsPerContact_)
    if (impulse_[i] - velocity_[i] > 0)
      copyRow(i);
    else
      row(i)[i] = 1;
  for (const auto& [normal, i, limit] : cones_) {
    const double pressed = impulse_[normal] - velocity_[normal];
    const bool isPressed = pressed > 0;
    const double z[2] = {impulse_[i] - velocity_[i], impulse_[i + 1] - velocity_[i + 1]};
    const double size = std::sqrt(z[0] * z[0] + z[1] * z[1]);
    if (isPressed && size <= limit * pressed) {
      copyRow(i);
      copyRow(i + 1);
      continue;
    }
    row(i)[i] = 1;
    row(i + 1)[i + 1] = 1;
    if (!isPressed) continue;
    // y_t - mu z_n d with d = z_t/|z_t|: dd = (1 - d d') dz_t / |z_t|, dz = dy - W dy.
    const double d[2] = {z[0] / size, z[1] / size};
    const double turning = limit * pressed / size;
    for (std::size_t k = 0; k < 2; ++k) {
      const double across[2] = {turning * ((k == 0 ? 1 : 0) - d[k] * d[0]),
                                turning * ((k == 1 ? 1 : 0) - d[k] * d[1])};
      double* const out = row(i + k);
      const double along = limit * d[k];
      for (std::size_t j = 0; j < n; ++j)
        out[j] += along * coupling(normal)[j] + across[0] * coupling(i)[j] +
                  across[1] * coupling(i + 1)[j];
      out[normal] -= along * (1 - proximity_);
      out[i] -= across[0] * (1 - proximity_);
      out[i + 1] -= across[1] * (1 - proximity_);
    }
  }
}

void DirectSolver::keepImpulses(std::span<Contact* const> contacts, const Balls& balls) {
  impulses_.resize(contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const std::size_t i = c * rowsPerContact_;
    const auto inUnits = [&](std::size_t k) { return rows_[k].scale * impulse_[k]; };
    Impulse& impulse = impulses_[c];
    impulse = {};
    impulse.normal = std::max(0.0, inUnits(i));  // an open one's is 0 but for rounding
    std::size_t next = i + 1;
    if (friction_ > 0) {
      impulse.tangent = inUnits(next) * rows_[next].push + inUnits(next + 1) * rows_[next + 1].push;
      next += 2;
    }
    if (rollingResistance_ > 0)
      impulse.rolling = balls.radius[contacts[c]->a] * (inUnits(next) * rows_[next].turnA +
                                                        inUnits(next + 1) * rows_[next + 1].turnA);
  }
}

}  // namespace wells
