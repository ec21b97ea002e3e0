#include "tests/load/generator/algo/loop.h"

namespace slicefarm::load {
namespace {

/// Starts a request. The end of the request releases its slot. REQUIRES: a slot was entered.
void Begin(int64_t intended_ns, const LoopParts& parts) {
  parts.start([&clock = parts.clock, &slots = parts.slots, &log = parts.log,
               intended_ns](const Outcome& outcome) {
    log.Ended(intended_ns, clock.NowNs(), outcome);
    slots.Leave();
  });
  parts.log.Started(parts.clock.NowNs() - intended_ns);
}

}  // namespace

void RunOpenLoop(PoissonArrivals arrivals, int64_t duration_ns, const LoopParts& parts) {
  for (int64_t at = arrivals.NextNs(); at < duration_ns; at = arrivals.NextNs()) {
    parts.clock.AwaitNs(at);
    parts.log.Arrived();
    if (parts.slots.TryEnter()) {
      Begin(at, parts);
    } else {
      parts.log.Skipped();
    }
  }
  parts.slots.AwaitAllFree();
}

void RunClosedLoop(int64_t duration_ns, const LoopParts& parts) {
  for (;;) {
    parts.slots.Enter();
    const int64_t now = parts.clock.NowNs();
    if (now >= duration_ns) break;
    parts.log.Arrived();
    Begin(now, parts);
  }
  parts.slots.Leave();
  parts.slots.AwaitAllFree();
}

}  // namespace slicefarm::load
