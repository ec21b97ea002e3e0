#include "services/planning/algo/infill/infill_planner.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "common/model/bead_section.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/planning_options.h"
#include "common/stage/job_memory.h"
#include "services/planning/algo/infill/bodies.h"
#include "services/planning/algo/infill/choose_pattern.h"
#include "services/planning/algo/infill/cubic_octree.h"
#include "services/planning/algo/infill/lightning.h"
#include "services/planning/algo/infill/sparse_areas.h"
#include "services/planning/algo/infill/surface_points.h"

namespace slicefarm::planning {
namespace {

using LinesByLayer = std::vector<std::vector<Polyline>>;

/// Width in beads up to which solid infill needs no infill under it, because it is supported on
/// both sides.
constexpr Coord kBridgedWidths = 2;
/// Width in beads below which a strip is too narrow for lines of its own.
constexpr Coord kNarrowWidths = 4;

/// Returns the distance of lines for the density, in nm, in layers of the greatest height.
double PitchOf(const InfillOptions& options, const ObjectStack& stack) {
  Coord height_nm = 0;
  for (const StackLayer& layer : stack) height_nm = std::max(height_nm, layer.height_nm);
  return static_cast<double>(Spacing(options.sparse_width_nm, height_nm)) / options.density;
}

/// Returns the pitch of an octree's finest cubes. The planes are 3 widths / density apart in space,
/// as in PrusaSlicer (FillAdaptive). So the density of a PrusaSlicer profile gives the same cubes.
/// Their lines are as long per area as the lines of cubic infill at 0.74 of that density.
double OctreePitchOf(const InfillOptions& options) {
  return std::sqrt(1.5) * static_cast<double>(options.sparse_width_nm) / options.density;
}

double ReachOf(const ObjectStack& stack) {
  Coord reach = 0;
  for (const StackLayer& layer : stack) {
    reach = std::max(reach, layer.z_nm);
    ForEachRing(layer.whole, [&](const Polygon& ring) {
      for (const Point p : ring) reach = std::max(reach, static_cast<Coord>(std::ceil(Norm(p))));
    });
  }
  return static_cast<double>(reach);
}

LinesByLayer OctreeLines(FillPattern pattern, const InfillOptions& options,
                         const ObjectStack& stack) {
  CubicOctree tree(OctreePitchOf(options), options.angle_rad, ReachOf(stack));
  const auto step = static_cast<Coord>(tree.StepNm());
  const SkinLayers skins{options.top_solid_layers, options.bottom_solid_layers};
  const auto add = [&](Point place, Coord z_nm, double around_nm) {
    tree.Add(place, z_nm, around_nm);
  };
  if (pattern == FillPattern::kSupportCubic) {
    ForEachRoofPoint(stack, skins, step, add);
  } else {
    ForEachSurfacePoint(stack, skins, step, add);
  }
  ForEachInnerPoint(stack, static_cast<Coord>(tree.BodyStepNm()),
                    [&](Point place, Coord z_nm) { tree.AddBody(place, z_nm); });
  tree.Grow();
  LinesByLayer lines;
  for (const StackLayer& layer : stack)
    lines.push_back(layer.region.empty()
                        ? std::vector<Polyline>{}
                        : tree.LinesAt(static_cast<double>(layer.z_nm - layer.height_nm / 2)));
  return lines;
}

/// Areas of sparse infill, computed once for all settings that need them.
struct SparseInfillAreas {
  std::vector<MultiPolygon> inner;
  std::vector<MultiPolygon> areas;
  std::vector<MultiPolygon> roofs;
};

SparseInfillAreas SparseInfillAreasOf(const InfillOptions& options, const ObjectStack& stack) {
  SparseInfillAreas infill_areas;
  infill_areas.inner = InnerAreas(stack, options.walls_nm);
  infill_areas.areas =
      SparseAreas(stack, infill_areas.inner,
                  {options.top_solid_layers, options.bottom_solid_layers, options.top_spare,
                   options.bottom_spare, options.interface_shells});
  infill_areas.roofs = RoofsOf(infill_areas.areas);
  return infill_areas;
}

/// Returns the tangent of an angle, rounded so that it is exactly 1 for 45 degrees.
double TangentOf(double angle_rad) { return std::round(Tan(angle_rad) * 1e9) / 1e9; }

LinesByLayer LinesOf(FillPattern pattern, const InfillOptions& options, const ObjectStack& stack,
                     const SparseInfillAreas& infill_areas) {
  if (options.density <= 0 || !InfoOf(pattern).planned) return LinesByLayer(stack.size());
  if (pattern != FillPattern::kLightning) return OctreeLines(pattern, options, stack);
  const double radius = PitchOf(options, stack);
  const auto hollow = HollowAreas(infill_areas.inner, infill_areas.areas, std::llround(radius));
  return LightningLines(stack, hollow, RoofsOf(hollow),
                        {.radius_nm = radius,
                         .beyond_nm = static_cast<double>(options.sparse_width_nm),
                         .overhang = TangentOf(options.shape.lightning_overhang_rad),
                         .prune = TangentOf(options.shape.lightning_prune_rad),
                         .straighten = TangentOf(options.shape.lightning_straighten_rad)});
}

}  // namespace

void InfillPlanner::Look(const SlicedLayer& layer, LayerPlan& plan) {
  (void)plan;
  held_bytes_ += MemoryOf(layer);
  for (const ObjectSection& section : layer.sections) {
    if (!section.stack.IsPart()) continue;
    ObjectStack& stack = stacks_[section.stack.object];
    for (const Region& region : section.regions) {
      const auto row = static_cast<size_t>(region.settings);
      if (row < options_.infill.size() && NeedsPlan(options_.infill[row]))
        regions_[{section.stack.object, region.settings}][stack.size()] = region.outlines;
    }
    stack.push_back({layer.frame.index, section.z_nm, section.height_nm, OutlineOf(section), {}});
  }
}

bool InfillPlanner::IsNeeded(const PlanningOptions& options) {
  return std::ranges::any_of(options.infill, NeedsPlan);
}

absl::Status InfillPlanner::Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) {
  for (const auto& [key, regions] : regions_) {
    ObjectStack stack = stacks_[key.first];
    for (const auto& [place, outlines] : regions) stack[place].region = outlines;
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    FinishRow(key, stack, layers, plan);
  }
  return absl::OkStatus();
}

