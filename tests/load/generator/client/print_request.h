#pragma once

#include <memory>
#include <string>

#include "tests/load/generator/algo/loop.h"
#include "tests/load/generator/client/farm.h"
#include "tests/load/generator/client/part_supply.h"

namespace slicefarm::load {

/// Part to print, and the calls to make.
struct PrintOrder {
  PartPtr part;
  std::string request_id;
  v1::Process process = v1::PROCESS_FDM;
  int watchers = 1;      ///< number of streams that watch the job to its end
  bool download = true;  ///< true if the G-code is downloaded at the end
};

/// Returns a request for a job of one object without settings.
v1::CreateJobRequest JobOf(const std::string& request_id, const std::string& mesh_sha256,
                           v1::Process process);

/// Makes all calls for a print: uploads the part, creates a job, watches the job and downloads the
/// G-code. Each call begins when the previous one has succeeded. A failed job is an error of the
/// request. Calls `done` with the first error, or with success at the end.
void StartPrint(Farm& farm, PrintOrder order, const CallContext& context, Done done);

/// Returns the outcome of a request that ended with `status` in `step`.
Outcome OutcomeOf(absl::Status status, std::string step);

}  // namespace slicefarm::load
