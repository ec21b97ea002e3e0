#pragma once

#include <grpcpp/server_context.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <list>
#include <mutex>
#include <thread>

#include "absl/status/status.h"

namespace slicefarm::rpc {

struct StreamTimes {
  std::chrono::milliseconds idle{60'000};  ///< without a message moving
  /// In the long run: a stream that stays below it falls behind by `idle`, and ends.
  int64_t min_bytes_per_s = 4096;
  std::chrono::milliseconds default_deadline{300'000};  ///< where the client sent none
};

/// Cuts off streams whose client does nothing, or next to nothing. A handler of the synchronous API
/// that waits for a client's next message holds a thread and cannot ask about the time meanwhile; a
/// few hundred of them would take all threads of a server. Thread-safe; must outlive its guards.
class StreamWatch {
 private:
  using Clock = std::chrono::steady_clock;
  struct Entry {
    Entry(grpc::ServerContext& call, Clock::time_point last, Clock::time_point first_due)
        : context(call), deadline(last), due(first_due) {}

    grpc::ServerContext& context;
    const Clock::time_point deadline;
    std::atomic<Clock::time_point> due;  ///< put off by each message, as far as its bytes go
    bool cut = false;
  };

 public:
  explicit StreamWatch(const StreamTimes& times);
  ~StreamWatch();
  StreamWatch(const StreamWatch&) = delete;
  StreamWatch& operator=(const StreamWatch&) = delete;

  /// Watches over a call as long as its handler runs.
  class Guard {
   public:
    Guard(StreamWatch& watch, grpc::ServerContext& context);
    ~Guard();
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;

    /// A message of so many bytes went through. From one thread at a time.
    void Moved(int64_t bytes);

    /// DeadlineExceeded if the call was cut off, else `status`.
    absl::Status Outcome(absl::Status status) const;

   private:
    StreamWatch& watch_;
    std::list<Entry>::iterator entry_;
  };

 private:
  void Run();
  Clock::time_point CutWhatIsDue();

  const StreamTimes times_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::list<Entry> entries_;
  bool stopping_ = false;
  std::thread thread_;
};

}  // namespace slicefarm::rpc
