// Rules of the contacts in substeps, which hold for islands of any size.
#pragma once

namespace wells {

/// Share of a remaining overlap between balls that one substep pushes out. All of it at once makes
/// a heap hop: each push-out creates the neighbour's overlap. The arena does not give way: all.
inline constexpr double kPushOut = 0.6;
inline constexpr double kPushOutOfArena = 1.0;

/// How deep a ball may be in the arena that leaves it fast, in radii.
inline constexpr double kDeepestInArena = 0.99;

/// Overlap (of the smaller radius) that is left to balls which push on each other in an island that
/// is not solved directly. Pushed out to nothing, contacts open and close by rounding in every
/// substep, each loses the impulse that it had found, and the heap creeps for ever.
inline constexpr double kLeftOverlap = 1e-3;

/// An island is solved when a pass changes no velocity by more than this of what forces gave in the
/// substep, or of what an impact closes with.
inline constexpr double kSolved = 1e-12;

/// Passes that an island without impacts that does not move is given until it is solved, if the
/// settings give fewer: there impulses last, and what one substep finds serves the next. Until then
/// a heap that should stand creeps.
inline constexpr int kPassesAtRest = 16;

/// Likewise where impacts of restitution 1 happen: what is not solved yet gains energy.
inline constexpr int kPassesLossless = 256;

/// What is further apart than this (of a radius) does not touch; and where forces move a ball
/// further within a substep, substeps are too coarse to tell what rests.
inline constexpr double kNear = 0.01;

/// Balls that would pass each other at more than this (of the sum of their radii) within a step
/// will hardly touch in it: such pairs of a crowd are looked at, but not kept ready. Smaller: fewer
/// are; but where a pair comes and goes, so does the order in which contacts are solved. With 0.05,
/// 2 of 6 heaps of 250 balls in T1 never came to rest, with 0.1 none of 10.
inline constexpr double kFarGap = 0.1;

}  // namespace wells
