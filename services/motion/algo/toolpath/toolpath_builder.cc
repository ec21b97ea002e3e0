#include "services/motion/algo/toolpath/toolpath_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/portable_math.h"
#include "common/gcode/gcode_text.h"
#include "common/geometry/arc_fit.h"
#include "common/geometry/covers.h"
#include "common/geometry/measure.h"
#include "common/model/bead_section.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/firmware/material_mix.h"
#include "services/motion/algo/toolpath/bridge_thread.h"
#include "services/motion/algo/toolpath/divided_path.h"
#include "services/motion/algo/toolpath/feature_groups.h"
#include "services/motion/algo/toolpath/lifts.h"
#include "services/motion/algo/toolpath/open_seam.h"
#include "services/motion/algo/toolpath/reversal.h"
#include "services/motion/algo/toolpath/scarf.h"
#include "services/motion/algo/toolpath/spiral_turn.h"
#include "services/motion/algo/toolpath/travel_ramp.h"

namespace slicefarm::motion {
namespace {

/// Largest filament of one move, in 1e-5 mm: more than any printer can push.
constexpr int64_t kMostFilament = 1'000'000'000;

/// Largest relative difference between the path's width and widths of solid infill and gap fill,
/// which are inside the part. With a larger value, the flow would change by more than 30 % more
/// than ten times per metre.
constexpr double kFillWidthShare = 0.085;

int32_t Units(double filament_mm) {
  return static_cast<int32_t>(std::lround(filament_mm * kFilamentUnitsPerMm));
}

}  // namespace

ToolpathBuilder::ToolpathBuilder(const MotionOptions& options, const LayerFrame& frame,
                                 Coord bead_height_nm, Ground ground, const LayerBelow* below,
                                 const LayerBelow* above_supports, const LayerBelow* curled)
    : options_(options),
      first_layer_(frame.index == 0),
      layer_(frame.index),
      speeds_(options, ground, frame.index),
      accelerations_(AccelerationsFor(options, ground)),
      filament_area_mm2_(FilamentAreaMm2(options)),
      bead_height_nm_(bead_height_nm),
      below_(below),
      above_supports_(above_supports),
      curled_(curled),
      wipe_(WipeOf(options)) {
  const RetractionOptions& retraction = options.tool().retraction;
  const Coord offset_nm = FromMm(options.z_offset_mm);
  z_um_ = ToUm(frame.print_z_nm + offset_nm);
  bottom_um_ = ToUm(frame.print_z_nm - bead_height_nm + offset_nm);
  retract_units_ = Units(retraction.length_mm);
  extra_units_ = Units(retraction.restart_extra_mm);
  pulled_units_ = retract_units_;
  const int32_t lift_um = ToUm(FromMm(LiftOf(retraction)));
  lift_um_ = LiftsIn(retraction, frame) ? lift_um : 0;
  start_lift_um_ = LiftsToStart(retraction, frame) ? lift_um : 0;
  path_.start_z_um = ToUm(frame.print_z_nm - frame.height_nm + offset_nm);
  at_.z_um = path_.start_z_um;
}

void ToolpathBuilder::BeginRetracted(double length_mm) { pulled_units_ = Units(length_mm); }

void ToolpathBuilder::BeginPath(const Path& path, const SimplifiedPath& simple) {
  print_acceleration_ = accelerations_.Print(path.feature);
  at_.feature = path.feature;
  if (set_jerk_ == 0) set_jerk_ = accelerations_.jerks.Print(path.feature);
  thread_nm_ = ThreadNm(path, bead_height_nm_, options_);
  at_.height_um = ToUm(thread_nm_ > 0 ? thread_nm_ : bead_height_nm_);
  at_.of_surface = IsWall(path.feature) && path.inset <= 1;
  flow_ = simple.flow * FlowOf(path.feature, options_.speeds[static_cast<size_t>(path.settings)]);
}

/// Returns the factor of the settings on the plastic of a feature.
double ToolpathBuilder::FlowOf(Feature feature, const RegionMotion& region) const {
  return region.flow[static_cast<size_t>(feature)] * (first_layer_ ? region.first_layer_flow : 1);
}

void ToolpathBuilder::AddTurn(const Path& path, const SpiralTurn& turn, const MultiPolygon& below) {
  const SimplifiedPath simple =
      Simplified(path, {.tolerance_nm = options_.resolution_nm, .bead_height_nm = bead_height_nm_});
  BeginPath(path, simple);
  const int64_t filament_before = filament_;
  const int32_t top_um = std::exchange(z_um_, bottom_um_);
  const bool goes_on = turn.blends && turn.from;
  Approach(goes_on ? *turn.from : StartOf(path), {.hidden = !retracted_, .corners = {}});
  Restart();
  z_um_ = top_um;
  PrintTurn(simple, turn, below, speeds_.Of(path, ToMm(PathLength(path))));
  EndPath(simple.path, /*moved_on=*/false, filament_before);
}

void ToolpathBuilder::Add(const Path& path, const Travel& travel,
                          std::optional<double> contour_mm) {
  const RegionMotion& region = options_.speeds[static_cast<size_t>(path.settings)];
  const bool scarfed =
      !first_layer_ && HasScarf(path, region.scarf) && !OverhangsAtStart(path, region.scarf);
  const bool reversed = IsReversed(path, region.reversal, layer_, below_);
  AddPath(reversed ? Reversed(path) : path, travel, contour_mm, scarfed, reversed);
}

/// Returns true if a wall's start rests too little on the layer below for a scarf.
bool ToolpathBuilder::OverhangsAtStart(const Path& path, const ScarfOptions& scarf) const {
  if (!LimitsOverhang(scarf) || below_ == nullptr) return false;
  return 1 - below_->RestOf(path.points.front(), path.WidthAt(0)) >= scarf.most_overhang;
}

void ToolpathBuilder::AddPath(const Path& path, const Travel& travel,
                              std::optional<double> contour_mm, bool scarfed, bool reversed) {
  const RegionMotion& region = options_.speeds[static_cast<size_t>(path.settings)];
  const bool arcs = options_.arc_fitting != ArcFitting::kDisabled;
  // A scarf divides the loop again. Therefore the loop is not simplified here if arcs are searched
  // in the result.
  const SimplifyOptions simplify = {.tolerance_nm = scarfed && arcs ? 0 : options_.resolution_nm,
                                    .bead_height_nm = bead_height_nm_,
                                    .keep_arcs = arcs,
                                    .width_share = IsFill(path.feature) ? kFillWidthShare : 0,
                                    .inside = path.feature == Feature::kPerimeter};
  const SimplifiedPath simple = path.widths_nm.size() == 1
                                    ? Simplified(path, simplify)
                                    : Simplified(DividedByWidth(path, bead_height_nm_), simplify);
  const double speed_mm_s = speeds_.Of(path, contour_mm.value_or(ToMm(PathLength(path))));
  const std::vector<ContourPoint> contour = ContourOf(simple, region);
  scarfed = scarfed && contour.empty();
  BeginPath(path, simple);
  reversed_ = reversed;
  const int64_t filament_before = filament_;
  const bool outer =
      path.closed && path.feature == Feature::kExternalPerimeter && !scarfed && contour.empty();
  if (path_.approach == Toolpath::kNone) {
    Approach(StartOf(path), retracted_ ? Travel{} : travel);
    Restart();
  } else {
    const bool inside = outer && region.wipe_before_outer;
    GoTo(inside ? InsideOf(path, reversed) : StartOf(path), travel);
    Restart();
    if (inside) GlideTo(StartOf(path), speed_mm_s);
  }
  if (!contour.empty()) {
    PrintContour(simple.path, contour, speed_mm_s);
  } else if (scarfed) {
    at_.on_arc = arcs;
    PrintScarf(simple.path, region.scarf, speed_mm_s);
  } else {
    PrintSegments(IsLoopOfWalls(path) ? WithOpenSeam(simple, FromMm(options_.seam_gap_mm)) : simple,
                  speed_mm_s);
  }
  at_.on_arc = false;
  if (outer && region.wipe_on_loops) GlideTo(InsideOf(path, reversed), speed_mm_s);
  EndPath(simple.path, scarfed || !contour.empty(), filament_before);
}

/// Returns the points of a path that follows the surface; empty for a level path.
std::vector<ContourPoint> ToolpathBuilder::ContourOf(const SimplifiedPath& simple,
                                                     const RegionMotion& region) const {
  if (follower_ == nullptr) return {};
  const bool opens = IsLoopOfWalls(simple.path) && options_.seam_gap_mm > 0;
  return opens ? follower_->Follow(WithOpenSeam(simple, FromMm(options_.seam_gap_mm)).path, region)
               : follower_->Follow(simple.path, region);
}

void ToolpathBuilder::EndPath(const Path& path, bool moved_on, int64_t filament_before) {
  moved_on_ = moved_on;
  if (path.feature != Feature::kGapFill) after_top_ = IsTop(path.feature);
  wipe_path_.clear();
  if (wipe_.length_mm > 0 && !moved_on)
    wipe_path_ = WipePath(path, wipe_.length_mm, WipeShiftOf(path));
  after_inner_ = path.feature == Feature::kPerimeter;
  Count(path, filament_ - filament_before);
}

Toolpath ToolpathBuilder::Finish() {
  Retract();
  return std::move(path_);
}

Toolpath ToolpathBuilder::FinishAt(const std::optional<ExitTravel>& exit_travel) {
  if (exit_travel && !path_.moves.empty()) {
    GoTo(exit_travel->to, exit_travel->travel);
    MoveZ(z_um_);
  } else {
    Restart();
  }
  return std::move(path_);
}

ToolpathBuilder::Bead ToolpathBuilder::BeadOf(Coord width_nm, double speed_mm_s) const {
  const double section_mm2 =
      SectionMm2(width_nm, bead_height_nm_) * options_.tool().extrusion_multiplier * flow_;
  const double largest_mm3_s = speeds_.LargestFlow(width_nm, bead_height_nm_);
  const double limited_mm_s = PrintSpeeds::LimitedByFlow(speed_mm_s, section_mm2, largest_mm3_s);
  return {width_nm, section_mm2 / filament_area_mm2_ * kFilamentUnitsPerMm,
          FeedRate(speeds_.OutsideResonance(at_.feature, limited_mm_s)), largest_mm3_s};
}

void ToolpathBuilder::PrintSegments(const SimplifiedPath& simple, double speed_mm_s) {
  const Path& path = simple.path;
  if (const auto steps = RestUnder(path)) return PrintOverAir(simple, *steps, speed_mm_s);
  Bead bead = BeadOf(path.widths_nm.front(), speed_mm_s);
  for (size_t i = 0; i < SegmentsOf(path); ++i) {
    const PathSegment segment = SegmentOf(path, i);
    if (segment.width_nm != bead.width_nm) bead = BeadOf(segment.width_nm, speed_mm_s);
    at_.on_arc = simple.on_arc[i];
    PrintSegment(segment.from, segment.to, bead);
  }
}

namespace {

/// Returns the speed of a scarf of a wall: no more than the wall's.
double ScarfSpeed(const ScarfOptions& options, double wall_mm_s) {
  const double asked =
      options.speed_mm_s > 0 ? options.speed_mm_s : options.speed_ratio * wall_mm_s;
  return std::min(asked, wall_mm_s);
}

}  // namespace

void ToolpathBuilder::PrintScarf(const Path& path, const ScarfOptions& options, double speed_mm_s) {
  const auto height_um = static_cast<double>(z_um_ - bottom_um_);
  MoveZ(bottom_um_ + static_cast<int32_t>(std::lround(options.start_height_ratio * height_um)));
  Point from = path.points.front();
  for (const ScarfPiece& piece : ScarfedLoop(path, options)) {
    // The speed is that of a full bead on both passes.
    const bool is_scarf = piece.flow < 1;
    Bead bead = BeadOf(piece.width_nm, is_scarf ? ScarfSpeed(options, speed_mm_s) : speed_mm_s);
    bead.filament_per_mm *= piece.flow * (is_scarf ? options.flow : 1);
    at_.z_um = bottom_um_ + static_cast<int32_t>(std::lround(piece.rise * height_um));
    at_.height_um = std::max(1, static_cast<int32_t>(std::lround(piece.flow * height_um)));
    PrintSegment(from, piece.to, bead);
    from = piece.to;
  }
}

void ToolpathBuilder::PrintContour(const Path& path, std::span<const ContourPoint> points,
                                   double speed_mm_s) {
  const int32_t height_um = at_.height_um;
  std::vector<PathSegment> segments;
  for (size_t i = 1; i < points.size(); ++i)
    segments.push_back({points[i - 1].point, points[i].point, points[i].width_nm});
  MoveZ(z_um_ + ToUm(points.front().up_nm));
  Point from = points.front().point;
  auto from_up = static_cast<double>(points.front().up_nm);
  for (const RestingPiece& part : PiecesUnder(path, segments)) {
    const PathSegment& segment = segments[part.segment];
    const double length = Distance(segment.from, segment.to);
    const double share = length > 0 ? Distance(segment.from, part.to) / length : 1;
    const auto begin = static_cast<double>(points[part.segment].up_nm);
    const auto end = static_cast<double>(points[part.segment + 1].up_nm);
    const double up = begin + share * (end - begin);
    const double left = 1 + (from_up + up) / 2 / static_cast<double>(bead_height_nm_);
    at_.z_um = z_um_ + ToUm(std::llround(up));
    at_.height_um = std::max(1, static_cast<int32_t>(std::lround(left * height_um)));
    at_.rest = part.rest;
    Bead bead = BeadOf(segment.width_nm, TurnSpeed(path, speed_mm_s, part.rest));
    // The flow of ironing is small already.
    if (path.feature != Feature::kIroning) bead.filament_per_mm *= left;
    PrintSegment(from, part.to, bead);
    from = part.to;
    from_up = up;
  }
  at_.rest = kFullRest;
  at_.height_um = height_um;
  MoveZ(z_um_);
}

void ToolpathBuilder::PrintTurn(const SimplifiedPath& simple, const SpiralTurn& turn,
                                const MultiPolygon& below, double speed_mm_s) {
  const auto height_um = static_cast<double>(z_um_ - bottom_um_);
  const Coord width_nm = simple.path.widths_nm.front();
  const std::vector<TurnPiece> turns = TurnOf(simple.path, turn, below, options_.spiral);
  std::vector<PathSegment> segments;
  Point from{FromUm(at_.x_um), FromUm(at_.y_um)};
  for (const TurnPiece& piece : turns)
    segments.push_back({segments.empty() ? from : segments.back().to, piece.to, width_nm});
  for (const RestingPiece& part : PiecesUnder(simple.path, segments)) {
    const PathSegment& segment = segments[part.segment];
    const TurnPiece& piece = turns[part.segment];
    const double from_rise = part.segment > 0 ? turns[part.segment - 1].rise : 0;
    const double length = Distance(segment.from, segment.to);
    const double share = length > 0 ? Distance(segment.from, part.to) / length : 1;
    const double rise = from_rise + share * (piece.rise - from_rise);
    at_.height_um = std::max(1, static_cast<int32_t>(std::lround(piece.flow * height_um)));
    at_.z_um = bottom_um_ + static_cast<int32_t>(std::lround(rise * height_um));
    at_.rest = part.rest;
    Bead bead = BeadOf(width_nm, TurnSpeed(simple.path, speed_mm_s, part.rest));
    bead.filament_per_mm *= piece.flow;
    PrintSegment(from, part.to, bead);
    from = part.to;
  }
  at_.rest = kFullRest;
}

std::vector<RestingPiece> ToolpathBuilder::PiecesUnder(
    const Path& path, std::span<const PathSegment> segments) const {
  if (const auto steps = RestUnder(path)) return PiecesOver(*below_, *steps, segments);
  std::vector<RestingPiece> pieces(segments.size());
  for (size_t i = 0; i < segments.size(); ++i) pieces[i] = {i, segments[i].to};
  return pieces;
}

/// Returns the speed of a turn; over air it is a bridge's speed.
double ToolpathBuilder::TurnSpeed(const Path& path, double speed_mm_s, uint8_t rest) const {
  const RegionMotion& region = options_.speeds[static_cast<size_t>(path.settings)];
  const double bridge_mm_s = region.speed_mm_s[static_cast<size_t>(Feature::kOverhangPerimeter)];
  const bool as_bridge = rest == 0 && region.bridging_walls && !region.dynamic_overhangs;
  if (as_bridge && bridge_mm_s > 0) return bridge_mm_s;
  return speeds_.OverAir(path, speed_mm_s, rest);
}

/// Prints a segment as one move, or as several short moves if materials mix.
void ToolpathBuilder::PrintSegment(Point from, Point to, const Bead& bead) {
  const auto moves =
      options_.material_field.empty()
          ? 1
          : std::max<int64_t>(1, std::llround(std::ceil(ToMm(Distance(from, to)) / kMixedMoveMm)));
  Point last = from;
  for (int64_t i = 1; i <= moves; ++i) {
    const Point next = i == moves ? to
                                  : Point{from.x + (to.x - from.x) * i / moves,
                                          from.y + (to.y - from.y) * i / moves};
    PrintTo(last, next, bead);
    last = next;
  }
}

void ToolpathBuilder::PrintTo(Point from, Point to, const Bead& bead) {
  owed_ += ToMm(Distance(from, to)) * bead.filament_per_mm;
  const int32_t x_um = ToUm(to.x);
  const int32_t y_um = ToUm(to.y);
  if (x_um == at_.x_um && y_um == at_.y_um) return;
  const double length_mm = Hypot(x_um - at_.x_um, y_um - at_.y_um) / kUmPerMm;
  at_.x_um = x_um;
  at_.y_um = y_um;
  // A move without filament would count as a travel.
  at_.filament = static_cast<int32_t>(std::clamp<int64_t>(std::lround(owed_), 1, kMostFilament));
  owed_ -= at_.filament;
  filament_ += at_.filament;
  // Rounding to whole micrometres shortens pieces, so their real section is larger than their
  // bead's, by up to a few percent.
  const double volume_mm3 = at_.filament * filament_area_mm2_ / kFilamentUnitsPerMm;
  at_.feed_rate =
      PrintSpeeds::WithinFlow(bead.feed_rate, volume_mm3 / length_mm, bead.largest_flow_mm3_s);
  at_.width_um = ToUm(thread_nm_ > 0 ? thread_nm_ : bead.width_nm);
  Push(MoveKind::kPrint, print_acceleration_);
}

void ToolpathBuilder::Approach(Point to, const Travel& travel) {
  if (!travel.hidden) Retract();
  MoveZ(z_um_ + (retracted_ ? start_lift_um_ : 0));
  path_.approach = path_.moves.size();
  ++stats_.travels;
  for (size_t i = 0; i < travel.corners.size(); ++i) {
    const Point corner = travel.corners[i];
    const Point next = i + 1 < travel.corners.size() ? travel.corners[i + 1] : to;
    stats_.travel_mm += ToMm(Distance(corner, next));
    MoveTo(ToUm(corner.x), ToUm(corner.y));
  }
  MoveTo(ToUm(to.x), ToUm(to.y));
}

void ToolpathBuilder::GoTo(Point to, const Travel& travel) {
  std::vector<PointUm> points;
  const auto add = [&](Point place) {
    const PointUm next{ToUm(place.x), ToUm(place.y)};
    const PointUm last = points.empty() ? PointUm{at_.x_um, at_.y_um} : points.back();
    if (next != last) points.push_back(next);
  };
  for (const Point corner : travel.corners) add(corner);
  add(to);
  if (points.empty()) return;
  short_travel_ = at_.feature == Feature::kExternalPerimeter &&
                  MovesMm(points) < options_.tool().retraction.min_travel_mm;
  const bool goes_back =
      travel.over_wall || MovesMm(points) >= options_.tool().retraction.min_travel_mm;
  if ((!travel.hidden || moved_on_) && goes_back) {
    Retract();
    const bool rises = RisesAfter(options_.tool().retraction.lift_after, first_layer_, after_top_);
    const int32_t lift_um = rises ? lift_um_ : 0;
    if (lift_um != 0 && RisesAlongTravel(options_.tool().retraction)) {
      Rise(points);
      return;
    }
    if (lift_um != 0) MoveZ(z_um_ + lift_um);
  }
  stats_.travel_mm += MovesMm(points);
  ++stats_.travels;
  for (const PointUm place : points) MoveTo(place.x, place.y);
}

/// Returns the points of a travel on which the nozzle rises. A circle that would leave the area of
/// travels becomes a straight rise.
std::vector<RampPoint> ToolpathBuilder::RiseOf(std::span<const PointUm> points) const {
  const RetractionOptions& retraction = options_.tool().retraction;
  const PointUm from{at_.x_um, at_.y_um};
  if (!retraction.spiral) return RampedTravel(from, points, retraction, below_);
  std::vector<RampPoint> rise = SpiralledTravel(from, points, retraction);
  const auto is_outside = [&](const RampPoint& point) {
    return !Covers(options_.travel_area, {FromUm(point.point.x), FromUm(point.point.y)});
  };
  const auto circle = std::span(rise).first(rise.size() - points.size());
  if (!options_.travel_area.empty() && std::ranges::any_of(circle, is_outside))
    rise.erase(rise.begin(), rise.begin() + std::ssize(circle) - 1);
  return rise;
}

void ToolpathBuilder::Rise(std::span<const PointUm> points) {
  stats_.travel_mm += MovesMm(points);
  ++stats_.travels;
  for (const auto [place, up_um] : RiseOf(points)) {
    if (place == PointUm{at_.x_um, at_.y_um}) {
      MoveZ(z_um_ + up_um);
      continue;
    }
    at_.z_um = z_um_ + up_um;
    MoveTo(place.x, place.y);
  }
}

/// Returns the length in mm of a travel that begins at the nozzle's position.
double ToolpathBuilder::MovesMm(std::span<const PointUm> points) const {
  double move_mm = 0;
  PointUm last{at_.x_um, at_.y_um};
  for (const PointUm next : points) {
    move_mm += Hypot(next.x - last.x, next.y - last.y) / kUmPerMm;
    last = next;
  }
  return move_mm;
}

void ToolpathBuilder::MoveTo(int32_t x_um, int32_t y_um) {
  at_.x_um = x_um;
  at_.y_um = y_um;
  at_.filament = 0;
  at_.feed_rate = FeedRate(TravelSpeed(options_, first_layer_));
  Push(MoveKind::kTravel, short_travel_ && accelerations_.short_travel > 0
                              ? accelerations_.short_travel
                              : accelerations_.Travel(set_acceleration_));
}

void ToolpathBuilder::MoveZ(int32_t z_um) {
  if (at_.z_um == z_um) return;
  at_.z_um = z_um;
  at_.filament = 0;
  at_.feed_rate = FeedRate(TravelSpeedZ(options_));
  Push(MoveKind::kLift, accelerations_.Travel(set_acceleration_));
}

void ToolpathBuilder::Push(MoveKind kind, double acceleration_mm_s2) {
  at_.kind = kind;
  at_.acceleration_mm_s2 = static_cast<float>(acceleration_mm_s2);
  const bool of_travel = kind == MoveKind::kTravel || kind == MoveKind::kLift;
  if (kind == MoveKind::kPrint) print_feed_rate_ = at_.feed_rate;
  if (kind == MoveKind::kPrint || (of_travel && accelerations_.one))
    set_acceleration_ = acceleration_mm_s2;
  if (kind == MoveKind::kPrint) set_jerk_ = accelerations_.jerks.Print(at_.feature);
  if (of_travel) set_jerk_ = accelerations_.jerks.Travel(set_jerk_);
  at_.jerk_mm_s = static_cast<float>(set_jerk_);
  path_.moves.push_back(at_);
}

/// Returns the length and volume of a bead as statistics, without its time.
FeatureUse ToolpathBuilder::UseOf(double length_mm, int64_t filament) const {
  const double filament_mm = static_cast<double>(filament) / kFilamentUnitsPerMm;
  return {0, length_mm, filament_mm, filament_mm * filament_area_mm2_};
}

void ToolpathBuilder::Count(const Path& path, int64_t filament) {
  // Pieces printed as bridges are counted as bridges. Rounding must not make the rest negative.
  const double own_mm = std::max(0.0, ToMm(PathLength(path)) - std::exchange(bridged_mm_, 0));
  const int64_t own_filament = filament - std::exchange(bridged_filament_, 0);
  stats_.features[static_cast<size_t>(path.feature)].Add(UseOf(own_mm, own_filament));
  const Coord reach = *std::max_element(path.widths_nm.begin(), path.widths_nm.end()) / 2;
  stats_.bounds.Add(Bounds(path.points).Grown(reach));
}

}  // namespace slicefarm::motion
