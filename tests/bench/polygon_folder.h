#pragma once

#include <string>
#include <vector>

#include "services/lab/poly_files.h"

namespace slicefarm::bench {

struct PolygonFile {
  std::string name;  ///< file name without its ending
  lab::PolyFile poly;
};

/// Returns the polygons in the files of a directory, by file name. Unreadable files are left out.
std::vector<PolygonFile> PolygonsIn(const std::string& directory);

}  // namespace slicefarm::bench
