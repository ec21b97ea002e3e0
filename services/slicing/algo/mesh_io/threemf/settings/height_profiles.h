#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::slicing::threemf {

/// What was drawn by hand of the heights of each object's layers, as the setting
/// layer_height_profile has it, by the object's number among those that are built, from 1.
using HeightProfiles = std::map<int64_t, std::string>;

/// Metadata/Slic3r_PE_layer_heights_profile.txt or Metadata/layer_heights_profile.txt, which are
/// the same: a line for each object, `object_id=1|0.000000;0.200000;...`. Errors: MESH_MALFORMED,
/// with the line, for anything else.
absl::StatusOr<HeightProfiles> ReadHeightProfiles(std::string_view text, const std::string& part);

}  // namespace slicefarm::slicing::threemf
