#include "tests/load/generator/algo/report_table.h"

#include <fmt/format.h>

namespace slicefarm::load {
namespace {

/// Lag above which the results are doubtful, because the generator measures its own delay.
constexpr double kDoubtfulLagMs = 10;

constexpr char kRow[] = "{:>8} {:>8} {:>8} {:>7} {:>7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>7} {:>6}\n";

double Ms(int64_t ns) { return static_cast<double>(ns) / 1e6; }

std::string PercentileMs(const LatencyHistogram& latency, double percent) {
  return fmt::format("{:.2f}", Ms(latency.PercentileNs(percent)));
}

}  // namespace

std::string TableHeader() {
  return fmt::format(kRow, "rate/s", "ended/s", "ok", "failed", "skipped", "p50 ms", "p90 ms",
                     "p99 ms", "p99.9 ms", "max ms", "lag p99", "cpu s");
}

std::string TableRow(const RunReport& run) {
  const RunRecord& record = run.record;
  std::string text = fmt::format(
      kRow, run.open_loop() ? fmt::format("{:g}", run.intended_rps) : "closed",
      fmt::format("{:.2f}", run.AchievedRps()), record.succeeded(),
      record.latency.count() - record.succeeded(), record.skipped, PercentileMs(record.latency, 50),
      PercentileMs(record.latency, 90), PercentileMs(record.latency, 99),
      PercentileMs(record.latency, 99.9), PercentileMs(record.latency, 100),
      PercentileMs(record.start_lag, 99), fmt::format("{:.1f}", run.cpu_s));
  for (const auto& [error, count] : record.errors) {
    text += fmt::format("{:>8} x {}\n", count, error);
  }
  if (Ms(record.start_lag.PercentileNs(99)) > kDoubtfulLagMs) {
    text += "         the generator started requests late: part of the latency is its own\n";
  }
  return text;
}

}  // namespace slicefarm::load
