#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "absl/status/status.h"
#include "common/model/process.h"
#include "tests/load/generator/algo/loop.h"
#include "tests/load/generator/client/farm.h"
#include "tests/load/generator/client/part_supply.h"

namespace slicefarm::load {

/// Kinds of requests.
enum class ScenarioKind {
  kPrint,  ///< upload a part, create its job, watch it to its end, download the G-code
  /// create a job of an uploaded mesh; measures only the time until the farm has stored and
  /// confirmed the job
  kSubmit,
  kGet,    ///< get a job
  kWatch,  ///< upload a part, create its job, watch it to its end with many streams at once
};

/// Options of a scenario.
struct ScenarioOptions {
  ScenarioKind kind = ScenarioKind::kPrint;
  PartSupplyOptions parts = {};
  int watchers = 1;                                    ///< watchers of each job, for kWatch
  std::vector<Process> processes = {kDefaultProcess};  ///< processes that the jobs use alternately
};

/// Kind of request. It must outlive its requests.
class Scenario {
 public:
  virtual ~Scenario() = default;

  /// Creates the data that the requests need, and waits until the farm has the data. Errors: errors
  /// of the calls.
  virtual absl::Status Prepare(const CallContext& context) = 0;

  /// Starts a request. Only one thread at a time may call it. Calls `done` once.
  virtual void Start(const CallContext& context, Done done) = 0;
};

/// Returns the scenario of a kind.
std::unique_ptr<Scenario> MakeScenario(const ScenarioOptions& options, Farm& farm);

}  // namespace slicefarm::load
