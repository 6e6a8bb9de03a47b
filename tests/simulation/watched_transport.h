// A transport that lets the simulator see each message of a peer on its way out and in, and that
// can fall silent in the middle of a tick, as a process that dies.
#pragma once

#include <functional>

#include "network/memory_transport.h"

namespace wells::simulation {

class WatchedTransport final : public Transport {
 public:
  struct Watch {
    /// Before a message goes out; false: it does not, nor does anything after it.
    std::function<bool(std::string_view channel, std::span<const std::byte> bytes)> sending;
    /// After it went out; false: nothing after it does.
    std::function<bool(std::string_view channel, std::span<const std::byte> bytes)> sent;
    std::function<void(std::string_view channel, std::span<const std::byte> bytes)> received;
  };

  WatchedTransport(std::shared_ptr<MemoryNetwork> network, Watch watch)
      : inner_(std::move(network)), watch_(std::move(watch)) {}

  void publish(std::string_view channel, std::span<const std::byte> bytes) override {
    if (isSilent_) return;
    if (!watch_.sending(channel, bytes)) {
      isSilent_ = true;
      return;
    }
    inner_.publish(channel, bytes);
    if (!watch_.sent(channel, bytes)) isSilent_ = true;
  }

  void poll(const Handler& handler) override {
    inner_.poll([&](std::string_view channel, std::span<const std::byte> bytes) {
      watch_.received(channel, bytes);
      handler(channel, bytes);
    });
  }

  TransportCounts counts() const override { return inner_.counts(); }
  std::string description() const override { return inner_.description(); }

  int endpoint() const { return inner_.endpoint(); }
  bool isSilent() const { return isSilent_; }

 private:
  MemoryTransport inner_;
  Watch watch_;
  bool isSilent_ = false;
};

}  // namespace wells::simulation
