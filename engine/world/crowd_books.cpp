// What the substeps of a crowd did, for the books. Impulses of one substep add up to what each
// contact has in the end, so the kernels need not book them one by one.
#include "contacts/lasting_force.h"
#include "world/crowd.h"

namespace wells {
// As runSubstep() has it, with a look at the state after each part.
void Crowd::runBookedSubstep(const CrowdInput& in, double start, ThreadPool& pool, Balls& balls,
                             Books& books) {
  const double end = start + rules_.h;
  const auto inAllThreads = [&](auto part) {
    pool.run(
        [&](int thread, Barrier& barrier) { part(static_cast<std::size_t>(thread), barrier); });
    return bookingOf(in.model, end, balls);
  };
  StageScope stage(clock_, Stage::Books);
  bookFlights(in, start, balls, books);
  stage.next(Stage::Flight);
  fly(in, start, {0, island_.size()});
  const Booking flown = bookingOf(in.model, end, balls);
  stage.next(Stage::Solve);
  const Booking solved = inAllThreads([&](std::size_t thread, Barrier& barrier) {
    findLate(thread, barrier);
    prepare(thread, barrier);
    solve(in.settings, thread, barrier);
  });
  const Books impulses = booksOfImpulses(in.model, balls);
  stage.next(Stage::Push);
  const Booking shifted =
      inAllThreads([&](std::size_t thread, Barrier& barrier) { shift(thread, barrier); });
  const Booking pushed =
      inAllThreads([&](std::size_t thread, Barrier& barrier) { pushOut(thread, barrier); });
  bookSubstep(flown, solved, shifted, pushed, impulses, books);
}

void Crowd::bookFlights(const CrowdInput& in, double start, Balls& balls, Books& books) const {
  scatter(island_, balls);
  const Ledger ledger{&books, in.model.arena->center};
  for (const std::uint32_t i : island_)
    if (!in.isLeaning[i])
      bookPath(ledger, in.model, {balls.state(i), start, balls.radius[i]}, balls.mass[i],
               start + rules_.h);
}

Crowd::Booking Crowd::bookingOf(const PathModel& model, double time, Balls& balls) const {
  scatter(island_, balls);
  Booking booking;
  for (const std::uint32_t i : island_) {
    const double surface = balls.radius[i] * balls.radius[i] * squaredLength(balls.spin[i]);
    booking.kineticEnergy +=
        0.5 * balls.mass[i] * (squaredLength(balls.velocity[i]) + kInertiaFactor * surface);
  }
  booking.placement =
      placementOf({nullptr, model.arena->center}, *model.field, time, island_, balls);
  return booking;
}

Books Crowd::booksOfImpulses(const PathModel& model, const Balls& balls) {
  Books books;
  const Ledger ledger{&books, model.arena->center};
  forEachBlock([&](PartnerKind kind, const ContactBlock& block, const ContactFlight& flight) {
    for (std::size_t lane = 0; lane < block.count; ++lane) {
      Contact c{.a = island_[block.a[lane]],
                .b = kind == PartnerKind::Ball ? island_[block.b[lane]] : partnerOf(kind),
                .normal = {block.nx[lane], block.ny[lane], block.nz[lane]},
                .gap = flight.gap[lane],
                .impact = flight.lasts[lane] == 0,
                .builtUp = flight.builtUp[lane],
                .closingFlown = flight.closing[lane],
                .normalImpulse = block.normal[lane],
                .tangentImpulse = {block.tx[lane], block.ty[lane], block.tz[lane]}};
      c.share = shareAlone(c, balls);
      books.contacts += workOfNormals({&c, 1}, balls);
      if (kind == PartnerKind::Ball) {
        // Action and reaction act on two surfaces that an overlap keeps apart.
        books.shifts.angular -= c.gap * cross(c.normal, c.tangentImpulse);
        bookTurnedNormal(ledger, c, balls);
      } else {
        bookArena(ledger, c, c.tangentImpulse - c.normalImpulse * c.normal, balls);
      }
    }
  });
  return books;
}

// As resolveContacts() has it.
void Crowd::bookSubstep(const Booking& flown, const Booking& solved, const Booking& shifted,
                        const Booking& pushed, Books impulses, Books& books) const {
  const double both = solved.kineticEnergy - flown.kineticEnergy + shifted.placement.potential -
                      solved.placement.potential;
  const double normals = impulses.contacts;
  impulses.friction = rules_.friction > 0 ? both - normals : 0;
  // Without friction, the rest is by how much the pull of the fields varies over the shifts.
  impulses.pushOut =
      pushed.placement.potential - shifted.placement.potential + both - normals - impulses.friction;
  impulses.shifts.angular += pushed.placement.angular - solved.placement.angular;
  books += impulses;
}

}  // namespace wells
