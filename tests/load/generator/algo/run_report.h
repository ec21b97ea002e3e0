#pragma once

#include <cstdint>
#include <string>

#include "tests/load/generator/algo/run_log.h"

namespace slicefarm::load {

/// Report of one run: its options, its results, and its cost for the generator.
struct RunReport {
  std::string scenario;
  std::string server;
  std::string build_id;  ///< build of the generator
  std::string mix;
  std::string process = {};  ///< process of the jobs, or "both"
  /// True if all requests use one part, so that the server's cache may answer.
  bool same = false;
  bool retry = false;       ///< true if refused calls were repeated when the server allowed it
  double intended_rps = 0;  ///< intended rate of an open loop; 0: closed loop
  int in_flight = 0;        ///< largest number of requests in flight
  int connections = 0;
  double seconds = 0;     ///< time during which requests were started
  double deadline_s = 0;  ///< deadline of each request
  uint64_t seed = 0;
  int64_t begin_us = 0;  ///< since 1970
  RunRecord record;
  double cpu_s = 0;       ///< CPU time of the generator during the run
  int64_t rss_bytes = 0;  ///< largest resident memory of the generator up to the end of the run

  /// Returns true for an open loop.
  bool open_loop() const { return intended_rps > 0; }

  /// Returns the time from the beginning of the run to the end of its last request; at least
  /// `seconds`.
  double TotalSeconds() const;
  /// Returns the successful requests per second of TotalSeconds.
  double AchievedRps() const;
};

}  // namespace slicefarm::load
