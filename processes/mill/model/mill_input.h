#pragma once

#include "common/model/scene/mesh.h"
#include "processes/mill/model/milling_options.h"

namespace slicefarm {

/// Input of a milling job. Meshes are in the program's coordinates.
struct MillInput {
  IndexedMesh part;
  IndexedMesh stock;  ///< mesh of the stock; without triangles: a box around the part
  MillSettings settings;

  friend bool operator==(const MillInput&, const MillInput&) = default;
};

}  // namespace slicefarm
