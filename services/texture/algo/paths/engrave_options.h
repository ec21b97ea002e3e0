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
  /// Styles of the layers, beginning with the first layer. Layer i has the style i modulo their
  /// number.
  std::vector<LineStyle> lines = {{}};
  bool equidistant = false;  ///< true: lines bend so that their distance on the surface is even
  /// true: the texture is removed from the surface; false: it is added onto the surface
  bool engraved = false;
  /// true: the area outside of the texture's section is worked, in layers from the texture's top
  /// down
  bool outside = false;
  double margin_mm = 0;  ///< distance of lines from the boundary of the map; 0: lines may reach it
  NormalKind normals = NormalKind::kFaces;
  /// true: connects neighbouring lines if the path between them is in the worked area
  bool connect = true;
  double clearance_mm =
      0;  ///< height of links above surface and texture; 0: links are at the layer's height
  /// minimum length of a worked part of a line; shorter parts are left out
  double least_run_mm = 0;
};

/// Returns the height of each layer above the texture's base, ascending. The texture is divided
/// into as few equal layers as `layer_height_mm` permits. Each layer is cut at its middle.
std::vector<double> LayerHeights(double texture_mm, double layer_height_mm);

/// Returns the offset of a layer from the surface, along the surface's normal; negative: below the
/// surface. `texture_mm`: height of the texture; `height_mm`: height of the layer above the
/// texture's base.
double OffsetOf(const EngraveOptions& options, double texture_mm, double height_mm);

}  // namespace slicefarm::texture
