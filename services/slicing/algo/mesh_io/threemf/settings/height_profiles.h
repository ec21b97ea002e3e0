#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm::slicing::threemf {

/// Manually drawn layer heights of each object, in the format of the setting layer_height_profile.
/// The key is the object's number among the objects that are built, from 1.
using HeightProfiles = std::map<int64_t, std::string>;

/// Reads Metadata/Slic3r_PE_layer_heights_profile.txt or Metadata/layer_heights_profile.txt, which
/// have the same format: a line for each object, `object_id=1|0.000000;0.200000;...`. `part`: name
/// of this file in the archive, for error messages. Errors: MESH_MALFORMED, with the line, for
/// anything else.
absl::StatusOr<HeightProfiles> ReadHeightProfiles(std::string_view text, const std::string& part);

}  // namespace slicefarm::slicing::threemf
