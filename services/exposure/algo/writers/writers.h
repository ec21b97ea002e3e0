#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "absl/status/status.h"
#include "common/geometry/measure.h"
#include "common/model/exposed_layer.h"
#include "common/model/options/exposure_options.h"

namespace slicefarm::exposure {

/// What a file says about the whole job.
struct FileFacts {
  int32_t layers = 0;
  Box bounds;           ///< of what is exposed, on the plate; empty if nothing is
  Coord bottom_nm = 0;  ///< the first layer's lower side
  Coord top_nm = 0;     ///< the last layer's upper side
  std::span<const std::string> object_names = {};  ///< by object
  std::span<const ExposureOptions> regions = {};   ///< by row of the job's tables
  ExposureOutput output;
};

/// A file is its header, its layers and its footer, one after the other. Layers are made apart from
/// each other, in any order: each starts and ends with the laser off. A DXF has one layer: all
/// others are empty text. Each format has a file of its own in this folder.
std::string FileHeader(const FileFacts& facts);
std::string LayerText(const ExposedLayer& layer, const FileFacts& facts);
std::string FileFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
