#pragma once

#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/shared/shared.h"
#include "common/stage/stage_call.h"
#include "processes/mill/model/mill_input.h"
#include "processes/mill/model/milled_program.h"

namespace slicefarm {

/// Stage that converts meshes to programs of a milling machine. Any ranges of a job's steps can be
/// computed separately. Assemble combines all results in one call.
class MillingStage {
 public:
  virtual ~MillingStage() = default;
  /// Divides a job into steps. Errors: the part cannot be milled with these settings; the error
  /// names the reason.
  virtual absl::StatusOr<MillLayout> LayOut(const StageCall& call,
                                            const Shared<MillInput>& input) const = 0;
  /// Returns the results of the steps in the range. Errors: REQUEST_MALFORMED for a range outside
  /// of the job.
  virtual absl::StatusOr<std::vector<MilledStep>> Mill(const StageCall& call,
                                                       const Shared<MillInput>& input,
                                                       StepRange range) const = 0;
  /// Combines the steps into a program. `steps`: all steps of the job. `settings_text`: effective
  /// settings, quoted at the end of the program.
  virtual absl::StatusOr<MilledProgram> Assemble(const StageCall& call,
                                                 const Shared<MillInput>& input,
                                                 std::vector<MilledStep> steps,
                                                 std::string_view settings_text) const = 0;
};

}  // namespace slicefarm
