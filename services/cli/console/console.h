#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/base/stopwatch.h"
#include "services/cli/console/exit_code.h"

namespace slicefarm::cli {

/// Prints `error: ...` to stderr, with advice if there is any. Returns the exit code.
ExitCode Fail(const absl::Status& status);

/// Returns advice about an error; empty if the message is enough.
std::string Advice(const absl::Status& status);

/// Prints one line `warning: ...` per text to stderr.
void Warn(const std::vector<std::string>& warnings);

/// Prints the warnings that are not in `reported`. `reported`: warnings that were already printed.
void WarnOfRest(std::vector<std::string> warnings, const std::vector<std::string>& reported);

/// Prints text to stdout, or to stderr if stdout contains the result.
void Print(std::string_view text, bool to_stderr = false);

/// Progress bar on stderr. It prints nothing if stderr is no terminal.
class ProgressBar {
 public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar() { Clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Shows the progress of the step `what`, and the remaining time as soon as it can be estimated.
  /// Prints only when the text changes. `total` = 0: the amount of work is not known yet.
  void Show(std::string_view what, int done, int total);
  /// Removes the bar from the terminal.
  void Clear();
  /// Returns false if the bar never prints.
  bool enabled() const { return enabled_; }

 private:
  std::string TimeLeft(std::string_view what, int done, int total);

  bool shown_ = false;
  bool enabled_;
  std::string what_;    ///< current step, for which the remaining time is estimated
  int first_done_ = 0;  ///< progress when the step was first shown
  Stopwatch since_;     ///< time since the step was first shown
  std::string line_;
};

}  // namespace slicefarm::cli
