#include "services/exposure/algo/expose_region.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/base/error.h"
#include "common/geometry/moved.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/exposure/algo/scan/block_order.h"
#include "services/exposure/algo/scan/contour_starts.h"
#include "services/exposure/algo/scan/hatch.h"
#include "services/exposure/algo/scan/hatch_angle.h"
#include "services/exposure/algo/scan/inside.h"
#include "services/exposure/algo/scan/layer_shift.h"
#include "services/exposure/algo/scan/outline_check.h"
#include "services/exposure/algo/scan/ring_scan.h"
#include "services/exposure/algo/scan/thin_walls.h"

namespace slicefarm::exposure {
namespace {

absl::Status Strayed(const StrayVector& stray, const RegionInput& region) {
  const Point at = stray.from + region.shift;
  const auto place = [](Coord nm) { return fmt::format("{:.3f}", ToMm(static_cast<double>(nm))); };
  return MakeError(
      absl::StatusCode::kInternal, Reason::kInternal,
      fmt::format("layer {}: a {} vector at ({}, {}) mm leaves the compensated outline; this is an "
                  "internal error of slicefarm, and nothing was written",
                  region.layer, ExposureKindName(stray.kind), place(at.x), place(at.y)),
      {{"layer", fmt::format("{}", region.layer)}, {"x_mm", place(at.x)}, {"y_mm", place(at.y)}});
}

/// Scan of one region, which adds one group after the other.
class RegionScan {
 public:
  RegionScan(const RegionInput& region, const ExposureOptions& options, Point from,
             const CancelToken& cancel, CutCounts& counts)
      : region_(region), options_(options), at_(from), cancel_(cancel), counts_(counts) {}

  absl::StatusOr<std::vector<ExposureGroup>> Scan() {
    FindSkins();
    if (options_.thin_walls || HatchTrim(options_) > 0)
      narrow_ = NarrowParts(region_.outlines, NarrowDepth(options_, border_lines_));
    if (options_.contours_first) AddContours();
    if (absl::Status status = AddThinWalls(); !status.ok()) return status;
    if (absl::Status status = AddInside(); !status.ok()) return status;
    if (!options_.contours_first) AddContours();
    if (const auto stray = FindStray(groups_, region_.outlines, options_))
      return Strayed(*stray, region_);
    return std::move(groups_);
  }

 private:
  ExposureGroup NewGroup(ExposureKind kind) const {
    ExposureGroup group;
    group.object = region_.object;
    group.settings = region_.settings;
    group.kind = kind;
    return group;
  }

  void Add(ExposureGroup group) {
    if (group.points.empty()) return;
    at_ = group.points.back();
    groups_.push_back(std::move(group));
  }

  /// Adds the rings of an area as closed lines, in an order that is nearest first or against the
  /// gas flow. `share`: start of each line as a fraction of its length, if starts are scattered.
  void AddRings(const MultiPolygon& area, double share, ExposureGroup& group) {
    std::vector<Polyline> rings;
    std::vector<ScanBlock> blocks;
    for (const Polygon& ring : Rings(area)) {
      rings.push_back(StartedContour(ring, options_.contour_start, share, at_));
      const Point start = rings.back().front();
      blocks.push_back({.start = start, .end = start, .middle = MiddleOf(Bounds(rings.back()))});
    }
    const JumpOrder order = options_.jump_order == JumpOrder::kAgainstGas ? JumpOrder::kAgainstGas
                                                                          : JumpOrder::kNearest;
    for (const BlockTurn& turn : OrderBlocks(blocks, order, at_, options_.gas_flow_deg)) {
      group.AddLine(rings[turn.block]);
      at_ = rings[turn.block].back();
    }
  }

  /// Adds contours from the innermost to the outermost, so that the outermost is drawn on solid
  /// material.
  void AddContours() {
    ExposureGroup group = NewGroup(ExposureKind::kContour);
    group.run_nm = options_.contour_run_nm;
    for (int32_t i = options_.contours - 1; i >= 0; --i) {
      const Coord inset = options_.beam_compensation_nm + i * options_.contour_distance_nm;
      AddRings(FastOffset(region_.outlines, -inset), ContourShare(region_.layer, i), group);
    }
    Add(std::move(group));
  }

  absl::Status AddThinWalls() {
    if (!options_.thin_walls) return absl::OkStatus();
    const auto lines =
        MiddleLines(region_.outlines, narrow_, LineLevels(options_, border_lines_), cancel_);
    if (!lines.ok()) return lines.status();
    ExposureGroup group = NewGroup(ExposureKind::kThinWall);
    group.run_nm = options_.contour_run_nm;
    for (const Polyline& line : *lines) group.AddLine(line);
    Add(std::move(group));
    return absl::OkStatus();
  }

