#include "services/exposure/algo/scan/thin_walls.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"
#include "services/exposure/algo/scan/border_grid.h"
#include "services/exposure/algo/scan/convex_rings.h"
#include "services/exposure/algo/scan/scan_pieces.h"

namespace slicefarm::exposure {
namespace {

constexpr Coord kRegrownNm = 1'000;
/// Distances in nm that lines (kKeptNm), and joints between lines (kJoinedNm), keep from the
/// boundary. Pieces may extend over the outline because of simplification, but their lines and
/// joints must not.
constexpr double kKeptNm = 1'000;
constexpr double kJoinedNm = 500;
/// Distance around narrow parts, in depths, up to which the outline is examined.
constexpr Coord kAround = 3;
/// Smallest length of a wall, in half widths of the spot.
constexpr double kLeastLength = 4;

/// Returns the islands that may have parts thinner than the inset. An island is left out if the
/// inset moves all its edges without removing one: nothing in it is thin. This test costs a tenth
/// of the full search.
MultiPolygon Doubtful(const MultiPolygon& outline, Coord inset_nm) {
  MultiPolygon doubtful;
  for (const PolygonWithHoles& island : outline) {
    const std::optional<CleanOffset> inset = TryOffset({island}, -inset_nm);
    if (!inset || inset->has_tips) doubtful.push_back(island);
  }
  return doubtful;
}

MultiPolygon ThinParts(const MultiPolygon& islands, Coord inset_nm) {
  const MultiPolygon outline = Doubtful(islands, inset_nm);
  if (outline.empty()) return {};
  const MultiPolygon thick =
      OffsetTwice(outline, -inset_nm, inset_nm + kRegrownNm, {.miter_limit = 10});
  MultiPolygon thin = Difference(outline, thick);
  const double least =
      kLeastLength * static_cast<double>(inset_nm) * static_cast<double>(inset_nm) / 4;
  std::erase_if(thin, [&](const PolygonWithHoles& part) { return Area(part) < least; });
  return thin;
}

/// Joins lines with ends within `reach` of each other, nearest first, if the joint is inside the
/// outline.
std::vector<Polyline> Chained(std::vector<Polyline> lines, double reach, const BorderGrid& border) {
  std::vector<Polyline> chains;
  while (!lines.empty()) {
    Polyline chain = std::move(lines.back());
    lines.pop_back();
    for (int end = 0; end < 2; std::reverse(chain.begin(), chain.end()), ++end) {
      for (;;) {
        size_t best = lines.size();
        bool backwards = false;
        double least = reach;
        for (size_t i = 0; i < lines.size(); ++i) {
          for (const bool back : {false, true}) {
            const double distance =
                Distance(chain.back(), back ? lines[i].back() : lines[i].front());
            if (distance > least ||
                !border.Keeps(chain.back(), back ? lines[i].back() : lines[i].front(), kJoinedNm))
              continue;
            best = i, backwards = back, least = distance;
          }
        }
        if (best == lines.size()) break;
        Polyline next = std::move(lines[best]);
        lines.erase(lines.begin() + static_cast<ptrdiff_t>(best));
        if (backwards) std::reverse(next.begin(), next.end());
        chain.insert(chain.end(), next.begin() + (next.front() == chain.back() ? 1 : 0),
                     next.end());
      }
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

/// Returns the joined lines of one part that is thin everywhere. `border`: the boundary of the area
/// that may be exposed.
absl::StatusOr<std::vector<Polyline>> LinesOfPart(const PolygonWithHoles& part, Coord inset_nm,
                                                  const BorderGrid& border,
                                                  const CancelToken& cancel) {
  const auto pieces = ScanPieces({part}, DecomposeMethod::kBian, 0, cancel);
  if (!pieces.ok()) return pieces.status();
  std::vector<Polyline> lines;
  for (const Polygon& piece : pieces->pieces) {
    const Spine spine = SpineOf(ConvexRingOf(piece, static_cast<double>(pieces->scale)));
    const auto run = border.LongestRun(RoundedPoint(spine.from), RoundedPoint(spine.to), kKeptNm);
    if (run && Distance(run->first, run->second) > spine.width_nm)
      lines.push_back({run->first, run->second});
  }
  std::vector<Polyline> walls = Chained(std::move(lines), static_cast<double>(inset_nm), border);
  std::erase_if(walls, [&](const Polyline& wall) {
    return Length(wall) < kLeastLength * static_cast<double>(inset_nm);
  });
  return walls;
}

absl::Status AppendLevel(const MultiPolygon& outline, const LineLevel& level,
                         const CancelToken& cancel, std::vector<Polyline>& lines) {
  const MultiPolygon open = level.melted_nm > 0 ? FastOffset(outline, -level.melted_nm) : outline;
  const Coord inset_nm = level.line_nm - level.melted_nm;
  const MultiPolygon thin = ThinParts(open, inset_nm);
  if (thin.empty()) return absl::OkStatus();
  const BorderGrid border(open, kKeptNm);
  for (const PolygonWithHoles& part : thin) {
    auto walls = LinesOfPart(part, inset_nm, border, cancel);
    if (!walls.ok()) return walls.status();
    std::move(walls->begin(), walls->end(), std::back_inserter(lines));
  }
  return absl::OkStatus();
}

/// Returns the part of the outline around its narrow parts. The part is so large that it is nowhere
/// narrow where it is cut off.
MultiPolygon Around(const MultiPolygon& narrow, const MultiPolygon& outline, Coord depth_nm) {
  return Intersection(outline, Offset(narrow, kAround * depth_nm, {.join = Join::kSquare}));
}

}  // namespace

MultiPolygon NarrowParts(const MultiPolygon& outline, Coord depth_nm) {
  return depth_nm > 0 ? ThinParts(outline, depth_nm) : MultiPolygon{};
}

absl::StatusOr<std::vector<Polyline>> MiddleLines(const MultiPolygon& outline,
                                                  const MultiPolygon& narrow,
                                                  std::span<const LineLevel> levels,
                                                  const CancelToken& cancel) {
  std::vector<Polyline> lines;
  if (levels.empty() || narrow.empty()) return lines;
  const MultiPolygon around = Around(narrow, outline, levels.back().line_nm);
  for (const LineLevel& level : levels)
    if (absl::Status status = AppendLevel(around, level, cancel, lines); !status.ok())
      return status;
  return lines;
}

}  // namespace slicefarm::exposure
