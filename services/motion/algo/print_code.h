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
  std::string start;
  std::string start_filament;
  std::vector<std::string> between;  ///< filled-in between_objects_gcode, one per pass change
  /// `before_layer_gcode` and `layer_gcode` of each layer, if they depend on other layers;
  /// otherwise empty.
  std::vector<std::string> layers;
  std::string end;
  std::string file_name;  ///< `output_filename_format`, filled in without further changes
};

/// Fills in the templates in the order of the print, so that global variables and sums continue
/// from each template to the next. `time_s`: time of the print for templates. `silent_s`: time in
/// the machine's silent mode, if it has one. Errors: as RunTemplate.
absl::StatusOr<PrintCode> FillIn(const macro::JobCode& code, const ProgramSummary& summary,
                                 std::span<const PassChange> changes, const MotionOptions& options,
                                 double time_s, std::optional<double> silent_s = {});

}  // namespace slicefarm::motion
