// The event log of a run: one line an event, in the order in which things happened, with nothing in
// it that differs from one run of a seed to the next.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

namespace wells::simulation {

class Trace {
 public:
  enum class Keeping { Nothing, Everything };
  explicit Trace(Keeping keeping) : keeping_(keeping) {}

  bool isOn() const { return keeping_ == Keeping::Everything; }

  /// Costs nothing but the test when nothing is kept.
  template <class... T>
  void add(double time, fmt::format_string<T...> format, T&&... arguments) {
    if (!isOn()) return;
    fmt::format_to(std::back_inserter(text_), "{:9.4f}  ", time);
    fmt::format_to(std::back_inserter(text_), format, std::forward<T>(arguments)...);
    text_ += '\n';
  }

  const std::string& text() const { return text_; }

 private:
  Keeping keeping_;
  std::string text_;
};

}  // namespace wells::simulation
