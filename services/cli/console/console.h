#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/base/stopwatch.h"
#include "services/cli/console/exit_code.h"

namespace slicefarm::cli {

/// Prints `error: ...` to stderr, with what to do about it where that can be said, and gives the
/// exit code.
ExitCode Fail(const absl::Status& status);

/// What a user can do about an error; empty where the message says it all.
std::string Advice(const absl::Status& status);

/// One line each to stderr: `warning: ...`.
void Warn(const std::vector<std::string>& warnings);

/// Warn, but for those that were told before.
void WarnOfRest(std::vector<std::string> warnings, const std::vector<std::string>& told);

/// Text to stdout, or to stderr where stdout carries the result.
void Print(std::string_view text, bool to_stderr = false);

/// A bar on stderr while something lasts; nothing at all where stderr is no terminal.
class ProgressBar {
 public:
  explicit ProgressBar(bool wanted);
  ~ProgressBar() { Clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `total` 0: how much there is to do is not known yet. Prints only when the picture changes,
  /// with the time that is left as soon as that can be told.
  void Show(std::string_view what, int done, int total);
  void Clear();
  /// Returns false if nothing is ever shown.
  bool enabled() const { return enabled_; }

 private:
  std::string TimeLeft(std::string_view what, int done, int total);

  bool shown_ = false;
  bool enabled_;
  std::string what_;    ///< of which the time is told
  int first_done_ = 0;  ///< when it was first shown
  Stopwatch since_;     ///< then
  std::string line_;
};

}  // namespace slicefarm::cli
