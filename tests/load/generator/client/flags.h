#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/model/process.h"
#include "common/rpc/client/client_security.h"
#include "tests/load/generator/client/run.h"
#include "tests/load/generator/client/scenario.h"

namespace CLI {
class App;
}

namespace slicefarm::load {

/// Options of the command line.
struct LoadFlags {
  std::string server = "127.0.0.1:50050";
  rpc::ClientSecurity security;
  std::string scenario = "print";
  std::string mix = "tiny";
  std::string process = std::string(ProcessName(kDefaultProcess));
  bool same = false;
  bool retry = false;
  std::vector<double> rates;
  int closed = 0;  ///< requests in flight of a closed loop; 0: open loop
  double seconds = 30;
  double deadline_s = 60;
  int in_flight = 512;
  int connections = 0;  ///< number of connections; 0: as many as the requests in flight need
  int watchers = 100;
  uint64_t seed = 0;  ///< seed of parts and arrivals; 0: a new seed each time
  std::string json;   ///< file for the report as JSON; empty: no such file
  std::string svg;

  /// Returns the options of the scenario.
  ScenarioOptions scenario_options() const;
  /// Returns the options of the runs: one per rate, ascending; or one for a closed loop.
  std::vector<RunOptions> runs() const;
  /// Returns the number of connections for the requests in flight.
  int needed_connections() const;
};

/// Adds the options to `app`.
void AddLoadFlags(CLI::App& app, LoadFlags* flags);

}  // namespace slicefarm::load
