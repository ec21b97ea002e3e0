#include "tests/load/generator/client/run.h"

#include <sys/resource.h>

#include <thread>

namespace slicefarm::load {
namespace {

using std::chrono::nanoseconds;
using std::chrono::steady_clock;
using std::chrono::system_clock;

class SteadyRunClock final : public RunClock {
 public:
  int64_t NowNs() const override { return nanoseconds(steady_clock::now() - begin_).count(); }
  void AwaitNs(int64_t instant_ns) override {
    std::this_thread::sleep_until(begin_ + nanoseconds(instant_ns));
  }

 private:
  const steady_clock::time_point begin_ = steady_clock::now();
};

rusage Usage() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return usage;
}

double CpuSeconds(const rusage& usage) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

int64_t Nanoseconds(std::chrono::duration<double> duration) {
  return std::chrono::duration_cast<nanoseconds>(duration).count();
}

RunRecord RunLoop(const RunOptions& options, Scenario& scenario) {
  RunLog log;
  const StartRequest start = [&](Done done) {
    const auto deadline =
        system_clock::now() + std::chrono::duration_cast<system_clock::duration>(options.deadline);
    scenario.Start({.deadline = deadline, .retry = options.retry, .log = &log}, std::move(done));
  };
  Slots slots(options.in_flight);
  SteadyRunClock clock;
  const LoopParts parts = {.clock = clock, .slots = slots, .log = log, .start = start};
  if (options.rate_rps > 0) {
    RunOpenLoop(PoissonArrivals(options.rate_rps, options.seed), Nanoseconds(options.duration),
                parts);
  } else {
    RunClosedLoop(Nanoseconds(options.duration), parts);
  }
  return log.Take();
}

}  // namespace

RunReport Run(const RunOptions& options, Scenario& scenario) {
  RunReport report;
  report.retry = options.retry;
  report.intended_rps = options.rate_rps;
  report.in_flight = options.in_flight;
  report.seconds = options.duration.count();
  report.deadline_s = options.deadline.count();
  report.begin_us =
      std::chrono::duration_cast<std::chrono::microseconds>(system_clock::now().time_since_epoch())
          .count();
  const rusage before = Usage();
  report.record = RunLoop(options, scenario);
  const rusage after = Usage();
  constexpr int64_t kKib = 1024;
  report.cpu_s = CpuSeconds(after) - CpuSeconds(before);
  report.rss_bytes = after.ru_maxrss * kKib;
  return report;
}

}  // namespace slicefarm::load
