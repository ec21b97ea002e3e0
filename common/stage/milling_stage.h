#pragma once

#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/shared/shared.h"
#include "common/stage/stage_call.h"
#include "processes/mill/model/mill_input.h"
#include "processes/mill/model/milled_program.h"

namespace slicefarm {

/// Stage that converts meshes to programs of a milling machine. Each range of a job's steps can be
/// computed on its own. Assemble combines all results in one call.
class MillingStage {
 public:
  virtual ~MillingStage() = default;
  /// Divides a job into steps. Returns an error with its reason if the part cannot be milled with
  /// these settings.
  virtual absl::StatusOr<MillLayout> LayOut(const StageCall& call,
                                            const Shared<MillInput>& input) const = 0;
  /// Computes the steps of the range. Errors: REQUEST_MALFORMED if the job does not have all steps
  /// of the range.
  virtual absl::StatusOr<std::vector<MilledStep>> Mill(const StageCall& call,
                                                       const Shared<MillInput>& input,
                                                       StepRange range) const = 0;
  /// Combines the steps into a program. `steps`: results of all steps of the job. `settings_text`:
  /// effective settings; the end of the program quotes them.
  virtual absl::StatusOr<MilledProgram> Assemble(const StageCall& call,
                                                 const Shared<MillInput>& input,
                                                 std::vector<MilledStep> steps,
                                                 std::string_view settings_text) const = 0;
};

}  // namespace slicefarm
