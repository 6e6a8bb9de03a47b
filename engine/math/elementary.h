// Sine, cosine, exponential and logarithm with the same bits on every processor.
//
// The C library picks its kernels by processor (with or without fma), and they differ in the last
// bit. These use + - x / only; they are accurate to a few units in the last place, and are meant
// for set-up and for once-per-step factors, not for inner loops.
#pragma once

namespace wells {

inline constexpr double kPi = 3.14159265358979323846;

struct SinCos {
  double sin;
  double cos;
};

/// Sine and cosine of `turns` full turns (1 turn = 2 pi rad). |turns| <= 2^50; relative error about
/// 1e-15; exact at multiples of a quarter turn.
SinCos sinCosOfTurns(double turns);

/// e^x for |x| <= 700; relative error about 1e-15 (1 + |x|).
double exponential(double x);

/// Natural logarithm, x > 0 and normal; relative error about 1e-15.
double naturalLogarithm(double x);

}  // namespace wells
