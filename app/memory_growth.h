// How much memory a part of the program takes: by how much it makes the process grow.
#pragma once

namespace wells {

/// Made before it, read after it. Memory that was given back counts as well: a machine needs the
/// most that was there at a time. What the process held before does not count. One at a time.
class MemoryGrowth {
 public:
  MemoryGrowth();

  /// MiB of resident memory.
  double most() const;

 private:
  double before_;  // MiB
};

}  // namespace wells
