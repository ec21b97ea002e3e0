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

/// Filled-in templates of a job.
struct PrintCode {
  std::string file_start;
  std::string start;
  std::string start_filament;
  std::vector<std::string> between;  ///< filled-in between_objects_gcode, one per pass change
  /// `before_layer_gcode` and `layer_gcode` of each layer, two texts per layer. Empty if these
  /// templates do not depend on other layers: LayerProgram then already contains them.
  std::vector<std::string> layers;
  std::string end;
  /// filled-in `output_filename_format`; not yet made a valid file name (file_name.h)
  std::string file_name;
};

/// Fills in the templates in the order of the print. Global variables and sums keep their values
/// from one template to the next. `time_s`: time of the whole print. `silent_s`: time in the
/// machine's silent mode, if it has one. Errors: as RunTemplate.
absl::StatusOr<PrintCode> FillIn(const macro::JobCode& code, const ProgramSummary& summary,
                                 std::span<const PassChange> changes, const MotionOptions& options,
                                 double time_s, std::optional<double> silent_s = {});

}  // namespace slicefarm::motion
