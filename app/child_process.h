// A process of ours: this executable again, or another program; no shell in between.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace wells {

class ChildProcess {
 public:
  /// Starts `program`, which is looked for in PATH unless it holds a slash; what it says on
  /// standard output and error goes into `log`. Throws RunError.
  ChildProcess(const std::string& program, const std::vector<std::string>& arguments,
               const std::filesystem::path& log);

  /// The same with this executable.
  ChildProcess(const std::vector<std::string>& arguments, const std::filesystem::path& log);

  /// Kills it if it still runs.
  ~ChildProcess();
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;

  /// The exit status once it has ended (128 + signal if one ended it), else nothing.
  std::optional<int> poll();

  /// The same after waiting for its end, `seconds` at most.
  std::optional<int> wait(double seconds);

  /// Asks it to end cleanly.
  void interrupt() const;

 private:
  pid_t process_ = -1;
  std::optional<int> status_;
};

}  // namespace wells
