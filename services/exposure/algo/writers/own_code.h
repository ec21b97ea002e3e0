#pragma once

#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "processes/laser/model/exposed_program.h"

namespace slicefarm {
struct ExposureOutput;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// G-code of the user's own around a layer's move in Z.
struct LayerCode {
  std::string before, after;
};

/// All of a job's, filled in. Each text is empty or ends a line.
struct OwnCode {
  std::string start;
  std::vector<LayerCode> layers;
  std::string end;
};

/// The output's templates, in the order of the file, so that global variables of one hold in those
/// after it. Errors: those of ParseTemplate and RunTemplate.
absl::StatusOr<OwnCode> FillIn(const ExposureOutput& output, const ExposureSummary& summary);

}  // namespace slicefarm::exposure
