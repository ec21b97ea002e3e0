#include "services/texture/algo/paths/layer_paths.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "common/base/error.h"
#include "common/base/portable_math.h"
#include "common/model/limits.h"
#include "services/texture/algo/paths/level_lines.h"
#include "services/texture/algo/paths/line_field.h"
#include "services/texture/algo/paths/line_runs.h"
#include "services/texture/algo/paths/surface_walk.h"
#include "services/texture/algo/paths/work_area.h"

namespace slicefarm::texture {
namespace {

constexpr double kConnectSpacings = 3;  // longer connections between lines are links

const LineStyle& StyleOf(const EngravePlan& plan, int32_t layer) {
  return plan.options.lines[layer % plan.options.lines.size()];
}

absl::StatusOr<std::vector<double>> FieldOf(const EngravePlan& plan, const LineStyle& style,
                                            const CancelToken& cancel) {
  const double turn = style.angle_deg * std::numbers::pi / 180;
  const Eigen::Vector2d x = plan.placement.x_axis, y(-x.y(), x.x());
  const Eigen::Vector2d direction = Cos(turn) * x + Sin(turn) * y;
  if (plan.options.equidistant) return EquidistantField(plan.map, direction, cancel);
  return StraightField(plan.map, direction);
}

/// Returns the lines of a style, level by level. Also returns the direction of the map in which the
/// lines of each level are ordered.
absl::StatusOr<std::vector<LevelSet>> LinesOf(const EngravePlan& plan, const LineStyle& style,
                                              const CancelToken& cancel) {
  const auto field = FieldOf(plan, style, cancel);
  if (!field.ok()) return field.status();
  double low = (*field)[plan.map.mesh().triangles[0][0]], high = low;
  for (const auto& triangle : plan.map.mesh().triangles) {
    for (const int32_t vertex : triangle) {
      low = std::min(low, (*field)[vertex]);
      high = std::max(high, (*field)[vertex]);
    }
  }
  const double count = (high - low) / style.spacing_mm;
  if (count > limits::kMaxLinesPerFill)
    return LimitError(Reason::kRequestTooLarge, "lines over the surface", limits::kMaxLinesPerFill,
                      static_cast<int64_t>(std::min(count, 9e18)));
  const double turn = style.angle_deg * std::numbers::pi / 180;
  const Eigen::Vector2d x = plan.placement.x_axis, y(-x.y(), x.x());
  const Eigen::Vector2d along = Cos(turn) * x + Sin(turn) * y;
  auto sets = LevelLines(plan.map, *field, CentredLevels(low, high, style.spacing_mm), cancel);
  if (!sets.ok()) return sets.status();
  const auto start = [&](const LevelLine& line) {
    return along.dot(plan.map.MapPosition(PointOf(plan.map, line.points[0], line.triangles[0])));
  };
  for (LevelSet& set : *sets)
    std::stable_sort(set.lines.begin(), set.lines.end(),
                     [&](auto& a, auto& b) { return start(a) < start(b); });
  return sets;
}

/// Returns the height, above the surface, of the highest material while a layer is worked.
double TopOf(const EngravePlan& plan, const LayerPath& path) {
  if (plan.options.engraved) return 0;
  return plan.options.outside ? plan.texture.height_mm : path.offset_mm;
}

/// Assembles a layer's points.
class PathMaker {
 public:
  PathMaker(const EngravePlan& plan, const WorkArea& area, LayerPath* path)
      : plan_(plan), area_(area), path_(path) {
    const double clearance = plan.options.clearance_mm;
    link_mm_ = clearance > 0 ? TopOf(plan, *path) + clearance : path->offset_mm;
  }

  void Add(const Run& run) {
    if (last_)
      Link(run.front());
    else
      Append(run.front(), false, link_mm_);
    if (!connected_) Plunge(run.front());
    for (size_t i = 1; i < run.size(); ++i) Append(run[i], true, path_->offset_mm);
    ++path_->runs;
  }

  void End() {
    if (last_ && link_mm_ != path_->offset_mm) Append(*last_, false, link_mm_);
  }

 private:
  void Link(const SurfacePoint& to) {
    const SurfacePoint from = *last_;
    const auto walk = WalkBetween(plan_.map, from, to);
    connected_ = walk && walk->straight && plan_.options.connect && IsShort(from, to) &&
                 IsInArea(from, walk->between, to);
    const double height = connected_ ? path_->offset_mm : link_mm_;
    if (height != path_->offset_mm) Append(from, false, height);
    if (walk)
      for (const SurfacePoint& point : walk->between) Append(point, connected_, height);
    Append(to, connected_, height);
  }

  bool IsShort(const SurfacePoint& from, const SurfacePoint& to) const {
    return (plan_.map.MapPosition(to) - plan_.map.MapPosition(from)).norm() <=
           kConnectSpacings * path_->spacing_mm;
  }

  /// Returns true if the path is in the worked area. Each step is tested, because a path along an
  /// outline may be on either side of it by rounding.
  bool IsInArea(const SurfacePoint& from, const std::vector<SurfacePoint>& between,
                const SurfacePoint& to) const {
    Eigen::Vector2d last = plan_.map.MapPosition(from);
    for (size_t i = 0; i <= between.size(); ++i) {
      const Eigen::Vector2d next = plan_.map.MapPosition(i < between.size() ? between[i] : to);
      if (!area_.ContainsAll(last, next)) return false;
      last = next;
    }
    return true;
  }

