// slicefarm-sim: simulates the scheduler and the jobs on a simulated clock, with faults that follow
// from seeds. Prints `key value` rows. The exit code is 1 at the first seed that breaks a promise.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>

#include "services/coordinator/store/jobs/sql_job_store.h"
#include "tests/sim/simulation.h"
#include "tests/sim/twin_store.h"

namespace slicefarm::coordinator::sim {
namespace {

void Print(int64_t seeds, const Totals& totals, bool violated) {
  std::cout << "seeds " << seeds << "\nviolations " << (violated ? 1 : 0) << "\n";
  for (const TotalsField& field : kTotals) {
    std::cout << field.name << " " << totals.*field.value << "\n";
  }
}

/// Runs the seeds from `first` on, up to the first seed that breaks a promise. `options`:
/// command-line options that a replay needs.
int Run(uint64_t first, int64_t seeds, const Variant& variant, bool trace,
        const std::string& options) {
  std::function<void(const std::string&)> tell;
  if (trace) tell = [](const std::string& line) { std::cout << line << "\n"; };
  Totals totals;
  for (int64_t i = 0; i < seeds; ++i) {
    const uint64_t seed = first + static_cast<uint64_t>(i);
    const Outcome outcome = Simulate(seed, variant, tell);
    for (const TotalsField& field : kTotals) totals.*field.value += outcome.totals.*field.value;
    if (!outcome.violation) continue;
    Print(i + 1, totals, /*violated=*/true);
    std::cout << "failing_seed " << seed << "\n"
              << "violation " << *outcome.violation << "\n"
              << "replay slicefarm-sim --seed " << seed << " --trace" << options << "\n";
    return 1;
  }
  Print(seeds, totals, /*violated=*/false);
  return 0;
}

/// Returns a variant with a SQLite store in `directory` beside the store in memory. Each seed gets
/// a new store.
Variant BesideSqlite(const std::filesystem::path& directory) {
  Variant variant;
  variant.store = [directory](World& world, JobStore& store) -> std::unique_ptr<JobStore> {
    for (const char* name : {"jobs.db", "jobs.db-wal", "jobs.db-shm"}) {
      std::filesystem::remove(directory / name);
    }
    auto sqlite = OpenSqliteJobStore(directory / "jobs.db");
    if (!sqlite.ok()) {
      world.Violated("SQLite store failed: {}", sqlite.status().ToString());
      return nullptr;
    }
    return std::make_unique<TwinStore>(world, store, *std::move(sqlite));
  };
  return variant;
}

}  // namespace
}  // namespace slicefarm::coordinator::sim

int main(int argc, char** argv) {
  using namespace slicefarm::coordinator::sim;
  CLI::App app("Simulate the coordinator's scheduler and job states under faults");
  int64_t seeds = 1000;
  uint64_t seed = 0;
  bool trace = false;
  std::string sqlite;
  auto* count = app.add_option("--seeds", seeds, "Number of seeds to run: 1 to N")
                    ->check(CLI::PositiveNumber);
  auto* one = app.add_option("--seed", seed, "Single seed to run")->excludes(count);
  app.add_flag("--trace", trace, "Print the events of the simulation")->needs(one);
  app.add_option("--sqlite", sqlite, "Directory in which a SQLite store is checked as well")
      ->check(CLI::ExistingDirectory);
  CLI11_PARSE(app, argc, argv);
  const Variant variant = sqlite.empty() ? Variant() : BesideSqlite(sqlite);
  const std::string options = sqlite.empty() ? "" : " --sqlite " + sqlite;
  return *one ? Run(seed, 1, variant, trace, options) : Run(1, seeds, variant, trace, options);
}
