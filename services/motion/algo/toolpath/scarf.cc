#include "services/motion/algo/toolpath/scarf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/base/portable_math.h"
#include "common/geometry/between.h"
#include "common/geometry/measure.h"

namespace slicefarm::motion {
namespace {

/// Distance before and after a loop's start at which its turn is measured.
constexpr double kArmNm = 500'000;

/// Points of a loop from its start around to its start again, and the width at each point.
struct OpenedLine {
  std::vector<Point> points;
  std::vector<Coord> widths_nm;
};

OpenedLine Opened(const Path& path) {
  OpenedLine line;
  for (size_t i = 0; i <= path.points.size(); ++i) {
    const size_t at = i % path.points.size();
    line.points.push_back(path.points[at]);
    line.widths_nm.push_back(path.WidthAt(at));
  }
  return line;
}

/// Returns the point at this length along the line, or its end.
Point Along(const std::vector<Point>& line, double length_nm) {
  for (size_t i = 0; i + 1 < line.size(); ++i) {
    const double edge = Distance(line[i], line[i + 1]);
    if (edge > 0 && length_nm < edge) return PointBetween(line[i], line[i + 1], length_nm / edge);
    length_nm -= edge;
  }
  return line.back();
}

/// Returns the cosine of the largest turn at a start that is no corner.
double SmoothCosine(const ScarfOptions& options) {
  // The default angle has a rounded cosine, so that jobs without the setting keep their bytes.
  constexpr double kUsualAngle = 150, kUsualCosine = 0.866;
  if (options.smooth_angle_deg == kUsualAngle) return kUsualCosine;
  return Cos((180 - options.smooth_angle_deg) * std::numbers::pi / 180);
}

bool StartsAtCorner(const Path& path, const ScarfOptions& options) {
  std::vector<Point> line = Opened(path).points;
  const Point out = Along(line, kArmNm) - line.front();
  std::ranges::reverse(line);
  const Point in = line.front() - Along(line, kArmNm);
  return Dot(in, out) < SmoothCosine(options) * Norm(in) * Norm(out);
}

/// Cuts the first `length_nm` of a line into pieces: at its points and so that no piece is longer
/// than `longest_nm`. Calls visit(to, width, middle, end) for each piece. `middle` and `end` are
/// positions in the piece, as lengths along the line.
template <typename Visit>
void CutIntoPieces(const OpenedLine& line, double length_nm, double longest_nm,
                   const Visit& visit) {
  double from = 0;
  for (size_t i = 0; i + 1 < line.points.size() && from < length_nm; ++i) {
    const Point a = line.points[i], b = line.points[i + 1];
    const double edge = Distance(a, b);
    if (edge <= 0) continue;
    const double taken = std::min(edge, length_nm - from);
    const auto pieces = static_cast<int>(std::ceil(taken / longest_nm));
    const auto wide = [&](double share) {
      return static_cast<double>(line.widths_nm[i]) +
             share * static_cast<double>(line.widths_nm[i + 1] - line.widths_nm[i]);
    };
    for (int k = 0; k < pieces; ++k) {
      const double middle = taken * (k + 0.5) / pieces, end = taken * (k + 1) / pieces;
      const Point to = end == edge
                           ? b
                           : a + Point{std::llround(end / edge * static_cast<double>(b.x - a.x)),
                                       std::llround(end / edge * static_cast<double>(b.y - a.y))};
      visit(to, static_cast<Coord>(std::llround(wide(middle / edge))), from + middle, from + end);
    }
    from += edge;
  }
}

/// Appends the line without its first `length_nm`, as pieces of a full bead.
void AppendRest(const OpenedLine& line, double length_nm, std::vector<ScarfPiece>& pieces) {
  double from = 0;
  for (size_t i = 0; i + 1 < line.points.size(); ++i) {
    from += Distance(line.points[i], line.points[i + 1]);
    if (from > length_nm)
      pieces.push_back({line.points[i + 1], (line.widths_nm[i] + line.widths_nm[i + 1]) / 2});
  }
}

}  // namespace

bool HasScarf(const Path& path, const ScarfOptions& options) {
  if (options.placement == ScarfPlacement::kNowhere || !path.closed) return false;
  if (options.length_mm <= 0 && !options.entire_loop) return false;
  const bool external = path.feature == Feature::kExternalPerimeter;
  if (!external && !(options.on_inner && path.feature == Feature::kPerimeter)) return false;
  if (options.placement == ScarfPlacement::kContours && SignedArea(path.points) < 0) return false;
  return !options.only_on_smooth || !StartsAtCorner(path, options);
}

std::vector<ScarfPiece> ScarfedLoop(const Path& path, const ScarfOptions& options) {
  const OpenedLine line = Opened(path);
  const double loop_nm = PathLength(path);
  const double asked_nm = options.entire_loop ? loop_nm : options.length_mm * kNmPerMm;
  const double length_nm = std::min(asked_nm, loop_nm);
  const double longest_nm =
      std::min(options.max_segment_mm * kNmPerMm, length_nm / std::max(1, options.least_segments));
  const auto height_at = [&](double along_nm) {
    const double start = options.start_height_ratio;
    return start + (1 - start) * std::min(along_nm / length_nm, 1.0);
  };
  std::vector<ScarfPiece> pieces;
  CutIntoPieces(line, length_nm, longest_nm,
                [&](Point to, Coord width_nm, double middle, double end) {
                  pieces.push_back({to, width_nm, height_at(end), height_at(middle)});
                });
  AppendRest(line, length_nm, pieces);
  CutIntoPieces(line, length_nm, longest_nm, [&](Point to, Coord width_nm, double middle, double) {
    pieces.push_back({to, width_nm, 1, 1 - height_at(middle)});
  });
  return pieces;
}

}  // namespace slicefarm::motion