void InfillPlanner::FinishRow(const Key& key, const ObjectStack& stack, OpenLayers& layers,
                              JobPlan& plan) const {
  const InfillOptions& options = options_.infill[static_cast<size_t>(key.second)];
  FillPattern pattern = options.pattern;
  if (options.choose_pattern) {
    const PartShape shape = ShapeOf(stack);
    PatternChoice choice = ChoosePattern(options, shape);
    pattern = choice.pattern;
    plan.notes.push_back(
        fmt::format("fill_pattern = auto: {} for {} ({:.0f} % density, {:.1f} mm high, {:.1f} mm "
                    "wide on average): {}",
                    InfoOf(pattern).name, NameOf(key.first, object_names_), 100 * options.density,
                    shape.height_mm, shape.width_mm, choice.reason));
  }
  const bool looks_at_areas =
      pattern == FillPattern::kLightning || options.only_where_needed || options.every_layers > 1;
  const SparseInfillAreas sparse =
      looks_at_areas ? SparseInfillAreasOf(options, stack) : SparseInfillAreas{};
  LinesByLayer lines = LinesOf(pattern, options, stack, sparse);
  std::vector<InfillAreas> infill_areas(stack.size());
  if (options.only_where_needed)
    LeaveOutUnneeded(sparse.areas, sparse.roofs, kBridgedWidths * options.sparse_width_nm,
                     options.walls_nm + options.sparse_width_nm, infill_areas);
  if (options.every_layers > 1)
    CombineLayers(stack, sparse.areas, options.every_layers,
                  kNarrowWidths * options.sparse_width_nm, infill_areas);
  auto middles =
      NeedsBodies(options) ? BodyMiddles(stack) : std::vector<std::vector<Point>>(stack.size());
  for (size_t i = 0; i < stack.size(); ++i) {
    if (stack[i].region.empty()) continue;
    layers.At(stack[i].job_layer)
        .infill.push_back({key.first, key.second, pattern, std::move(lines[i]),
                           std::move(infill_areas[i].left_out), std::move(infill_areas[i].combined),
                           infill_areas[i].combined_height_nm, std::move(middles[i])});
  }
}

}  // namespace slicefarm::planning
