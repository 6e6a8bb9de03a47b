#include "state/books.h"

namespace wells {
namespace {

void add(ImpulseBook& sum, const ImpulseBook& more) {
  sum.linear += more.linear;
  sum.angular += more.angular;
}

}  // namespace

Books& Books::operator+=(const Books& more) {
  contacts += more.contacts;
  friction += more.friction;
  drag += more.drag;
  wells += more.wells;
  pushOut += more.pushOut;
  flight += more.flight;
  sleep += more.sleep;
  outside += more.outside;
  add(ground, more.ground);
  add(wall, more.wall);
  add(fields, more.fields);
  add(shifts, more.shifts);
  add(rest, more.rest);
  add(changes, more.changes);
  return *this;
}

}  // namespace wells
