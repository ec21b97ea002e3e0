#pragma once

#include <cstdint>
#include <functional>

#include "tests/load/generator/algo/poisson_arrivals.h"
#include "tests/load/generator/algo/run_log.h"
#include "tests/load/generator/algo/slots.h"

namespace slicefarm::load {

/// Clock of a run, in ns since the run began. Thread-safe.
class RunClock {
 public:
  virtual ~RunClock() = default;
  /// Returns the current time.
  virtual int64_t NowNs() const = 0;
  /// Waits until NowNs() is at least `instant_ns`.
  virtual void AwaitNs(int64_t instant_ns) = 0;
};

using Done = std::function<void(const Outcome&)>;
/// Function that starts a request and returns. It calls `done` once, from any thread, when the
/// request has ended.
using StartRequest = std::function<void(Done)>;

/// Objects that a loop uses. All of them must outlive it.
struct LoopParts {
  RunClock& clock;
  Slots& slots;
  RunLog& log;
  const StartRequest& start;
};

/// Open loop: starts a request at each arrival before `duration_ns`, even if earlier requests have
/// not ended. The latency counts from the time of the arrival, not from the actual start. So a
/// server that stalls affects all requests that were to start meanwhile. An arrival without a free
/// slot is skipped and counted. Returns when all requests have ended.
void RunOpenLoop(PoissonArrivals arrivals, int64_t duration_ns, const LoopParts& parts);

/// Closed loop: keeps all slots busy for `duration_ns`. Each slot starts the next request as soon
/// as one has ended. It measures the throughput but hides the waiting times of real clients.
/// Returns when all requests have ended.
void RunClosedLoop(int64_t duration_ns, const LoopParts& parts);

}  // namespace slicefarm::load
