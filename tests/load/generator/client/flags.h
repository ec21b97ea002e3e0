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

/// The command line.
struct LoadFlags {
  std::string server = "127.0.0.1:50050";
  rpc::ClientSecurity security;
  std::string scenario = "print";
  std::string mix = "tiny";
  std::string process = std::string(ProcessName(kDefaultProcess));
  bool same = false;
  bool retry = false;
  std::vector<double> rates;
  int closed = 0;  ///< 0: open loop
  double seconds = 30;
  double deadline_s = 60;
  int in_flight = 512;
  int connections = 0;  ///< 0: as many as are needed
  int watchers = 100;
  uint64_t seed = 0;  ///< 0: another one each time
  std::string json;   ///< empty: none
  std::string svg;

  ScenarioOptions scenario_options() const;
  /// One for each rate, ascending; one for a closed loop.
  std::vector<RunOptions> runs() const;
  int needed_connections() const;
};

void AddLoadFlags(CLI::App& app, LoadFlags* flags);

}  // namespace slicefarm::load
