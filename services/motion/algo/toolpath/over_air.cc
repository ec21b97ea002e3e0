#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "common/geometry/measure.h"
#include "common/model/bead_section.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/toolpath/bridge_thread.h"
#include "services/motion/algo/toolpath/feature_groups.h"
#include "services/motion/algo/toolpath/toolpath_builder.h"

// Walls that are not completely on the layer below.

namespace slicefarm::motion {
namespace {

/// Rest on the layer below, in percent, for which walls above curled edges are slowed down. An edge
/// that has risen by a tenth of a millimetre or more leaves about half of the bead's height.
constexpr uint8_t kCurledRest = 50;

}  // namespace

/// Returns the needed resolution of the rest below, or nothing if the layer below has no effect.
std::optional<RestSteps> ToolpathBuilder::RestUnder(const Path& path) const {
  if (below_ == nullptr || !IsWall(path.feature)) return std::nullopt;
  const RegionMotion& region = options_.speeds[static_cast<size_t>(path.settings)];
  const CoolingOptions& cooling = options_.tool().cooling;
  if (region.dynamic_overhangs || cooling.dynamic_fan || CoolsByRest(cooling))
    return RestSteps::kAll;
  if (!region.bridging_walls) return std::nullopt;
  return RestSteps::kAirAlone;
}

/// Prints a wall in pieces with different rest on the layer below.
void ToolpathBuilder::PrintOverAir(const SimplifiedPath& simple, RestSteps steps,
                                   double speed_mm_s) {
  const Path& path = simple.path;
  std::vector<PathSegment> segments(SegmentsOf(path));
  for (size_t i = 0; i < segments.size(); ++i) segments[i] = SegmentOf(path, i);
  Point from = path.points.front();
  for (const RestingPiece& piece : PiecesOver(*below_, steps, segments)) {
    at_.on_arc = simple.on_arc[piece.segment];
    at_.rest = piece.rest;
    PrintPiece(path, {from, piece.to, segments[piece.segment].width_nm}, piece.rest, speed_mm_s);
    from = piece.to;
  }
  at_.rest = kFullRest;
}

/// Prints a piece of a wall with one rest on the layer below: slower where that layer has curled
/// up.
void ToolpathBuilder::PrintPiece(const Path& path, const PathSegment& piece, uint8_t rest,
                                 double speed_mm_s) {
  if (curled_ == nullptr)
    return PrintAbove(path, piece, rest, speeds_.OverAir(path, speed_mm_s, rest));
  Point from = piece.from;
  for (const RestingPiece& part : PiecesOver(*curled_, RestSteps::kAirAlone, {&piece, 1})) {
    const uint8_t counted = part.rest > 0 ? std::min(rest, kCurledRest) : rest;
    PrintAbove(path, {from, part.to, piece.width_nm}, rest,
               speeds_.OverAir(path, speed_mm_s, counted));
    from = part.to;
  }
}

void ToolpathBuilder::PrintAbove(const Path& path, const PathSegment& piece, uint8_t rest,
                                 double speed_mm_s) {
  const RegionMotion& region = options_.speeds[static_cast<size_t>(path.settings)];
  if (rest == 0 && region.bridging_walls) {
    PrintBridges(path, piece.from, piece.to, piece.width_nm, speed_mm_s);
  } else {
    PrintSegment(piece.from, piece.to, BeadOf(piece.width_nm, speed_mm_s));
  }
}

/// Prints a piece of a wall over air: as a thread, except over supports, where a thread would weld.
void ToolpathBuilder::PrintBridges(const Path& path, Point from, Point to, Coord width_nm,
                                   double speed_mm_s) {
  if (above_supports_ == nullptr) return PrintBridge(path, from, to, width_nm, speed_mm_s, true);
  const PathSegment whole = {from, to, width_nm};
  for (const RestingPiece& piece :
       PiecesOver(*above_supports_, RestSteps::kAirAlone, {&whole, 1})) {
    PrintBridge(path, from, piece.to, width_nm, speed_mm_s, piece.rest == 0);
    from = piece.to;
  }
}

/// Prints a piece of a wall like a bridge. `thread`: allows a thread if the settings want threads.
void ToolpathBuilder::PrintBridge(const Path& path, Point from, Point to, Coord width_nm,
                                  double speed_mm_s, bool thread) {
  const RegionMotion& region = options_.speeds[static_cast<size_t>(path.settings)];
  constexpr Feature kBridge = Feature::kOverhangPerimeter;
  const double bridge_mm_s = region.speed_mm_s[static_cast<size_t>(kBridge)];
  if (!region.dynamic_overhangs && bridge_mm_s > 0) speed_mm_s = bridge_mm_s;
  Bead bead = BeadOf(width_nm, speed_mm_s);
  double section_mm2 = SectionMm2(width_nm, bead_height_nm_) * region.bridge_flow;
  if (region.thick_bridges && thread) {
    const double thread_mm = ThreadMm(region, options_.tool().nozzle_diameter_mm);
    section_mm2 = DiscMm2(thread_mm);
    bead.width_nm = FromMm(thread_mm);
    at_.height_um = ToUm(bead.width_nm);
  }
  section_mm2 *= options_.tool().extrusion_multiplier * FlowOf(kBridge, region);
  bead.filament_per_mm = section_mm2 / filament_area_mm2_ * kFilamentUnitsPerMm;
  bead.feed_rate =
      FeedRate(PrintSpeeds::LimitedByFlow(speed_mm_s, section_mm2, bead.largest_flow_mm3_s));
  at_.feature = kBridge;
  print_acceleration_ = accelerations_.Print(kBridge);
  const int64_t before = filament_;
  PrintSegment(from, to, bead);
  const double length_mm = ToMm(Distance(from, to));
  stats_.features[static_cast<size_t>(kBridge)].Add(UseOf(length_mm, filament_ - before));
  bridged_mm_ += length_mm;
  bridged_filament_ += filament_ - before;
  at_.feature = path.feature;
  at_.height_um = ToUm(bead_height_nm_);
  print_acceleration_ = accelerations_.Print(path.feature);
}

}  // namespace slicefarm::motion
