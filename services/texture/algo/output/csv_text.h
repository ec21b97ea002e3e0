#pragma once

#include <string>

#include "services/texture/algo/paths/layer_paths.h"

namespace slicefarm::texture {

/// First line of a table of points.
inline constexpr char kCsvHeader[] = "path,layer,x,y,z,nx,ny,nz,on\n";

/// Returns a layer's rows. The column `path` numbers the sequences of points that are worked
/// without a link in between, from 0 in each layer. Positions in mm and unit normals are the
/// shortest decimals that read back as the same doubles.
std::string CsvRows(const LayerPath& path);

}  // namespace slicefarm::texture
