#pragma once

#include <string>

#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {

/// SVG in mm with a group a layer (id="layer0"), in it a path for each group of lines, of a colour
/// for each kind and as wide as the spot. y points up, by a transform around all layers.
std::string SvgHeader(const FileFacts& facts);
std::string SvgLayer(const ExposedLayer& layer, const FileFacts& facts);
std::string SvgFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
