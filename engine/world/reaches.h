// How far many balls may move in a step: reachOf() of advance.h in vector code, with its bits.
#pragma once

#include <cstdint>
#include <span>

#include "forces/field.h"
#include "state/balls.h"

namespace wells {

/// reach[i] (m) of each ball i of `among`. NaN for a ball whose state is not finite: it is in no
/// pair and is not moved.
void reachesOf(const Field& field, const Balls& balls, std::span<const std::uint32_t> among,
               double dt, std::span<double> reach);

}  // namespace wells
