#pragma once

#include <memory>
#include <string>

#include "tests/load/generator/algo/loop.h"
#include "tests/load/generator/client/farm.h"
#include "tests/load/generator/client/part_supply.h"

namespace slicefarm::load {

struct PrintOrder {
  PartPtr part;
  std::string request_id;
  v1::Process process = v1::PROCESS_FDM;
  int watchers = 1;      ///< streams that follow the job to its end
  bool download = true;  ///< the G-code, at the end
};

/// A job of one object, without settings.
v1::CreateJobRequest JobOf(const std::string& request_id, const std::string& mesh_sha256,
                           v1::Process process);

/// Upload, create, watch, download: each when the one before went well. A job that fails is an
/// error of the request. `done` is told the first error.
void StartPrint(Farm& farm, PrintOrder order, const CallContext& context, Done done);

/// An error of `step`.
Outcome OutcomeOf(absl::Status status, std::string step);

}  // namespace slicefarm::load
