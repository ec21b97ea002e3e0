#include "services/beading/algo/arachne/constant_width_walls.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/round_erode.h"
#include "common/geometry/predicates.h"
#include "common/geometry/rings/simple_rings.h"
#include "common/geometry/rings/simplify.h"
#include "common/geometry/vector.h"
#include "services/beading/algo/arachne/facing_sides.h"
#include "services/beading/algo/arachne/small_fills.h"
#include "services/beading/algo/beads/thick_line.h"

namespace slicefarm::beading {
namespace {

/// Miters that extend less than this beyond their arc stay.
constexpr double kLeastExcessNm = 1'000;
/// Bend in radians above which TryOffset cuts a miter square; slightly reduced because rounding
/// changes angles.
constexpr double kMaxTurn = 1.9;

Vector2 Along(Point a, Point b) {
  const double length = Distance(a, b);
  return ToVector(b - a) / length;
}

/// Lengths that the inset's edges lose to the arc at a corner.
struct Rounding {
  double turn = 0;    ///< turn in radians, for a reflex corner; 0: the corner stays
  double cut_nm = 0;  ///< length cut off both edges
};

std::optional<Rounding> RoundingAt(Point before, Point at, Point after, double distance_nm) {
  if (Orientation(before, at, after) >= 0) return Rounding{};
  const Vector2 in = Along(before, at), out = Along(at, after);
  const double turn = Atan2(-Cross(in, out), Dot(in, out));
  if (turn > kMaxTurn) return std::nullopt;
  if (distance_nm * (1 / Cos(turn / 2) - 1) < kLeastExcessNm) return Rounding{};
  return Rounding{turn, distance_nm * Tan(turn / 2)};
}

/// Appends the points of the arc, from one tangent point to the other. The arc is on the right of
/// the incoming edge.
void AppendArc(Point at, Vector2 in, const Rounding& rounding, double distance_nm, double step,
               Polygon& ring) {
  const double start_x = static_cast<double>(at.x) - in.x() * rounding.cut_nm;
  const double start_y = static_cast<double>(at.y) - in.y() * rounding.cut_nm;
  const double centre_x = start_x + in.y() * distance_nm, centre_y = start_y - in.x() * distance_nm;
  const int pieces = std::max(1, static_cast<int>(std::ceil(rounding.turn / step)));
  for (int i = 0; i <= pieces; ++i) {
    const double angle = rounding.turn * i / pieces;
    const double c = Cos(angle), s = Sin(angle);
    // This is the radius to the start, (-in.y, in.x), turned clockwise.
    ring.push_back({std::llround(centre_x + distance_nm * (-in.y() * c + in.x() * s)),
                    std::llround(centre_y + distance_nm * (in.x() * c + in.y() * s))});
  }
}

/// Number of places on the outline from which an island is first inspected.
constexpr int kLooks = 16;
/// Tolerance of the outline that is judged first.
constexpr Coord kCoarseNm = 50'000;
/// The chords of an eroded inset's arcs may use this part of the tolerance, before simplification.
/// The motion service places long edges by the points beside them, so an arc with few points would
/// shift them.
constexpr double kArcShare = 0.2;

/// Returns true if the beads of all walls fit on both sides everywhere, with infill between them.
/// `radius_nm`: least distance of the middle between two sides. A few looks across the island, and
/// the judgement of an outline with few corners, tell most of the islands that are too narrow.
bool IsWide(const PolygonWithHoles& island, Coord radius_nm, double transition_angle) {
  const double most_turn = std::numbers::pi - transition_angle;
  if (SeesFacingSides(island, 2 * radius_nm, most_turn, kLooks)) return false;
  if (const auto inset = TryOffset({island}, -radius_nm); inset && !inset->has_tips) return true;
  const MultiPolygon coarse = Simplify({island}, kCoarseNm);
  if (coarse.empty() || JudgeWidth(coarse[0], radius_nm, most_turn) != Width::kWide) return false;
  return JudgeWidth(island, radius_nm, most_turn) == Width::kWide;
}

/// Returns the island's inset with round reflex corners, if each edge of the outline has one edge.
std::optional<MultiPolygon> CleanInset(const PolygonWithHoles& island, Coord distance_nm,
                                       Coord tolerance_nm) {
  std::optional<CleanOffset> inset = TryOffset({island}, -distance_nm);
  if (!inset) return std::nullopt;
  const auto round = [&](Polygon& ring) {
    std::optional<Polygon> rounded = RoundReflexCorners(ring, distance_nm, tolerance_nm);
    if (rounded) ring = *std::move(rounded);
    return rounded.has_value();
  };
  for (PolygonWithHoles& part : inset->polygons) {
    if (!round(part.outer)) return std::nullopt;
    if (!std::all_of(part.holes.begin(), part.holes.end(), round)) return std::nullopt;
  }
  return std::move(inset->polygons);
}

Polygon Simplified(Polygon ring, Coord tolerance_nm) {
  std::vector<Coord> none(ring.size(), 0);
  return SimplifyThickLine({true, std::move(ring), std::move(none)}, tolerance_nm).points;
}

/// Returns the same inset of an island in which edges vanish. It has no more points than the beads
/// along a skeleton. Returns nullopt if a ring vanishes or splits.
std::optional<MultiPolygon> ErodedInset(const PolygonWithHoles& island, Coord distance_nm,
                                        const VariableWallOptions& options) {
  const auto tolerance = static_cast<double>(options.tolerance_nm);
  auto inset = TryRoundErode(island, distance_nm, std::llround(kArcShare * tolerance));
  if (!inset || inset->size() != 1 || inset->front().holes.size() != island.holes.size())
    return std::nullopt;
  std::vector<const Polygon*> rings;
  for (PolygonWithHoles& part : *inset) {
    part.outer = Simplified(std::move(part.outer), options.tolerance_nm);
    for (Polygon& hole : part.holes) hole = Simplified(std::move(hole), options.tolerance_nm);
  }
  ForEachRing(*inset, [&](const Polygon& ring) { rings.push_back(&ring); });
  if (!AreSimple(rings)) return std::nullopt;
  return inset;
}

}  // namespace

std::optional<Polygon> RoundReflexCorners(const Polygon& ring, Coord distance_nm,
                                          Coord tolerance_nm) {
  const size_t count = ring.size();
  const auto distance = static_cast<double>(distance_nm);
  const auto before = [&](size_t i) { return ring[i == 0 ? count - 1 : i - 1]; };
  const auto after = [&](size_t i) { return ring[i + 1 == count ? 0 : i + 1]; };
  std::vector<Rounding> roundings(count);
  for (size_t i = 0; i < count; ++i) {
    const auto rounding = RoundingAt(before(i), ring[i], after(i), distance);
    if (!rounding) return std::nullopt;
    roundings[i] = *rounding;
  }
  const double step = 2 * Acos(1 - std::min(1.0, static_cast<double>(tolerance_nm) / distance));
  Polygon rounded;
  rounded.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    const Rounding& next = roundings[i + 1 == count ? 0 : i + 1];
    if (roundings[i].cut_nm + next.cut_nm > Distance(ring[i], after(i)) + 1) return std::nullopt;
    if (roundings[i].turn == 0) {
      rounded.push_back(ring[i]);
    } else {
      AppendArc(ring[i], Along(before(i), ring[i]), roundings[i], distance, step, rounded);
    }
  }
  return rounded;
}

