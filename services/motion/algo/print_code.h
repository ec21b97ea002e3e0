#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/macro/job_code.h"
#include "common/model/layers/program_summary.h"
#include "services/motion/algo/pass_change.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// A job's templates, filled in.
struct PrintCode {
  std::string start;
  std::string start_filament;
  std::vector<std::string> between;  ///< between_objects_gcode, by pass change
  /// before_layer_gcode and layer_gcode of each layer if they wait for the others; or none.
  std::vector<std::string> layers;
  std::string end;
  std::string file_name;  ///< output_filename_format, as it stands there
};

/// Fills them in, in the order of the print, so that global variables and sums go on from each to
/// the next. `time_s`: of the print, as they name it; `silent_s`: in the machine's silent mode, if
/// it has one. Errors: those of RunTemplate.
absl::StatusOr<PrintCode> FillIn(const macro::JobCode& code, const ProgramSummary& summary,
                                 std::span<const PassChange> changes, const MotionOptions& options,
                                 double time_s, std::optional<double> silent_s = {});

}  // namespace slicefarm::motion
