#pragma once

#include <cstdint>
#include <string>

#include "tests/load/generator/algo/run_log.h"

namespace slicefarm::load {

/// One run: what was asked for, what happened, what it cost the generator.
struct RunReport {
  std::string scenario;
  std::string server;
  std::string build_id;  ///< of the generator
  std::string mix;
  std::string process = {};  ///< of the jobs: a name, or "both"
  bool same = false;         ///< one part for all requests, which the server's cache may answer
  bool retry = false;        ///< refused calls came again when the server said so
  double intended_rps = 0;   ///< 0: closed loop
  int in_flight = 0;         ///< how many requests there may be at once
  int connections = 0;
  double seconds = 0;     ///< during which requests were started
  double deadline_s = 0;  ///< of each request
  uint64_t seed = 0;
  int64_t begin_us = 0;  ///< since 1970
  RunRecord record;
  double cpu_s = 0;       ///< of the generator's process, during the run
  int64_t rss_bytes = 0;  ///< the most that it held resident until the run's end

  bool open_loop() const { return intended_rps > 0; }

  /// From the beginning to the end of the last request, and at least `seconds`.
  double TotalSeconds() const;
  /// Requests that ended well, per second of TotalSeconds.
  double AchievedRps() const;
};

}  // namespace slicefarm::load
