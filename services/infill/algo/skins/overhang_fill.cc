#include "services/infill/algo/skins/overhang_fill.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"
#include "common/model/bead_section.h"
#include "services/infill/algo/lines/clip_curves.h"

namespace slicefarm::infill {
namespace {

/// Largest distance of a supporting area from the region, in spacings.
constexpr Coord kNearSpacings = 4;
/// Number of lines over the supporting area. The fill there ends about where the region's anchor
/// ends.
constexpr int kAnchorLines = 3;
/// Largest distance between two ends that are joined, in spacings.
constexpr double kOverhangLinkSpacings = 1.6;

/// Returns the boundary of the area that is within a distance of a region.
std::vector<Curve> LinesAround(const MultiPolygon& region, Coord distance_nm) {
  std::vector<Curve> curves;
  const auto add = [&](const Polygon& ring) { curves.push_back({ring, true}); };
  for (const PolygonWithHoles& island : Offset(region, distance_nm, {.join = Join::kRound})) {
    add(island.outer);
    std::ranges::for_each(island.holes, add);
  }
  return curves;
}

/// Paths of lines that are joined in the order in which they are added.
class Chain {
 public:
  Chain(Coord width_nm, double max_link_nm) : width_nm_(width_nm), max_link_nm_(max_link_nm) {}

  /// Adds lines of one distance. The line nearest to the last end is added first.
  void AddAll(std::vector<Piece> lines) {
    while (!lines.empty()) {
      const auto nearest = std::ranges::min_element(lines, {}, [this](const Piece& line) {
        return std::min(DistanceTo(line.points.front()), DistanceTo(line.points.back()));
      });
      Add(std::move(*nearest));
      lines.erase(nearest);
    }
  }

  FillGroup Take() { return std::move(group_); }

 private:
  double DistanceTo(Point to) const {
    return group_.paths.empty() ? 0 : Distance(EndOf(group_.paths.back()), to);
  }

  void Add(Piece line) {
    if (!line.closed && DistanceTo(line.points.back()) < DistanceTo(line.points.front()))
      std::ranges::reverse(line.points);
    const bool joins = !group_.paths.empty() && !group_.paths.back().closed && !line.closed &&
                       DistanceTo(line.points.front()) <= max_link_nm_;
    if (!joins) {
      Path& path = group_.paths.emplace_back();
      path.feature = Feature::kBridgeInfill;
      path.widths_nm = {width_nm_};
      path.closed = line.closed;
      path.reversible = false;
    }
    Polyline& points = group_.paths.back().points;
    points.insert(points.end(), line.points.begin(), line.points.end());
  }

  Coord width_nm_;
  double max_link_nm_;
  FillGroup group_{.keep_order = true, .paths = {}};
};

}  // namespace

FillGroup FillOverhang(const PolygonWithHoles& region, const MultiPolygon& below,
                       const OverhangFill& fill) {
  const Coord spacing = Spacing(fill.width_nm, fill.height_nm);
  const MultiPolygon bearing = Intersection(below, FastOffset({region}, kNearSpacings * spacing));
  if (Intersection(bearing, {region}).empty()) return {};
  const MultiPolygon air = Difference({region}, bearing);
  const MultiPolygon area =
      FastOffset({region}, -std::max<Coord>(0, spacing / 2 - fill.overlap_nm));
  Chain chain(fill.width_nm, kOverhangLinkSpacings * static_cast<double>(spacing));
  const auto add = [&](const MultiPolygon& from, int line) {
    std::vector<Piece> lines = ClipCurves(area, LinesAround(from, line * spacing + spacing / 2));
    const bool any = !lines.empty();
    chain.AddAll(std::move(lines));
    return any;
  };
  for (int i = kAnchorLines; i-- > 0;) add(air, i);
  // Distances in a connected region have no gaps: if a distance has no line, no greater one has.
  for (int i = 0; add(bearing, i); ++i) {
  }
  return chain.Take();
}

}  // namespace slicefarm::infill
