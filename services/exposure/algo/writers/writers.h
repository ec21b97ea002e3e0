#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "common/geometry/measure.h"
#include "processes/laser/model/exposed_layer.h"
#include "processes/laser/model/exposure_options.h"
#include "services/exposure/algo/writers/custom_laser_code.h"

namespace slicefarm::exposure {

/// Facts about the whole job that a file contains.
struct FileFacts {
  int32_t layers = 0;
  Box bounds;           ///< bounds of the exposure on the plate; empty if nothing is exposed
  Coord bottom_nm = 0;  ///< lower side of the first layer
  Coord top_nm = 0;     ///< upper side of the last layer
  std::span<const std::string> object_names = {};  ///< names, indexed by object
  std::span<const ExposureOptions> regions = {};   ///< options, indexed by row of the job's tables
  ExposureOutput output;
  std::string_view start_code = {}, end_code = {};  ///< texts of CustomLaserCode
};

/// Returns true if the format has layer heads, which contain the user's G-code at the start of each
/// layer.
bool HasLayerHeads(OutputFormat format);

/// Returns the header of a file. A file is its header, its layers and its footer, one after the
/// other. If the format has layer heads, each layer follows its head. Layers can be written
/// independently, in any order, because the laser is off at the start and end of each layer. A DXF
/// contains the layer output.layer; the text of all other layers is empty. Each format has its own
/// source file in this folder.
std::string FileHeader(const FileFacts& facts);
/// Returns the head of a layer. REQUIRES: the format has layer heads.
std::string LayerHead(const LayerFrame& layer, const LayerCode& code);
/// Returns the text of a layer.
std::string LayerText(const ExposedLayer& layer, const FileFacts& facts);
/// Returns the end of a file.
std::string FileFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
