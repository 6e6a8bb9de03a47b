// Messages in a row, in one block of memory that is used again after clear(). Not thread-safe.
#pragma once

#include <cstring>
#include <utility>
#include <vector>

#include "network/transport.h"

namespace wells {

class MessageQueue {
 public:
  explicit MessageQueue(std::size_t capacity) : capacity_(capacity) {}

  /// False, and nothing happens, when it is full.
  bool push(std::string_view channel, std::span<const std::byte> bytes) {
    if (entries_.size() >= capacity_) return false;
    entries_.push_back({memory_.size(), channel.size(), bytes.size()});
    const auto name = std::as_bytes(std::span(channel));
    memory_.insert(memory_.end(), name.begin(), name.end());
    memory_.push_back(std::byte{0});
    memory_.insert(memory_.end(), bytes.begin(), bytes.end());
    return true;
  }

  std::size_t size() const { return entries_.size(); }
  bool empty() const { return entries_.empty(); }

  /// The i-th message's channel, with a zero byte after its end.
  std::string_view channel(std::size_t i) const {
    const Entry& entry = entries_[i];
    return {reinterpret_cast<const char*>(memory_.data()) + entry.start, entry.channelSize};
  }

  std::span<const std::byte> bytes(std::size_t i) const {
    const Entry& entry = entries_[i];
    return std::span(memory_).subspan(entry.start + entry.channelSize + 1, entry.size);
  }

  /// Keeps the memory.
  void clear() {
    entries_.clear();
    memory_.clear();
  }

 private:
  struct Entry {
    std::size_t start;
    std::size_t channelSize;
    std::size_t size;
  };
  std::size_t capacity_;
  std::vector<Entry> entries_;
  std::vector<std::byte> memory_;
};

}  // namespace wells
