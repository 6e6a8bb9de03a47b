// How the lines of the work-precision plots look, the same in all of them. Colours are those of
// Okabe and Ito, which the colour-blind tell apart; markers differ as well.
#pragma once

#include <string>

#include "work_precision.h"

namespace wells {

/// gnuplot's words for a method's line and markers. Ours: a colour and a marker for each
/// integrator, solid and filled with exact contacts, dashed and open with substeps, wide and pale
/// below the others by default. The custom integrator is grey, Bullet red. `scale` multiplies all
/// sizes.
std::string plotStyle(const Method& method, double scale);

}  // namespace wells