  void Plunge(const SurfacePoint& at) {
    if (link_mm_ != path_->offset_mm) Append(at, false, path_->offset_mm);
  }

  void Append(const SurfacePoint& point, bool on, double height) {
    const Eigen::Vector3d base = plan_.map.Position(point);
    const Eigen::Vector3d normal = plan_.map.Normal(point, plan_.options.normals);
    const Eigen::Vector3d place = base + height * normal;
    if (last_) {
      const Eigen::Vector3d step = place - path_->points.back().place_mm;
      const double length = step.norm();
      if (length == 0 && on) return;
      (on ? path_->on_mm : path_->off_mm) += length;
      const Eigen::Vector3d below = base - last_base_;
      if (on && step.dot(below) <= 0 && below.squaredNorm() > 0) {
        if (path_->folds++ == 0) path_->first_fold_mm = base;
        path_->folds_mm += below.norm();
      }
    }
    path_->points.push_back({place, normal, on});
    last_ = point;
    last_base_ = base;
  }

  const EngravePlan& plan_;
  const WorkArea& area_;
  LayerPath* path_;
  double link_mm_ = 0;
  bool connected_ = false;
  std::optional<SurfacePoint> last_;
  Eigen::Vector3d last_base_ = Eigen::Vector3d::Zero();
};

absl::Status FillLayer(const EngravePlan& plan, const std::vector<LevelSet>& lines,
                       const WorkArea& area, const CancelToken& cancel, LayerPath* path) {
  PathMaker maker(plan, area, path);
  bool back = false;
  for (const LevelSet& set : lines) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    std::vector<Run> runs;
    for (const LevelLine& line : set.lines)
      for (Run& run : RunsOf(plan.map, line, area, plan.options.least_run_mm))
        runs.push_back(std::move(run));
    if (runs.empty()) continue;
    if (back) {
      std::reverse(runs.begin(), runs.end());
      for (Run& run : runs) std::reverse(run.begin(), run.end());
    }
    back = !back;
    for (const Run& run : runs) maker.Add(run);
    if (path->points.size() > limits::kMaxPointsPerLayer)
      return LimitError(Reason::kRequestTooLarge, fmt::format("points of layer {}", path->layer),
                        limits::kMaxPointsPerLayer, static_cast<int64_t>(path->points.size()));
  }
  maker.End();
  return absl::OkStatus();
}

/// Returns the areas where masks allow work, as sections that WorkArea refers to.
std::vector<Section> MaskSections(const EngravePlan& plan) {
  if (!plan.mask) return {};
  const double half[] = {plan.mask->height_mm / 2};
  return SectionsOf(*plan.mask, half);
}

}  // namespace

absl::StatusOr<std::vector<LayerPath>> LayerPaths(const EngravePlan& plan, int32_t first,
                                                  int32_t end, const CancelToken& cancel) {
  const std::vector<Section> masks = MaskSections(plan);
  std::optional<BoundaryMargin> margin;
  if (plan.options.margin_mm > 0) margin.emplace(plan.map, plan.options.margin_mm);
  std::map<size_t, std::vector<LevelSet>> lines;  // lines per style
  std::vector<LayerPath> paths;
  for (int32_t i = first; i < end; ++i) {
    LayerPath path;
    path.layer = plan.LayerAt(i);
    path.height_mm = plan.heights_mm[path.layer];
    path.offset_mm = OffsetOf(plan.options, plan.texture.height_mm, path.height_mm);
    path.spacing_mm = StyleOf(plan, path.layer).spacing_mm;
    const size_t style = path.layer % plan.options.lines.size();
    if (!lines.contains(style)) {
      auto made = LinesOf(plan, StyleOf(plan, path.layer), cancel);
      if (!made.ok()) return made.status();
      lines[style] = *std::move(made);
    }
    const double height[] = {path.height_mm};
    const std::vector<Section> section = SectionsOf(plan.texture, height);
    path.section_mm2 = section[0].AreaMm2();
    WorkArea area{TiledSection(section[0], plan.texture.tile_mm, plan.placement),
                  plan.options.outside,
                  {},
                  margin ? &*margin : nullptr};
    for (const Section& mask : masks)
      area.masks.emplace_back(mask, plan.mask->tile_mm,
                              Placement{.anchor_mm = plan.map.low_mm(), .repeat = false});
    if (absl::Status status = FillLayer(plan, lines[style], area, cancel, &path); !status.ok())
      return status;
    paths.push_back(std::move(path));
  }
  return paths;
}

absl::StatusOr<std::vector<double>> LineDistances(const EngravePlan& plan,
                                                  const CancelToken& cancel) {
  const LineStyle& style = StyleOf(plan, 0);
  const auto field = FieldOf(plan, style, cancel);
  if (!field.ok()) return field.status();
  std::vector<double> distances;
  for (size_t t = 0; t < plan.map.mesh().triangles.size(); ++t)
    distances.push_back(style.spacing_mm /
                        GradientLength(plan.map, *field, static_cast<int32_t>(t)));
  return distances;
}

}  // namespace slicefarm::texture
