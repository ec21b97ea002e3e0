#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "processes/laser/model/exposed_program.h"

namespace slicefarm {
struct ExposureOutput;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// The user's own G-code before and after the move in Z at the start of a layer.
struct LayerCode {
  std::string before, after;
};

/// All custom G-code of a job, with filled-in templates. Each text is empty or ends with a line
/// break.
struct CustomLaserCode {
  std::string start;
  std::vector<LayerCode> layers;
  std::string end;
};

/// Fills in the output's templates in the order of the file. A global variable that one template
/// sets is valid in later templates. Errors: any error of ParseTemplate and RunTemplate.
absl::StatusOr<CustomLaserCode> FillIn(const ExposureOutput& output,
                                       const ExposureSummary& summary);

}  // namespace slicefarm::exposure
