#pragma once

#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/shared/shared.h"
#include "common/stage/stage_call.h"
#include "processes/mill/model/mill_input.h"
#include "processes/mill/model/milled_program.h"

namespace slicefarm {

/// Meshes to programs of a milling machine. Any ranges of a job's steps can be made apart; their
/// results are put together at once.
class MillingStage {
 public:
  virtual ~MillingStage() = default;
  /// Errors: the reason why the part cannot be milled with these settings.
  virtual absl::StatusOr<MillLayout> LayOut(const StageCall& call,
                                            const Shared<MillInput>& input) const = 0;
  /// Returns the results of the steps in the range. REQUEST_MALFORMED for a range outside of the
  /// job.
  virtual absl::StatusOr<std::vector<MilledStep>> Mill(const StageCall& call,
                                                       const Shared<MillInput>& input,
                                                       StepRange range) const = 0;
  /// `steps`: all of the job's. `settings_text`: effective settings, quoted at the program's end.
  virtual absl::StatusOr<MilledProgram> Assemble(const StageCall& call,
                                                 const Shared<MillInput>& input,
                                                 std::vector<MilledStep> steps,
                                                 std::string_view settings_text) const = 0;
};

}  // namespace slicefarm
