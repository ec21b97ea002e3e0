#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "processes/laser/model/exposed_program.h"

namespace slicefarm {
struct ExposureOutput;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// The user's own G-code around a layer's move in Z.
struct LayerCode {
  std::string before, after;
};

/// All of a job's own G-code, with filled templates. Each text is empty or ends with a line break.
struct CustomLaserCode {
  std::string start;
  std::vector<LayerCode> layers;
  std::string end;
};

/// Fills the output's templates in the order of the file, so that a global variable of one template
/// is valid in later ones. Errors: any error of ParseTemplate and RunTemplate.
absl::StatusOr<CustomLaserCode> FillIn(const ExposureOutput& output,
                                       const ExposureSummary& summary);

}  // namespace slicefarm::exposure
