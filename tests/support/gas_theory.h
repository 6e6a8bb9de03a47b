// What kinetic theory and statistical mechanics say about gases of hard balls and discs. Lengths in
// diameters, masses in balls' masses.
#pragma once

#include <cmath>
#include <numbers>

namespace wells::theory {

inline constexpr double kPi = std::numbers::pi;

/// Volume of the balls in a volume, from their number density: pi/6 sigma^3 n.
inline double packing(double density) {
  return kPi / 6 * density;
}

/// P V / (N kT) of hard spheres: Carnahan & Starling, J. Chem. Phys. 51 (1969) 635. Simulations and
/// the virial series lie up to 0.3 % above.
inline double carnahanStarling(double eta) {
  return (1 + eta + eta * eta - eta * eta * eta) / std::pow(1 - eta, 3);
}

/// The pair distribution at contact that belongs to it: (Z - 1) / (4 eta).
inline double contactValue(double eta) {
  return (1 - eta / 2) / std::pow(1 - eta, 3);
}

/// Hits of a ball in a unit of time at kT = 1. Enskog: in a gas of unit density at infinite
/// dilution a ball sweeps the cross-section pi at the mean relative speed 4 / sqrt(pi), and others
/// stand denser at contact, g times.
inline double hitRate(double density) {
  return density * kPi * (4 / std::sqrt(kPi)) * contactValue(packing(density));
}

/// T(t) / T(0) of a smooth gas with restitution e: Haff, J. Fluid Mech. 134 (1983) 401. A hit takes
/// (1 - e^2)/4 of the square of the closing speed, on average (1 - e^2) kT of 2 x 3/2 kT, so
/// T' = -(1 - e^2)/3 rate(T) T, and the rate goes as sqrt(T).
inline double haffCooling(double density, double elasticity, double time) {
  const double slower = 1 + (1 - elasticity * elasticity) * hitRate(density) * time / 6;
  return 1 / (slower * slower);
}

/// P A / (N kT) of hard discs: Henderson, Mol. Phys. 30 (1975) 971. eta: their share of the area.
inline double henderson(double eta) {
  return (1 + eta * eta / 8) / ((1 - eta) * (1 - eta));
}

/// The fraction of balls slower than `speed` in space, kT = 1.
inline double maxwellInSpace(double speed) {
  return std::erf(speed / std::numbers::sqrt2) -
         std::sqrt(2 / kPi) * speed * std::exp(-speed * speed / 2);
}

/// The same in a plane.
inline double maxwellInPlane(double speed) {
  return 1 - std::exp(-speed * speed / 2);
}

}  // namespace wells::theory
