#pragma once

#include <cstdint>
#include <functional>

#include "tests/load/generator/algo/poisson_arrivals.h"
#include "tests/load/generator/algo/run_log.h"
#include "tests/load/generator/algo/slots.h"

namespace slicefarm::load {

/// The time of a run, from its beginning. Thread-safe.
class RunClock {
 public:
  virtual ~RunClock() = default;
  virtual int64_t NowNs() const = 0;
  virtual void AwaitNs(int64_t instant_ns) = 0;
};

using Done = std::function<void(const Outcome&)>;
/// Starts a request and returns; `done` is called once, from any thread, when it has ended.
using StartRequest = std::function<void(Done)>;

/// What a loop works with. Everything outlives it.
struct LoopParts {
  RunClock& clock;
  Slots& slots;
  RunLog& log;
  const StartRequest& start;
};

/// Open loop: starts a request at each arrival before `duration_ns`, whatever became of those
/// before, and counts its latency from that instant, not from when it got to start. So a server
/// that stands still shows in all requests that were to start meanwhile. An arrival for which no
/// slot is free is skipped and counted. Returns when all requests have ended.
void RunOpenLoop(PoissonArrivals arrivals, int64_t duration_ns, const LoopParts& parts);

/// Closed loop: keeps all slots busy for `duration_ns`, each with the next request as soon as one
/// has ended. Shows how much goes through, and hides what a client would wait. Returns when all
/// requests have ended.
void RunClosedLoop(int64_t duration_ns, const LoopParts& parts);

}  // namespace slicefarm::load
