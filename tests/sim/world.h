#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "services/coordinator/store/jobs/job_changes.h"
#include "tests/sim/event_queue.h"
#include "tests/sim/random.h"
#include "tests/sim/scenario.h"
#include "tests/sim/sim_blobs.h"
#include "tests/sim/totals.h"

namespace slicefarm::coordinator::sim {

/// State that all parts of a simulation share: clock, random numbers, faults, and the trace.
struct World {
  World(uint64_t seed, Variant given) : random(seed), variant(std::move(given)) {}

  EventQueue events;
  Random random;
  const Variant variant;
  const Scenario scenario = MakeScenario(random);
  Totals totals;
  bool quiet = false;  ///< true from the time on at which no more faults happen
  int64_t store_away_until_us = 0;
  int64_t disk_full_until_us = 0;
  int64_t slicing_away_until_us = 0;
  SimBlobs blobs;
  /// Called after each write of a job to the store.
  std::function<void(const JobChange&)> changed = [](const JobChange&) {};
  std::optional<std::string> violation;                     ///< first violated rule of the farm
  std::function<void(const std::string& line)> trace = {};  ///< empty if no trace is requested

  /// Start of the simulation, in microseconds since 1970.
  static constexpr int64_t kBeginUs = 1'000'000 * kSecondUs;
  /// Returns the time of a correct clock.
  int64_t wall_us() const { return kBeginUs + events.now_us(); }

  /// Writes a step to the trace.
  template <typename... Args>
  void Log(fmt::format_string<Args...> format, Args&&... args) {
    if (trace) trace(Stamp() + fmt::format(format, std::forward<Args>(args)...));
  }

  /// Records that a rule of the farm was violated, unless `violation` already has an earlier one.
  template <typename... Args>
  void Violated(fmt::format_string<Args...> format, Args&&... args) {
    if (violation) return;
    violation = Stamp() + fmt::format(format, std::forward<Args>(args)...);
    if (trace) trace("VIOLATION " + *violation);
  }

  /// Returns true with a probability of `permille` / 1000. Returns false when no more faults
  /// happen.
  bool Happens(int permille) { return !quiet && permille > 0 && random.Chance(permille); }
  /// Returns true if the current time is before `until_us`.
  bool Until(int64_t until_us) const { return events.now_us() < until_us; }

 private:
  std::string Stamp() const { return fmt::format("{:10.6f} ", events.now_s()); }
};

}  // namespace slicefarm::coordinator::sim
