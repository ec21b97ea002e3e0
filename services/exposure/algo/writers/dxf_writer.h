#pragma once

#include <string>

#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {

/// Returns the header of a DXF R12 file in mm with the layer output.layer: LINEs and POLYLINEs on
/// one DXF layer per kind.
std::string DxfHeader(const FileFacts& facts);
/// Returns the entities of one layer.
std::string DxfLayer(const ExposedLayer& layer, const FileFacts& facts);
/// Returns the end of the file.
std::string DxfFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
