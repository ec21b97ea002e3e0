#pragma once

#include <string>

#include "services/texture/algo/paths/layer_paths.h"

namespace slicefarm::texture {

/// First line of a table of points.
inline constexpr char kCsvHeader[] = "path,layer,x,y,z,nx,ny,nz,on\n";

/// Returns the CSV rows of a layer's points. The column `path` is the index, from 0 in each layer,
/// of a sequence of points that the tool works without a link in between. Positions (in mm) and
/// unit normals are the shortest decimals that read back as the same doubles.
std::string CsvRows(const LayerPath& path);

}  // namespace slicefarm::texture
