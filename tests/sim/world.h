#pragma once

#include <fmt/format.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "tests/sim/event_queue.h"
#include "tests/sim/random.h"
#include "tests/sim/scenario.h"
#include "tests/sim/sim_blobs.h"
#include "tests/sim/totals.h"
#include "services/coordinator/store/jobs/job_changes.h"

namespace slicefarm::coordinator::sim {

/// What all parts of one simulation share: clock, chance, weather, and what is told of it.
struct World {
  World(uint64_t seed, Variant given) : random(seed), variant(std::move(given)) {}

  EventQueue events;
  Random random;
  const Variant variant;
  const Scenario scenario = MakeScenario(random);
  Totals totals;
  bool quiet = false;  ///< nothing goes wrong any more
  int64_t store_away_until_us = 0;
  int64_t disk_full_until_us = 0;
  int64_t slicing_away_until_us = 0;
  SimBlobs blobs;
  std::function<void(const JobChange&)> changed = [](const JobChange&) {};  ///< a job was written
  std::optional<std::string> violation;                                     ///< the first one
  std::function<void(const std::string& line)> trace = {};                  ///< empty: not wanted

  /// When it all begins, in microseconds since 1970.
  static constexpr int64_t kBeginUs = 1'000'000 * kSecondUs;
  /// The time on a clock that is right.
  int64_t wall_us() const { return kBeginUs + events.now_us(); }

  /// One step of what happens, for who reads along.
  template <typename... Args>
  void Tell(fmt::format_string<Args...> format, Args&&... args) {
    if (trace) trace(Stamp() + fmt::format(format, std::forward<Args>(args)...));
  }

  /// A promise was broken.
  template <typename... Args>
  void Violated(fmt::format_string<Args...> format, Args&&... args) {
    if (violation) return;
    violation = Stamp() + fmt::format(format, std::forward<Args>(args)...);
    if (trace) trace("VIOLATION " + *violation);
  }

  bool Happens(int permille) { return !quiet && permille > 0 && random.Chance(permille); }
  bool Until(int64_t until_us) const { return events.now_us() < until_us; }

 private:
  std::string Stamp() const { return fmt::format("{:10.6f} ", events.now_s()); }
};

}  // namespace slicefarm::coordinator::sim
