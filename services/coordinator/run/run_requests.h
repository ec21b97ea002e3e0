#pragma once

#include <atomic>
#include <cstdint>

#include "absl/status/status.h"
#include "services/coordinator/store/jobs/job_record.h"

namespace slicefarm::coordinator {

/// Requests to end a run. Any thread may set them. No request except the deadline is ever
/// withdrawn. Times are microseconds on the coordinator's clock.
class RunRequests {
 public:
  explicit RunRequests(int64_t deadline_us = kNoDeadlineUs) : deadline_us_(deadline_us) {}

  void Cancel() { cancelled_ = true; }      ///< the client requested the end of the job
  void HandBack() { handed_back_ = true; }  ///< the job returns to the queue
  void Lose() { lost_ = true; }             ///< the job may have been claimed again
  /// Sets the deadline of the job.
  void EndBy(int64_t deadline_us) { deadline_us_ = deadline_us; }

  /// Evaluates the store's answer to a write of the run: Aborted means that the job was claimed
  /// again or has ended.
  void Heard(const absl::Status& written) {
    if (absl::IsAborted(written)) Lose();
  }

  /// Returns true if the client requested the end of the job.
  bool cancelled() const { return cancelled_; }
  /// Returns true if the job returns to the queue, because the coordinator stops.
  bool handed_back() const { return handed_back_; }
  /// Returns true if the job may have been claimed again.
  bool lost() const { return lost_; }
  /// Returns true if the deadline has passed.
  bool Overdue(int64_t now_us) const { return now_us >= deadline_us_; }
  /// Returns true if the run must end: it is cancelled, handed back, lost or overdue.
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
