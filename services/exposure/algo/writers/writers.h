#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "common/geometry/measure.h"
#include "processes/laser/model/exposed_layer.h"
#include "processes/laser/model/exposure_options.h"
#include "services/exposure/algo/writers/own_code.h"

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
  std::string_view start_code = {}, end_code = {};  ///< OwnCode's
};

/// Whether layers have heads of their own, and the file G-code of the user's.
bool HasLayerHeads(OutputFormat format);

/// A file is its header, its layers, each after its head if the format has them, and its footer,
/// one after the other. Layers are made apart from
/// each other, in any order: each starts and ends with the laser off. A DXF has one layer: all
/// others are empty text. Each format has a file of its own in this folder.
std::string FileHeader(const FileFacts& facts);
/// Of formats that have them.
std::string LayerHead(const LayerFrame& layer, const LayerCode& code);
std::string LayerText(const ExposedLayer& layer, const FileFacts& facts);
std::string FileFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
