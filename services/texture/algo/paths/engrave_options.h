#pragma once

#include <cstdint>
#include <vector>

#include "services/texture/algo/paths/placement.h"
#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// Lines of a layer.
struct LineStyle {
  double spacing_mm = 0.1;
  double angle_deg = 0;  ///< counter-clockwise from the texture's x

  friend bool operator==(const LineStyle&, const LineStyle&) = default;
};

/// How a texture is made on a surface.
struct EngraveOptions {
  PlacementOptions placement = {};
  double layer_height_mm = 0.05;
  std::vector<LineStyle> lines = {{}};  ///< of the first layer, the next one, ...; over again
  bool equidistant = false;  ///< lines bend so that they lie as far apart on the surface as asked
  bool engraved = false;     ///< into the surface; else onto it
  bool outside = false;      ///< what is not the texture is worked, from its top down
  double margin_mm = 0;      ///< to the boundary
  NormalKind normals = NormalKind::kFaces;
  bool connect = true;  ///< neighbouring lines, where the way between them lies in the area
  double clearance_mm =
      0;  ///< of links, above the surface and what stands on it; 0: they stay at the layer's height
  double least_run_mm = 0;  ///< shorter parts of lines are left out
};

/// Heights at which a texture is cut, ascending: the middles of equal layers, as few as are no
/// higher than asked.
std::vector<double> LayerHeights(double texture_mm, double layer_height_mm);

/// How far above the surface a layer of that height is worked; negative: below.
double OffsetOf(const EngraveOptions& options, double texture_mm, double height_mm);

}  // namespace slicefarm::texture
