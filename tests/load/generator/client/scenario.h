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

enum class ScenarioKind {
  kPrint,   ///< upload a part, create its job, watch it to its end, download the G-code
  kSubmit,  ///< create a job of a mesh that is there: the durable acknowledgement alone
  kGet,     ///< get a job
  kWatch,   ///< upload a part, create its job, watch it to its end many times at once
};

struct ScenarioOptions {
  ScenarioKind kind = ScenarioKind::kPrint;
  PartSupplyOptions parts = {};
  int watchers = 1;                                    ///< of each job, for kWatch
  std::vector<Process> processes = {kDefaultProcess};  ///< of the jobs, by turns
};

/// A kind of request. Outlives its requests.
class Scenario {
 public:
  virtual ~Scenario() = default;

  /// Makes what the requests find there, and waits for it. Errors: those of the calls.
  virtual absl::Status Prepare(const CallContext& context) = 0;

  /// Starts a request; for one caller at a time. `done` is called once.
  virtual void Start(const CallContext& context, Done done) = 0;
};

std::unique_ptr<Scenario> MakeScenario(const ScenarioOptions& options, Farm& farm);

}  // namespace slicefarm::load
