#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"

namespace slicefarm::slicing::threemf {

/// The height ranges of each object, by its number among those that are built, from 1.
using HeightRanges = std::map<int64_t, std::vector<HeightRange>>;

/// Metadata/Prusa_Slicer_layer_config_ranges.xml or Metadata/layer_config_ranges.xml, which are the
/// same. Errors: those of XmlParser; MESH_MALFORMED for heights that are no numbers or upside down,
/// MESH_TOO_LARGE.
absl::StatusOr<HeightRanges> ReadHeightRanges(std::string_view text, const std::string& part);

}  // namespace slicefarm::slicing::threemf
