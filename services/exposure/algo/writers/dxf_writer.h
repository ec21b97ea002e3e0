#pragma once

#include <string>

#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {

/// Returns the header of a DXF R12 file in mm. The file contains only the print layer output.layer,
/// as LINEs and POLYLINEs. Each kind of vector has a DXF layer of its own.
std::string DxfHeader(const FileFacts& facts);
/// Returns the entities of one layer.
std::string DxfLayer(const ExposedLayer& layer, const FileFacts& facts);
/// Returns the end of the file.
std::string DxfFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
