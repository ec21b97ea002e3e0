#pragma once

#include <string>

#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {

/// DXF R12 in mm of layer output.layer: LINEs and POLYLINEs on a DXF layer for each kind.
std::string DxfHeader(const FileFacts& facts);
std::string DxfLayer(const ExposedLayer& layer, const FileFacts& facts);
std::string DxfFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
