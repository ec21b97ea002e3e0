#include "services/infill/algo/region_context.h"

#include <numbers>
#include <utility>

#include "common/model/options/infill_options.h"

namespace slicefarm::infill {

RegionContext::RegionContext(const SectionView& view, int32_t settings,
                             const InfillOptions& options)
    : view(view),
      options(options),
      settings(settings),
      row(options.interface_shells ? std::optional(settings) : std::nullopt),
      cover(CoverOf(view, options, row)),
      near_cover(cover, view.OutlineAt(view.layer, row)),
      angles(AnglesOf(options, view.layer)) {}

Coord RegionContext::Width(Coord width_nm) const {
  return view.on_bed ? options.first_layer_width_nm : width_nm;
}

double RegionContext::SolidAngle(FillPattern pattern) const {
  const bool turns = !angles.solid_planned && !IsAligned(pattern) && view.layer % 2 != 0;
  return angles.solid_rad + (turns ? std::numbers::pi / 2 : 0);
}

SolidFill RegionContext::FillOf(Feature feature, FillPattern pattern, double angle_rad,
                                Coord width_nm, Coord overlap_nm) const {
  SolidFill fill{.feature = feature,
                 .pattern = pattern,
                 .angle_rad = angle_rad,
                 .width_nm = width_nm,
                 .height_nm = view.height_nm,
                 .layer = view.layer,
                 .overlap_nm = overlap_nm,
                 .beside_walls = view.stack.IsPart()};
  if (options.surfaces.center == SurfaceCenter::kSurface) fill.center = std::nullopt;
  return fill;
}

void RegionContext::Append(FillGroup group, const RequestedFill& asked, Fills& fills) const {
  AddUse(UseOf(asked, group.paths, view.height_nm), 1, fills.uses);
  if (!group.paths.empty()) fills.groups.push_back(std::move(group));
}

}  // namespace slicefarm::infill
