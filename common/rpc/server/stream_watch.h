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

/// Time limits and minimum rate of streams.
struct StreamTimes {
  std::chrono::milliseconds idle{60'000};  ///< maximum time without a message
  /// Minimum average rate of a stream. The delay of a stream grows with time. Each message reduces
  /// the delay, but not below 0, by the time that its bytes need at this rate. The stream is cut
  /// when its delay reaches `idle`.
  int64_t min_bytes_per_s = 4096;
  /// Deadline of calls for which the client has set none.
  std::chrono::milliseconds default_deadline{300'000};
};

/// Cuts streams of clients that neither send nor read, or that are too slow. While a handler of
/// gRPC's synchronous API waits for the next message, it occupies a thread and cannot check the
/// time. A few hundred slow clients would occupy all threads of a server. Thread-safe; must outlive
/// its guards.
class StreamWatch {
 private:
  using Clock = std::chrono::steady_clock;
  struct Entry {
    Entry(grpc::ServerContext& call, Clock::time_point last, Clock::time_point first_due)
        : context(call), deadline(last), due(first_due) {}

    grpc::ServerContext& context;
    const Clock::time_point deadline;
    /// Time at which the stream is cut. Each message postpones this time in proportion to its
    /// bytes.
    std::atomic<Clock::time_point> due;
    bool cut = false;
  };

 public:
  explicit StreamWatch(const StreamTimes& times);
  ~StreamWatch();
  StreamWatch(const StreamWatch&) = delete;
  StreamWatch& operator=(const StreamWatch&) = delete;

  /// Watches a call as long as its handler runs.
  class Guard {
   public:
    Guard(StreamWatch& watch, grpc::ServerContext& context);
    ~Guard();
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;

    /// Reports a transferred message of `bytes` bytes. For one thread at a time.
    void Moved(int64_t bytes);

    /// Returns DeadlineExceeded if the call was cut, otherwise `status`.
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
