#pragma once

#include <grpcpp/server_context.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <list>
#include <mutex>
#include <thread>

#include "absl/status/status.h"

namespace slicefarm::rpc {

struct StreamTimes {
  std::chrono::milliseconds idle{60'000};               ///< without a message moving
  std::chrono::milliseconds default_deadline{300'000};  ///< where the client sent none
};

/// Cuts off streams whose client does nothing. A handler of the synchronous API that waits for a
/// client's next message holds a thread and cannot ask about the time meanwhile; a few hundred of
/// them would take all threads of a server. Thread-safe; must outlive its guards.
class StreamWatch {
 private:
  using Clock = std::chrono::steady_clock;
  struct Entry {
    Entry(grpc::ServerContext& call, Clock::time_point last, Clock::time_point idle)
        : context(call), deadline(last), idle_end(idle) {}

    grpc::ServerContext& context;
    const Clock::time_point deadline;
    std::atomic<Clock::time_point> idle_end;  ///< put off by each message
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

    /// A message went through.
    void Moved();

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
