#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>
#include <vector>

namespace slicefarm {

/// Program of this build as a separate process. The destructor kills it.
class ChildProcess {
 public:
  enum class Stderr { kDropped, kWithStdout };

  /// Starts `program`: a name in build/bin, or a whole path. Aborts if the program cannot be
  /// started.
  ChildProcess(const std::string& program, std::vector<std::string> arguments,
               Stderr errors = Stderr::kDropped);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Reads stdout up to a line that begins with `prefix`, and returns the rest of that line.
  /// Returns an empty text if the process ended before such a line.
  std::string AwaitLine(std::string_view prefix);

  void Signal(int signal) const;

  /// Waits for the end of the process. Returns the exit code, or minus the signal that ended the
  /// process.
  int Wait();

  pid_t pid() const { return pid_; }

 private:
  pid_t pid_ = -1;
  int stdout_ = -1;
  std::string unread_;
  bool ended_ = false;
};

/// Server program with its address.
struct ServerProcess {
  /// Aborts if the server does not start.
  explicit ServerProcess(const std::string& program, std::vector<std::string> arguments = {});

  /// Returns the value of a metric in /metrics; empty if the server has no such metric. `name`:
  /// name of the metric with its labels.
  std::string Metric(const std::string& name) const;
  /// Waits until /metrics has this line. REQUIRES: `--metrics-port 0` among the arguments.
  void AwaitMetric(const std::string& line) const;

  ChildProcess process;
  const int metrics_port;  ///< port for /metrics; 0: the server exports no metrics
  const std::string address;
};

}  // namespace slicefarm
