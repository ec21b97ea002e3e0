#pragma once

#include "common/model/milling/milling_options.h"
#include "common/model/scene/mesh.h"

namespace slicefarm {

/// What is milled and how. Meshes are in the program's coordinates.
struct MillInput {
  IndexedMesh part;
  IndexedMesh stock;  ///< no triangles: a box around the part
  MillSettings settings;

  friend bool operator==(const MillInput&, const MillInput&) = default;
};

}  // namespace slicefarm
