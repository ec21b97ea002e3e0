#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

namespace slicefarm {

/// A program of this build as a process of its own. Killed when it goes out of scope.
class ChildProcess {
 public:
  enum class Stderr { kDropped, kWithStdout };

  /// `program`: a name in build/bin, or a whole path. Dies if it cannot be started.
  ChildProcess(const std::string& program, std::vector<std::string> arguments,
               Stderr errors = Stderr::kDropped);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Reads its stdout up to a line that begins with `prefix`, and returns the rest of that line;
  /// empty if it ended before.
  std::string AwaitLine(std::string_view prefix);

  void Signal(int signal) const;

  /// Waits for its end; the exit code, or minus the signal that ended it.
  int Wait();

  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = -1;
  int stdout_ = -1;
  std::string unread_;
  bool ended_ = false;
};

/// A server program, and where it serves.
struct ServerProcess {
  /// Dies if it does not serve.
  explicit ServerProcess(const std::string& program, std::vector<std::string> arguments = {});

  /// What /metrics shows for a metric; empty: there is none of that name and labels.
  std::string Metric(const std::string& name) const;
  /// Waits until /metrics shows this line. REQUIRES: `--metrics-port 0` among the arguments.
  void AwaitMetric(const std::string& line) const;

  ChildProcess process;
  const int metrics_port;  ///< 0: it serves none
  const std::string address;
};

}  // namespace slicefarm
