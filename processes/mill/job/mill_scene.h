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

/// What placing is asked: once for the parts, once for the stock.
struct PlacingInput {
  SliceInput meshes;
  SlicingOptions options;
};

struct PartsAndStock {
  PlacingInput parts;
  std::optional<PlacingInput> stock;  ///< none: a box
};

/// Takes the object that is the stock out of a job's. Errors: SETTING_MALFORMED, with `setting`,
/// if `stock` is the name of no object or of several; NOTHING_TO_PRINT if it is the only one.
absl::StatusOr<PartsAndStock> TakeStock(PlacingInput job, std::string_view stock);

/// Puts a stock that may stand anywhere with its middle where that of the parts is.
void PutAround(const PlacedScene& parts, PlacingInput& stock);

struct MillScene {
  MillInput input;
  std::vector<MeshReport> meshes;     ///< in the program's coordinates
  std::vector<std::string> warnings;  ///< what has no effect
};

/// All copies of all solid parts as one mesh, and the stock, in the program's coordinates. Errors:
/// REQUEST_MALFORMED for parts that cut others out, as meshes are not subtracted; OUT_OF_RANGE.
absl::StatusOr<MillScene> MillSceneOf(PlacedScene parts, std::optional<PlacedScene> stock,
                                      const MillSettings& settings);

}  // namespace slicefarm::coordinator
