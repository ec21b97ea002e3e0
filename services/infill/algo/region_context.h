#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/model/layers/layer.h"
#include "services/infill/algo/quality/fill_plastic.h"
#include "services/infill/algo/section_view.h"
#include "services/infill/algo/skins/cover_index.h"
#include "services/infill/algo/skins/skins.h"
#include "services/infill/algo/solid.h"

namespace slicefarm {
struct InfillOptions;
}  // namespace slicefarm

namespace slicefarm::infill {

/// Groups of paths that fill areas, and the reports of their plastic.
struct Fills {
  std::vector<FillGroup> groups;
  std::vector<FillStats> uses;
};

/// Data of a region in a section that all kinds of its infill share.
struct RegionContext {
  /// Makes the context of the row `settings`. `view` and `options` must outlive it.
  RegionContext(const SectionView& view, int32_t settings, const InfillOptions& options);

  /// Returns the width of lines, which is another one in the layer on the bed.
  Coord Width(Coord width_nm) const;

  /// Returns the angle of solid lines. It turns by a right angle from layer to layer, except for
  /// patterns that do not turn and for templates, which contain all turns.
  double SolidAngle(FillPattern pattern) const;

  /// Returns the fill of a solid area of the layer.
  SolidFill FillOf(Feature feature, FillPattern pattern, double angle_rad, Coord width_nm,
                   Coord overlap_nm) const;

  /// Adds a group of paths, and its use.
  void Append(FillGroup group, const RequestedFill& asked, Fills& fills) const;

  const SectionView& view;
  const InfillOptions& options;
  const int32_t settings;
  const std::optional<int32_t> row;  ///< region of the skins; none: the whole object
  const Cover cover;
  const CoverIndex near_cover;  ///< the cover for single areas
  const FillLineAngles angles;
};

}  // namespace slicefarm::infill
