#pragma once

#include <string>

#include "services/exposure/algo/writers/writers.h"

namespace slicefarm::exposure {

/// Returns the header of an SVG in mm with one group per layer (id="layer0"). Each group has a path
/// for each group of lines, in the colour of its kind and as wide as the spot. A transform around
/// all layers makes y point up.
std::string SvgHeader(const FileFacts& facts);
/// Returns the group of one layer.
std::string SvgLayer(const ExposedLayer& layer, const FileFacts& facts);
/// Returns the end of the file.
std::string SvgFooter(const FileFacts& facts);

}  // namespace slicefarm::exposure
