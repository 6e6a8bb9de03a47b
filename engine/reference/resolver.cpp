#include "reference/resolver.h"

#include <limits>

namespace wells {
namespace {

/// Below this (m/s), what gravity built up within the step may not bounce.
constexpr double kRestingSpeed = 0.1;

double inverseMass(const Balls& balls, std::uint32_t ball) {
  return ball == kNoBall ? 0 : 1 / balls.mass[ball];
}

/// v_s = (v1 - v2) . n, negative while they close.
double separatingSpeed(const ManifoldContact& contact, const Balls& balls) {
  Vec3 relative = balls.velocity[contact.first];
  if (contact.second != kNoBall) relative -= balls.velocity[contact.second];
  return dot(relative, contact.normal);
}

/// What decides whose turn it is: v_s, and after all that close those that overlap at v_s = 0.
double urgency(const ManifoldContact& contact, const Balls& balls) {
  const double speed = separatingSpeed(contact, balls);
  if (speed == 0 && contact.penetration > 0) return -std::numeric_limits<double>::min();
  return speed;
}

/// a_s = (a1 - a2) . n h. Two balls have the same a; ground and wall have none.
double speedFromAcceleration(const ManifoldContact& contact, const ResolverInput& input) {
  return contact.second == kNoBall ? dot(input.acceleration, contact.normal) * input.h : 0;
}

void resolveVelocity(const ManifoldContact& contact, Balls& balls, const ResolverInput& input) {
  const double before = separatingSpeed(contact, balls);
  const double fromAcceleration = speedFromAcceleration(contact, input);
  double after = -input.elasticity * before;
  if (fromAcceleration < 0) {
    after += input.elasticity * fromAcceleration;
    if (after < kRestingSpeed) after = 0;
  }
  const double w1 = inverseMass(balls, contact.first);
  const double w2 = inverseMass(balls, contact.second);
  const Vec3 impulse = contact.normal * ((after - before) / (w1 + w2));
  balls.velocity[contact.first] += impulse * w1;
  if (contact.second != kNoBall) balls.velocity[contact.second] -= impulse * w2;
}

}  // namespace

std::int64_t Resolver::resolve(Manifold& manifold, Balls& balls, const ResolverInput& input) {
  if (manifold.empty()) return 0;
  index(manifold, balls.size());
  urgencies_.clear();
  for (const ManifoldContact& contact : manifold) {
    urgencies_.push_back(urgency(contact, balls));
  }
  order_.assign(urgencies_);

  for (std::int64_t taken = 0; taken < input.maxIterations; ++taken) {
    const std::uint32_t worst = order_.first();
    if (worst == MostNegative::kNone) return taken;
    const ManifoldContact contact = manifold[worst];
    resolveVelocity(contact, balls, input);
    if (contact.penetration > 0) {
      resolvePenetration(manifold, contact, balls);
      manifold[worst].penetration = 0;  // and not what rounding leaves of it
    }
    refresh(manifold, balls, contact.first);
    if (contact.second != kNoBall) refresh(manifold, balls, contact.second);
  }
  return input.maxIterations;
}

void Resolver::resolvePenetration(Manifold& manifold, const ManifoldContact& contact,
                                  Balls& balls) const {
  const double w1 = inverseMass(balls, contact.first);
  const double w2 = inverseMass(balls, contact.second);
  const Vec3 push = contact.normal * (contact.penetration / (w1 + w2));
  balls.position[contact.first] += push * w1;
  moved(manifold, contact.first, push * w1);
  if (contact.second == kNoBall) return;
  balls.position[contact.second] -= push * w2;
  moved(manifold, contact.second, push * -w2);
}

void Resolver::index(const Manifold& manifold, std::size_t ballCount) {
  start_.assign(ballCount + 2, 0);
  for (const ManifoldContact& contact : manifold) {
    ++start_[contact.first + 2];
    if (contact.second != kNoBall) ++start_[contact.second + 2];
  }
  for (std::size_t b = 2; b < start_.size(); ++b) start_[b] += start_[b - 1];
  contactsOf_.resize(start_.back());
  for (std::uint32_t c = 0; c < manifold.size(); ++c) {
    contactsOf_[start_[manifold[c].first + 1]++] = c;
    if (manifold[c].second != kNoBall) contactsOf_[start_[manifold[c].second + 1]++] = c;
  }
}

void Resolver::moved(Manifold& manifold, std::uint32_t ball, const Vec3& by) const {
  for (std::uint32_t k = start_[ball]; k < start_[ball + 1]; ++k) {
    ManifoldContact& contact = manifold[contactsOf_[k]];
    const double apart = dot(by, contact.normal);
    contact.penetration -= contact.first == ball ? apart : -apart;
  }
}

void Resolver::refresh(const Manifold& manifold, const Balls& balls, std::uint32_t ball) {
  for (std::uint32_t k = start_[ball]; k < start_[ball + 1]; ++k) {
    const std::uint32_t c = contactsOf_[k];
    order_.set(c, urgency(manifold[c], balls));
  }
}

}  // namespace wells
