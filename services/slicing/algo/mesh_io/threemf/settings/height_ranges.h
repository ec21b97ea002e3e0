#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"

namespace slicefarm::slicing::threemf {

/// Height ranges of each object. The key is the object's number among the objects that are built,
/// from 1.
using HeightRanges = std::map<int64_t, std::vector<HeightRange>>;

/// Reads Metadata/Prusa_Slicer_layer_config_ranges.xml or Metadata/layer_config_ranges.xml, which
/// have the same format. `part`: name of this file in the archive, for error messages. Errors: any
/// error of XmlParser or AddSetting; MESH_MALFORMED for heights that are not numbers or are in the
/// wrong order; MESH_TOO_LARGE above limits::kMaxObjects objects or limits::kMaxHeightRanges ranges
/// of an object.
absl::StatusOr<HeightRanges> ReadHeightRanges(std::string_view text, const std::string& part);

}  // namespace slicefarm::slicing::threemf
