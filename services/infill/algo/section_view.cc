#include "services/infill/algo/section_view.h"

#include <algorithm>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/model/options/fill_angles.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/solid_layers.h"
#include "services/infill/algo/skins/expanded_tops.h"

namespace slicefarm::infill {
namespace {

/// Returns the outlines of `count` layers above (`step` 1) or below (`step` -1). An outline equal
/// to `outline` (of the current layer) or to the next nearer one is returned as the same pointer.
/// This comparison is done here once for all islands; in a prism all layers are equal.
std::vector<const MultiPolygon*> Side(const SectionView& view, std::optional<int32_t> row,
                                      const MultiPolygon* outline, int32_t step, int32_t count,
                                      const ShellExtra& spare = {}) {
  std::vector<const MultiPolygon*> side;
  const MultiPolygon* nearer = outline;
  Coord between_nm = 0;
  for (int32_t i = 1; i <= count; ++i) {
    // A surface beyond this layer has enough material between it and the current layer.
    if (IsSpared(spare, count, i, between_nm)) break;
    const int32_t own_layer = view.layer + i * step;
    const MultiPolygon* layer = view.OutlineAt(own_layer, row);
    for (const MultiPolygon* same : {outline, nearer})
      if (same != nullptr && layer != nullptr && *layer == *same) layer = same;
    side.push_back(layer);
    nearer = layer;
    between_nm += view.HeightAt(own_layer);
  }
  return side;
}

/// Removes from the outlines above the areas by which the top surfaces below them grow.
void GrowTops(const SectionView& view, const InfillOptions& options, std::optional<int32_t> row,
              Cover& cover) {
  for (size_t i = 0; i < cover.above.size(); ++i) {
    const MultiPolygon* outline = view.OutlineAt(view.layer + static_cast<int32_t>(i), row);
    if (outline == nullptr || cover.above[i] == nullptr || *outline == *cover.above[i]) continue;
    const MultiPolygon grown = TopGrowth(*outline, *cover.above[i],
                                         {.surfaces = options.surfaces,
                                          .walls_nm = options.walls_nm,
                                          .width_nm = options.top_width_nm});
    if (grown.empty()) continue;
    cover.own.push_back(std::make_shared<const MultiPolygon>(Difference(*cover.above[i], grown)));
    cover.above[i] = cover.own.back().get();
  }
}

/// Returns the angle of a template for a layer, or nothing if there is no template.
std::optional<double> PlannedAngle(const SharedText& angles, double base_rad, int32_t layer) {
  constexpr double kDegree = std::numbers::pi / 180;
  const auto& steps = angles.Once([](const std::string& text) { return ParseFillAngles(text); });
  if (!steps.ok()) return std::nullopt;
  return FillAngleAt(*steps, base_rad / kDegree, layer) * kDegree;
}

}  // namespace

const MultiPolygon* SectionView::OutlineAt(int32_t own_layer, std::optional<int32_t> row) const {
  const ObjectSection* section = stacks.Find(stack.id, own_layer);
  if (section == nullptr || (own_layer == layer + 1 && IsApart(*section))) return nullptr;
  if (!row) return &OutlineOf(*section);
  const auto own = std::ranges::find(section->regions, *row, &Region::settings);
  return own == section->regions.end() ? nullptr : &own->outlines;
}

bool SectionView::IsApart(const ObjectSection& above) const {
  return above.z_nm - above.height_nm > z_nm + (height_nm + 1) / 2;
}

Coord SectionView::HeightAt(int32_t own_layer) const {
  const ObjectSection* section = stacks.Find(stack.id, own_layer);
  return section == nullptr ? 0 : section->height_nm;
}

SectionView SectionView::Below() const {
  SectionView view = *this;
  --view.layer;
  if (const ObjectSection* section = stacks.Find(stack.id, view.layer); section != nullptr) {
    view.z_nm = section->z_nm - section->height_nm / 2;
    view.height_nm = section->height_nm;
  }
  return view;
}

Cover CoverOf(const SectionView& view, const InfillOptions& options, std::optional<int32_t> row) {
  const MultiPolygon* outline = view.OutlineAt(view.layer, row);
  Cover cover{
      .above = Side(view, row, outline, 1, options.top_solid_layers, options.top_spare),
      .below = Side(view, row, outline, -1, options.bottom_solid_layers, options.bottom_spare),
      .on_bed = view.layer == 0};
  if (options.surfaces.expansion_nm > 0 && options.solid.top_density > 0)
    GrowTops(view, options, row, cover);
  const bool over_bridges = options.over_bridges || DoublesExternal(options.bridges.extra);
  const int32_t bearers = over_bridges ? kOverBridgeHaloLayers : 1;
  if (row || over_bridges)
    cover.bearers = Side(view, {}, outline, -1, std::min(bearers, view.layer));
  return cover;
}

double SolidDensity(const InfillOptions& options, int32_t layer) {
  const SolidOptions& solid = options.solid;
  if (layer < 1 || layer > solid.foot_layers) return 1;
  return 1 - (1 - solid.foot_density) * (solid.foot_layers + 1 - layer) / solid.foot_layers;
}

bool IsAllSolid(const InfillOptions& options, int32_t layer) {
  if (options.solid_every_layers > 0 && layer % options.solid_every_layers == 0) return true;
  const SharedText& extra = options.solid.extra_layers;
  if (extra.empty()) return false;
  const auto& list = extra.Once([](const std::string& text) { return ParseSolidLayers(text); });
  return list.ok() && ContainsLayer(*list, layer);
}

int32_t PatternLayer(FillPattern pattern, const FillLineAngles& angles, int32_t layer) {
  const bool shifts = pattern == FillPattern::kCrossZag || pattern == FillPattern::kLockedZag;
  return angles.sparse_planned && !shifts ? 0 : layer;
}

FillLineAngles AnglesOf(const InfillOptions& options, int32_t layer) {
  const auto sparse = PlannedAngle(options.angle_template, options.angle_rad, layer);
  const double solid_rad =
      options.solid_angle_rad >= 0 ? options.solid_angle_rad : options.angle_rad;
  const auto solid = PlannedAngle(options.solid_angle_template, solid_rad, layer);
  return {sparse.value_or(options.angle_rad) + options.turn_rad,
          solid.value_or(solid_rad) + options.turn_rad,
          sparse.has_value() || options.same_direction,
          solid.has_value() || options.same_direction};
}

BodyMiddles::BodyMiddles(const SectionView& view, const PlannedInfill* plan)
    : plan_(plan), islands_(std::vector<Box>()) {
  const MultiPolygon* outline = view.OutlineAt(view.layer);
  if (plan == nullptr || outline == nullptr || plan->body_middles.size() != outline->size()) return;
  outline_ = outline;
  islands_ = BoxIndex(*outline);
}

Point BodyMiddles::Of(const MultiPolygon& area) const {
  if (outline_ == nullptr || area.empty()) return {};
  const Point inside = area.front().outer.front();
  for (const size_t i : islands_.Meeting({inside, inside}))
    if (Locate(inside, (*outline_)[i]) != slicefarm::Side::kOutside) return plan_->body_middles[i];
  return {};
}

}  // namespace slicefarm::infill
