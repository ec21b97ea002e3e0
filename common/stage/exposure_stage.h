#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/base/shared/shared.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "common/stage/neighbourhood.h"
#include "common/stage/stage_call.h"
#include "processes/laser/model/exposed_program.h"

namespace slicefarm {

struct ExposureJob;
struct ExposureSettings;

/// Stage that converts layers to exposure vectors and to programs for the machine. An exposure
/// process has no other stage that works layer by layer.
class ExposureStage {
 public:
  virtual ~ExposureStage() = default;
  /// Returns a program for each layer of the range.
  virtual absl::StatusOr<std::vector<ExposedProgram>> Expose(
      const StageCall& call, const Neighbourhood& neighbourhood,
      const Shared<ExposureJob>& job) const = 0;
  virtual absl::StatusOr<ExposureEnvelope> Envelope(const StageCall& call,
                                                    const ExposureSummary& summary,
                                                    const ExposureSettings& settings) const = 0;
};

}  // namespace slicefarm
