#pragma once

#include <cstdint>
#include <optional>

#include "common/geometry/box_index.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "common/model/options/fill_patterns.h"
#include "common/stage/object_layers.h"
#include "services/infill/algo/skins/skins.h"

namespace slicefarm {
struct InfillOptions;
}  // namespace slicefarm

namespace slicefarm::infill {

/// Data of a section that all its fill areas share.
struct SectionView {
  Stack stack;
  int32_t layer = 0;  ///< index of the layer in the stack
  Coord height_nm = 0;
  bool on_bed = false;
  const ObjectLayers& stacks;
  const MultiPolygon& above_supports;  ///< areas directly above supports
  Coord z_nm = 0;                      ///< height of the layer's middle above the stack's bottom

  /// Returns the outlines of the stack in its layer `own_layer`. With `row`: only the outlines of
  /// the region with this row of settings. Null: the layer does not contain the stack or the
  /// region, or it is the next layer and lies higher than this layer's top. Supports that stand on
  /// different parts of an object have such gaps.
  const MultiPolygon* OutlineAt(int32_t own_layer, std::optional<int32_t> row = {}) const;

  /// Returns the view of the stack's layer below. It has the number, the height and the position of
  /// that layer, as far as the stack has it.
  SectionView Below() const;

  /// Returns the height of a layer of the stack, in nm; 0 if the stack has no such layer.
  Coord HeightAt(int32_t own_layer) const;

 private:
  bool IsApart(const ObjectSection& above) const;
};

/// Returns the outlines of the layers that decide the skins of a region (skins.h). `row`: index of
/// the region's settings; then these are outlines of the region only. Without `row`, they are
/// outlines of the whole object. The outlines for bridges are always outlines of the whole object.
/// Outlines above leave out the areas by which top surfaces grow (expanded_tops.h).
Cover CoverOf(const SectionView& view, const InfillOptions& options, std::optional<int32_t> row);

/// Returns the density of solid infill inside the object in a layer. It is below 1 in the lowest
/// layers only, where it keeps the elephant foot small.
double SolidDensity(const InfillOptions& options, int32_t layer);

/// Returns true if a layer of a stack has only solid infill, by the intervals and lists of the
/// settings.
bool IsAllSolid(const InfillOptions& options, int32_t layer);

/// Directions of lines in a layer.
struct FillLineAngles {
  double sparse_rad = 0;
  double solid_rad = 0;
  /// True if the angle is from a template, which already contains the rotation of each layer, or if
  /// lines do not turn from layer to layer.
  bool sparse_planned = false;
  bool solid_planned = false;
};

/// Returns the index of a layer for a pattern. It is 0 in all layers if a template contains the
/// turns of the lines, except for patterns that shift their lines from layer to layer.
int32_t PatternLayer(FillPattern pattern, const FillLineAngles& angles, int32_t layer);

/// Returns the directions of lines in a layer, in the frame of the object's copies. `layer`: index
/// of the layer in the stack.
FillLineAngles AnglesOf(const InfillOptions& options, int32_t layer);

/// Middles of the connected bodies of a section.
class BodyMiddles {
 public:
  /// `view` and `plan` must outlive this object. `plan` may be null.
  BodyMiddles(const SectionView& view, const PlannedInfill* plan);

  /// Returns the middle of the body that contains an area of the view's layer, or the object's
  /// middle if the plan has no bodies. Cost: O(log n), n islands, and a search in the islands with
  /// boxes that contain the area's first point.
  Point Of(const MultiPolygon& area) const;

 private:
  const MultiPolygon* outline_ = nullptr;  ///< outline of the layer; null: no bodies
  const PlannedInfill* plan_;
  BoxIndex islands_;
};

}  // namespace slicefarm::infill
