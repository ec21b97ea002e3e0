#include "tests/load/generator/algo/loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace slicefarm::load::loop_test {
namespace {

constexpr int64_t kSecond = 1'000'000'000;

/// Clock that advances only if a thread waits for it, or if the test advances it.
class FakeClock final : public RunClock {
 public:
  int64_t NowNs() const override { return now_ns_; }
  void AwaitNs(int64_t instant_ns) override {
    now_ns_ = std::max(now_ns_, instant_ns);
    if (then_ && now_ns_ >= then_ns_) std::exchange(then_, nullptr)();
  }
  void Pass(int64_t ns) { now_ns_ += ns; }
  void OnReach(int64_t instant_ns, std::function<void()> then) {
    then_ns_ = instant_ns;
    then_ = std::move(then);
  }

 private:
  int64_t now_ns_ = 0;
  int64_t then_ns_ = 0;
  std::function<void()> then_;
};

std::vector<int64_t> Instants(double rate_rps, uint64_t seed, int64_t duration_ns) {
  PoissonArrivals arrivals(rate_rps, seed);
  std::vector<int64_t> instants;
  for (int64_t at = arrivals.NextNs(); at < duration_ns; at = arrivals.NextNs()) {
    instants.push_back(at);
  }
  return instants;
}

struct Fixture {
  explicit Fixture(int in_flight) : slots(in_flight) {}

  RunRecord Open(double rate_rps, uint64_t seed, int64_t duration_ns, const StartRequest& start) {
    RunOpenLoop(PoissonArrivals(rate_rps, seed), duration_ns, {clock, slots, log, start});
    return log.Take();
  }

  FakeClock clock;
  Slots slots;
  RunLog log;
};

TEST(OpenLoop, StartsEachArrivalAtItsInstant) {
  Fixture fixture(1);
  std::vector<int64_t> starts;
  const RunRecord record = fixture.Open(100, 3, 10 * kSecond, [&](const Done& done) {
    starts.push_back(fixture.clock.NowNs());
    done({});
  });
  EXPECT_EQ(starts, Instants(100, 3, 10 * kSecond));
  EXPECT_EQ(record.arrivals, static_cast<int64_t>(starts.size()));
  EXPECT_EQ(record.succeeded(), record.arrivals);
  EXPECT_EQ(record.latency.max_ns(), 0);
}

// A measurement from the actual start would show one slow request and many fast ones.
TEST(OpenLoop, AStandstillShowsInAllArrivalsMeanwhile) {
  Fixture fixture(1);
  const auto instants = Instants(100, 3, 10 * kSecond);
  constexpr size_t kStalls = 200;
  size_t started = 0;
  const RunRecord record = fixture.Open(100, 3, 10 * kSecond, [&](const Done& done) {
    if (started++ == kStalls) fixture.clock.Pass(3 * kSecond);
    done({});
  });
  const int64_t back = instants[kStalls] + 3 * kSecond;
  ASSERT_EQ(record.samples.size(), instants.size());
  for (size_t i = 0; i < instants.size(); ++i) {
    const bool meanwhile = i >= kStalls && instants[i] < back;
    EXPECT_EQ(record.samples[i].intended_ns, instants[i]);
    EXPECT_EQ(record.samples[i].latency_ns, meanwhile ? back - instants[i] : 0) << i;
  }
  // The server stalls for three of ten seconds: this affects more than a quarter of all requests,
  // not one of a thousand.
  EXPECT_GT(record.latency.PercentileNs(75), 0);
  EXPECT_GT(record.latency.PercentileNs(90), kSecond);
  EXPECT_GT(record.start_lag.PercentileNs(90), kSecond);
}

TEST(OpenLoop, ArrivalsBeyondTheSlotsAreSkippedAndCounted) {
  Fixture fixture(3);
  std::vector<Done> open;
  const auto instants = Instants(100, 3, 10 * kSecond);
  // The first three requests end when many more were due; the later ones end at once.
  fixture.clock.OnReach(instants[500], [&] {
    for (const Done& end : open) end({});
  });
  const RunRecord record = fixture.Open(100, 3, 10 * kSecond, [&](Done done) {
    if (open.size() == 3) return done({});
    open.push_back(std::move(done));
  });
  EXPECT_EQ(record.arrivals, static_cast<int64_t>(instants.size()));
  EXPECT_EQ(record.skipped, 500 - 3);
  EXPECT_EQ(record.latency.count(), record.arrivals - record.skipped);
  EXPECT_EQ(record.latency.max_ns(), instants[500] - instants[0]);
}

TEST(OpenLoop, ErrorsCountWithTheirLatency) {
  Fixture fixture(1);
  const RunRecord record = fixture.Open(100, 3, kSecond, [&](const Done& done) {
    fixture.clock.Pass(1000);
    done({.status = absl::UnavailableError("gone"), .step = "GetJob"});
  });
  EXPECT_EQ(record.succeeded(), 0);
  EXPECT_EQ(record.latency.count(), record.arrivals);
  EXPECT_GE(record.latency.min_ns(), 1000);
}

TEST(ClosedLoop, StartsTheNextWhenOneHasEnded) {
  Fixture fixture(4);
  const StartRequest start = [&](const Done& done) {
    fixture.clock.Pass(kSecond / 10);
    done({});
  };
  RunClosedLoop(10 * kSecond, {fixture.clock, fixture.slots, fixture.log, start});
  const RunRecord record = fixture.log.Take();
  EXPECT_EQ(record.arrivals, 100);
  EXPECT_EQ(record.succeeded(), 100);
  EXPECT_EQ(record.skipped, 0);
  EXPECT_EQ(record.latency.max_ns(), kSecond / 10);
}

TEST(ClosedLoop, KeepsAllSlotsBusy) {
  Fixture fixture(4);
  std::vector<Done> open;
  size_t most = 0;
  const StartRequest start = [&](Done done) {
    open.push_back(std::move(done));
    most = std::max(most, open.size());
    fixture.clock.Pass(kSecond);
    if (open.size() < 4) return;
    for (const Done& end : std::exchange(open, {})) end({});
  };
  RunClosedLoop(8 * kSecond, {fixture.clock, fixture.slots, fixture.log, start});
  EXPECT_EQ(most, 4u);
  EXPECT_EQ(fixture.log.Take().succeeded(), 8);
}

}  // namespace
}  // namespace slicefarm::load::loop_test