  /// Finds the skins and the number of border lines (layer_shift.h). A layer with skins has no
  /// border lines, because one line would pass through several skins.
  void FindSkins() {
    area_ = FastOffset(region_.outlines, -InsideInset(options_));
    if (!region_.neighbours.above.empty() || !region_.neighbours.below.empty())
      skins_ =
          PartSkins({area_, InsideOf(ExposureKind::kUpskin), InsideOf(ExposureKind::kDownskin)},
                    region_.section, region_.neighbours, options_.skin_overlap_nm);
    if (!skins_.downskin.empty() || !skins_.upskin.empty()) return;
    skins_ = {};
    border_lines_ = BorderLines(region_.layer, options_);
    if (border_lines_ > 0)
      area_ = FastOffset(region_.outlines, -InsideInset(options_, border_lines_));
  }

  /// Returns the region's options with the hatch distance of this kind.
  ExposureOptions OptionsOf(ExposureKind kind) const {
    ExposureOptions options = options_;
    options.hatch_distance_nm = options_.HatchDistanceNm(kind);
    return options;
  }

  MultiPolygon InsideOf(ExposureKind kind) const {
    const Coord inset = InsideInset(OptionsOf(kind));
    return inset == InsideInset(options_) ? area_ : FastOffset(region_.outlines, -inset);
  }

  /// Adds the hatch's border lines, from the contour inwards.
  void AddBorderLines() {
    ExposureGroup group = NewGroup(ExposureKind::kHatch);
    int32_t number = options_.contours;
    for (const Coord inset : BorderInsets(options_, border_lines_))
      AddRings(FastOffset(region_.outlines, -inset), ContourShare(region_.layer, number++), group);
    Add(std::move(group));
  }

  absl::Status AddInside() {
    AddBorderLines();
    if (area_.empty()) return absl::OkStatus();
    if (skins_.downskin.empty() && skins_.upskin.empty())
      return AddArea({area_, {}, narrow_}, ExposureKind::kHatch);
    absl::Status status = AddArea({skins_.core, area_, narrow_}, ExposureKind::kHatch);
    if (status.ok()) status = AddArea({skins_.downskin, area_, narrow_}, ExposureKind::kDownskin);
    if (status.ok()) status = AddArea({skins_.upskin, area_, narrow_}, ExposureKind::kUpskin);
    return status;
  }

  /// Adds hatch or rings in an area of one kind (core or a skin).
  absl::Status AddArea(HatchRegion region, ExposureKind kind) {
    if (absl::Status status = cancel_.Check(); !status.ok()) return status;
    ExposureGroup group = NewGroup(kind);
    const ExposureOptions options = OptionsOf(kind);
    if (IsRings(options.strategy)) {
      if (absl::Status status =
              ScanByRings(region.area, options, region_.layer, at_, cancel_, group, counts_);
          !status.ok())
        return status;
    } else {
      const double angle = HatchAngle(options, region_.layer);
      const Point shift = GridShift(region_.layer, angle, options);
      region = {Moved(std::move(region.area), Point{} - shift),
                Moved(std::move(region.whole), Point{} - shift),
                Moved(std::move(region.narrow), Point{} - shift),
                static_cast<double>(HatchTrim(options))};
      auto points = Hatch(region, angle, options, at_ - shift);
      if (!points.ok()) return points.status();
      for (Point& p : *points) p = p + shift;
      group.points = *std::move(points);
      group.run_nm = options.skywriting_nm;
    }
    Add(std::move(group));
    return absl::OkStatus();
  }

  const RegionInput& region_;
  const ExposureOptions& options_;
  Point at_;
  const CancelToken& cancel_;
  CutCounts& counts_;
  MultiPolygon area_;  ///< area that rings or hatch fill
  SkinAreas skins_;    ///< empty if all of the area is core
  int32_t border_lines_ = 0;
  MultiPolygon narrow_;  ///< narrow parts: lines along the outline already melt their whole inside
  std::vector<ExposureGroup> groups_;
};

}  // namespace

absl::StatusOr<std::vector<ExposureGroup>> ExposeRegion(const RegionInput& region,
                                                        const ExposureOptions& options, Point from,
                                                        const CancelToken& cancel,
                                                        CutCounts& counts) {
  return RegionScan(region, options, from, cancel, counts).Scan();
}

}  // namespace slicefarm::exposure
