#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/layers/layer.h"

namespace slicefarm::rpc {

/// Limit on the number of calls that work at the same time (slots), and on the number of calls that
/// wait for a slot. Thread-safe; must outlive its tickets.
class Admission {
 public:
  /// Permission to work: one slot. The destructor frees the slot.
  class Ticket {
   public:
    explicit Ticket(Admission* admission) : admission_(admission) {}
    Ticket(Ticket&& other) noexcept : admission_(other.admission_) { other.admission_ = nullptr; }
    Ticket& operator=(Ticket&&) = delete;
    ~Ticket();

   private:
    Admission* admission_;
  };

  /// Makes a limit. `slots`: calls that work at the same time. `queue`: calls that may wait.
  /// REQUIRES: slots >= 1, queue >= 0.
  Admission(int slots, int queue) : slots_(slots), queue_(queue) {}

  /// Waits for a slot. Errors: ResourceExhausted, reason OVERLOADED with metadata `limit` and
  /// `retry_after_ms`, if the queue is full; Cancelled if `cancel` is cancelled during the wait.
  absl::StatusOr<Ticket> Enter(const CancelToken& cancel);

  int slots() const { return slots_; }
  int working() const;
  int waiting() const;

 private:
  void Leave();

  const int slots_;
  const int queue_;
  mutable std::mutex mutex_;
  std::condition_variable left_;
  int working_ = 0;
  int waiting_ = 0;
};

}  // namespace slicefarm::rpc
