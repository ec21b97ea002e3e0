#include "services/infill/algo/skins/narrow_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "common/base/disjoint_sets.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/box_index.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::infill {
namespace {

/// Least number of short lines side by side that are noticed beside long lines.
constexpr int32_t kLeastShortLines = 3;

/// Piece of a line inside an area.
struct LinePiece {
  int32_t line = 0;
  double from_u = 0;
  double to_u = 0;
};

std::vector<LinePiece> PiecesOfLines(const ScanLines& lines) {
  std::vector<LinePiece> pieces;
  for (int32_t k = 0; k < lines.PieceCount(); ++k) {
    const auto first = static_cast<size_t>(2 * k);
    const Crossing& from = lines.crossings[static_cast<size_t>(lines.order[first])];
    const Crossing& to = lines.crossings[static_cast<size_t>(lines.order[first + 1])];
    pieces.push_back({from.line, from.u, to.u});
  }
  return pieces;
}

/// Calls visit(other) for the pieces on the lines beside a piece that are beside it. `pieces`:
/// sorted by line, then by u. Cost: O(log n) and the calls, n pieces.
template <typename Visit>
void VisitBeside(const std::vector<LinePiece>& pieces, size_t i, const Visit& visit) {
  const LinePiece& piece = pieces[i];
  const auto end_of = [](const LinePiece& other) { return std::pair(other.line, other.to_u); };
  for (const int32_t line : {piece.line - 1, piece.line + 1}) {
    auto other = std::ranges::upper_bound(pieces, std::pair(line, piece.from_u), {}, end_of);
    for (; other != pieces.end() && other->line == line && other->from_u < piece.to_u; ++other)
      visit(static_cast<size_t>(other - pieces.begin()));
  }
}

/// Short lines that are connected side by side.
struct ShortRun {
  std::vector<size_t> pieces;
  int32_t first = 0;  ///< numbers of its first and last line
  int32_t last = 0;
  bool alone = true;  ///< true if no long line is beside the run
};

/// Returns the runs of pieces shorter than `least_nm`. `pieces`: sorted by line, then by u. Cost:
/// O(n log n), n pieces.
std::vector<ShortRun> ShortRuns(const std::vector<LinePiece>& pieces, double least_nm) {
  const auto is_short = [&](size_t i) { return pieces[i].to_u - pieces[i].from_u < least_nm; };
  std::vector<ShortRun> runs;
  std::vector<char> seen(pieces.size(), 0);
  for (size_t start = 0; start < pieces.size(); ++start) {
    if (seen[start] || !is_short(start)) continue;
    ShortRun run{{start}, pieces[start].line, pieces[start].line};
    seen[start] = 1;
    for (size_t k = 0; k < run.pieces.size(); ++k) {
      const size_t at = run.pieces[k];
      run.first = std::min(run.first, pieces[at].line);
      run.last = std::max(run.last, pieces[at].line);
      VisitBeside(pieces, at, [&](size_t other) {
        if (!is_short(other)) {
          run.alone = false;
        } else if (!seen[other]) {
          seen[other] = 1;
          run.pieces.push_back(other);
        }
      });
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

/// Returns the strip of a piece, which ends half a pitch beyond the line's ends and reaches to the
/// neighbour lines. No sliver remains beside the last line of an area.
PolygonWithHoles StripOf(const ScanLines& lines, const LinePiece& piece) {
  const double half = lines.pitch / 2, v = lines.VOf(piece.line);
  const auto at = [&](double u, double side) { return lines.frame.At(u, v + side * lines.pitch); };
  return {{at(piece.from_u - half, -1), at(piece.to_u + half, -1), at(piece.to_u + half, 1),
           at(piece.from_u - half, 1)},
          {}};
}

/// Area of the strips of a run, with its boxes in the plane and in the frame of the lines.
struct RunArea {
  MultiPolygon area;
  Box box;
  Box in_frame;
};

RunArea AreaOf(const ScanLines& lines, const std::vector<LinePiece>& pieces, const ShortRun& run) {
  std::vector<Polygon> strips;
  for (const size_t i : run.pieces) strips.push_back(StripOf(lines, pieces[i]).outer);
  RunArea area{Union(strips, FillRule::kNonZero), {}, {}};
  area.box = Bounds(area.area);
  for (const Polygon& strip : strips)
    for (const Point p : strip)
      area.in_frame.Add(Point{std::llround(lines.frame.U(p)), std::llround(lines.frame.V(p))});
  return area;
}

/// Returns the union of the areas. Only areas with boxes that meet in both frames are united in one
/// sweep: its time grows with the square of the edges that its line crosses.
MultiPolygon UnionOf(const std::vector<RunArea>& areas) {
  std::vector<Box> boxes;
  for (const RunArea& area : areas) boxes.push_back(area.box);
  const BoxIndex index(boxes);
  DisjointSets sets(static_cast<int32_t>(areas.size()));
  for (size_t i = 0; i < areas.size(); ++i)
    for (const size_t other : index.Meeting(boxes[i]))
      if (areas[i].in_frame.Intersects(areas[other].in_frame))
        sets.Join(static_cast<int32_t>(i), static_cast<int32_t>(other));
  std::map<int32_t, MultiPolygon> groups;
  for (size_t i = 0; i < areas.size(); ++i) {
    MultiPolygon& group = groups[sets.RootOf(static_cast<int32_t>(i))];
    group.insert(group.end(), areas[i].area.begin(), areas[i].area.end());
  }
  MultiPolygon all;
  for (auto& [root, group] : groups)
    std::ranges::move(group.size() > 1 ? Union(Rings(group), FillRule::kNonZero) : std::move(group),
                      std::back_inserter(all));
  Canonicalize(all);
  return all;
}

/// Returns Intersection(islands, area), island by island: one sweep over all would be slow.
MultiPolygon CutByIslands(const MultiPolygon& islands, const MultiPolygon& area) {
  MultiPolygon parts;
  for (const PolygonWithHoles& island : islands)
    std::ranges::move(Intersection({island}, area), std::back_inserter(parts));
  Canonicalize(parts);
  return parts;
}

/// Divides an area by a narrow part of it, without slivers that have no space for a line.
SolidParts Divided(const MultiPolygon& solid, const MultiPolygon& narrow, Coord width_nm) {
  SolidParts parts;
  parts.narrow = CutByIslands(FastOffset(FastOffset(narrow, -width_nm / 2), width_nm / 2), solid);
  parts.wide = parts.narrow.empty() ? solid : Difference(solid, parts.narrow);
  return parts;
}

}  // namespace

absl::StatusOr<SolidParts> PartByLines(const MultiPolygon& solid, const LineFamily& lines,
                                       double least_nm) {
  const auto cut = CutLines(solid, lines);
  if (!cut.ok()) return cut.status();
  const std::vector<LinePiece> pieces = PiecesOfLines(*cut);
  std::vector<RunArea> runs;
  for (const ShortRun& run : ShortRuns(pieces, least_nm))
    if (run.alone || run.last - run.first + 1 >= kLeastShortLines)
      runs.push_back(AreaOf(*cut, pieces, run));
  if (runs.empty()) return SolidParts{solid, {}};
  const MultiPolygon narrow = CutByIslands(UnionOf(runs), solid);
  return Divided(solid, narrow, std::llround(lines.pitch_nm));
}

SolidParts PartByWidth(const MultiPolygon& solid, Coord narrow_nm, Coord width_nm) {
  const Coord half = narrow_nm / 2;
  const MultiPolygon core = FastOffset(solid, -half);
  const MultiPolygon beside = core.empty() ? solid : Difference(solid, FastOffset(core, half));
  return Divided(solid, beside, width_nm);
}

}  // namespace slicefarm::infill