std::optional<VariableWalls> TryWideWalls(const PolygonWithHoles& island,
                                          const BeadingStrategy& strategy, int max_walls,
                                          const VariableWallOptions& options) {
  const Coord thickness = strategy.TransitionThickness(2 * max_walls);
  // Close decisions depend on the neighbouring layers, so such islands are not handled here.
  const Coord radius = (thickness + options.filter_deviation_nm) / 2 + 1;
  if (!IsWide(island, radius, options.transition_angle)) return std::nullopt;
  const Beading beading = strategy.Compute(thickness, 2 * max_walls + 1);
  VariableWalls walls;
  for (int inset = 0; inset <= max_walls; ++inset) {
    const Coord distance = beading.locations_nm[inset];
    auto rings = CleanInset(island, distance, options.tolerance_nm / 2);
    if (!rings) rings = ErodedInset(island, distance, options);
    if (!rings) return std::nullopt;
    if (inset == max_walls) {
      // The space inside is wide enough for infill, but may be a dot.
      if (Area(*rings) < kLeastFillNm2) return std::nullopt;
      walls.fill_area = *std::move(rings);
      break;
    }
    const Coord width = beading.widths_nm[inset];
    ForEachRing(*rings, [&](const Polygon& ring) {
      walls.lines.push_back({inset, false, {true, ring, std::vector<Coord>(ring.size(), width)}});
    });
  }
  return walls;
}

}  // namespace slicefarm::beading
