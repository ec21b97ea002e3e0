#pragma once

#include <string>
#include <vector>

#include "services/lab/poly_files.h"

namespace slicefarm::bench {

struct PolygonFile {
  std::string name;  ///< without its ending
  lab::PolyFile poly;
};

/// The polygons of a directory by their files' names; those that cannot be read are left out.
std::vector<PolygonFile> PolygonsIn(const std::string& directory);

}  // namespace slicefarm::bench
