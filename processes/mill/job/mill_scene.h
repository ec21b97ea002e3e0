#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/options/slicing_options.h"
#include "common/model/scene/placed_scene.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"
#include "processes/mill/model/mill_input.h"

namespace slicefarm::coordinator {

/// Input of the placing stage, which runs once for the parts and once for the stock.
struct PlacingInput {
  SliceInput meshes;
  SlicingOptions options;
};

/// Inputs for placing the parts and the stock.
struct PartsAndStock {
  PlacingInput parts;
  std::optional<PlacingInput> stock;  ///< input for placing the stock; none: the stock is a box
};

/// Separates the object that is the stock from the objects of a job. Errors: SETTING_MALFORMED,
/// with `setting`, if no object or several objects have the name `stock`; NOTHING_TO_PRINT if the
/// stock is the only object.
absl::StatusOr<PartsAndStock> TakeStock(PlacingInput job, std::string_view stock);

/// Centres the stock on the parts, unless the job has a position for the stock.
void PutAround(const PlacedScene& parts, PlacingInput& stock);

/// Meshes of a milling job, with reports and warnings.
struct MillScene {
  MillInput input;
  std::vector<MeshReport> meshes;     ///< reports in program coordinates
  std::vector<std::string> warnings;  ///< warnings about input without effect
};

/// Returns one mesh of all copies of all solid parts, and the mesh of the stock, in program
/// coordinates. Errors: REQUEST_MALFORMED for negative parts, because meshes cannot be subtracted;
/// OUT_OF_RANGE.
absl::StatusOr<MillScene> MillSceneOf(PlacedScene parts, std::optional<PlacedScene> stock,
                                      const MillSettings& settings);

}  // namespace slicefarm::coordinator
