// Room in lists that are filled anew in every step, and so long that twice as much would hurt.
#pragma once

#include <cstddef>
#include <vector>

namespace wells {

/// Makes a list so long; what it held may be lost. Takes memory rarely, and an eighth to spare.
template <class Element>
void resizeAfresh(std::vector<Element>& list, std::size_t size) {
  if (list.capacity() < size) {
    list.clear();
    list.reserve(size + size / 8);
  }
  list.resize(size);
}

/// Makes a list at least so long, likewise; what it held stays.
template <class Element>
void makeRoomFor(std::vector<Element>& list, std::size_t size) {
  if (list.size() >= size) return;
  list.reserve(size + size / 8 + 64);  // resize() would double it
  list.resize(list.capacity());
}

}  // namespace wells
