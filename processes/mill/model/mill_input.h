#pragma once

#include "common/model/scene/mesh.h"
#include "processes/mill/model/milling_options.h"

namespace slicefarm {

/// What is milled and how. Meshes are in the program's coordinates.
struct MillInput {
  IndexedMesh part;
  IndexedMesh stock;  ///< no triangles: a box around the part
  MillSettings settings;

  friend bool operator==(const MillInput&, const MillInput&) = default;
};

}  // namespace slicefarm
