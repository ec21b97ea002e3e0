#pragma once

#include <cstdint>
#include <vector>

#include "services/texture/algo/paths/placement.h"
#include "services/texture/algo/paths/surface_map.h"

namespace slicefarm::texture {

/// Style of a layer's lines.
struct LineStyle {
  double spacing_mm = 0.1;
  double angle_deg = 0;  ///< angle of the lines, counter-clockwise from the texture's x axis

  friend bool operator==(const LineStyle&, const LineStyle&) = default;
};

/// Options for making a texture on a surface.
struct EngraveOptions {
  PlacementOptions placement = {};
  double layer_height_mm = 0.05;
  /// Styles of the layers, from the first layer; after the last style they are repeated from the
  /// start.
  std::vector<LineStyle> lines = {{}};
  bool equidistant = false;  ///< true: lines bend so that their distance on the surface is even
  bool engraved = false;     ///< true: the texture is worked into the surface; false: onto it
  bool outside = false;      ///< true: the area outside of the texture is worked, from its top down
  double margin_mm = 0;      ///< distance of lines from the boundary
  NormalKind normals = NormalKind::kFaces;
  /// true: connects neighbouring lines if the path between them is in the area
  bool connect = true;
  double clearance_mm =
      0;  ///< height of links above surface and texture; 0: links are at the layer's height
  double least_run_mm = 0;  ///< minimum length; shorter parts of lines are left out
};

/// Returns the heights at which a texture is cut, ascending. They are the middles of equal layers.
/// There are as few layers as possible without exceeding the requested height.
std::vector<double> LayerHeights(double texture_mm, double layer_height_mm);

/// Returns the offset from the surface at which a layer is worked; negative: below the surface.
/// `texture_mm`: height of the texture; `height_mm`: height of the layer in the texture.
double OffsetOf(const EngraveOptions& options, double texture_mm, double height_mm);

}  // namespace slicefarm::texture
