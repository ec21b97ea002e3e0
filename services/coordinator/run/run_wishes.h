#pragma once

#include <atomic>
#include <cstdint>

#include "absl/status/status.h"
#include "services/coordinator/store/jobs/job_record.h"

namespace slicefarm::coordinator {

/// What others want of a run. Set from any thread; but for the deadline, never taken back. Times
/// are microseconds on the coordinator's clock.
class RunWishes {
 public:
  explicit RunWishes(int64_t deadline_us = kNoDeadlineUs) : deadline_us_(deadline_us) {}

  void Cancel() { cancelled_ = true; }      ///< its client wants it to end
  void HandBack() { handed_back_ = true; }  ///< the coordinator stops
  void Lose() { lost_ = true; }             ///< the job may have been claimed again
  void EndBy(int64_t deadline_us) { deadline_us_ = deadline_us; }

  /// The store's answer to a write of the run: Aborted says that the job was claimed again.
  void Heard(const absl::Status& written) {
    if (absl::IsAborted(written)) Lose();
  }

  bool cancelled() const { return cancelled_; }
  bool handed_back() const { return handed_back_; }
  bool lost() const { return lost_; }
  bool Overdue(int64_t now_us) const { return now_us >= deadline_us_; }
  bool GivenUp(int64_t now_us) const {
    return cancelled_ || handed_back_ || lost_ || Overdue(now_us);
  }

 private:
  std::atomic<int64_t> deadline_us_;
  std::atomic<bool> cancelled_ = false;
  std::atomic<bool> handed_back_ = false;
  std::atomic<bool> lost_ = false;
};

}  // namespace slicefarm::coordinator
