#include "services/infill/algo/quality/bead_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "common/geometry/line_axes.h"
#include "common/geometry/vector.h"
#include "common/model/bead_section.h"

namespace slicefarm::infill {
namespace {

/// Angle of the rows, in radians. It is no usual fill angle, and gives no ratio of small numbers
/// between rows and lines.
constexpr double kRowsAngle = 0.2237;

/// Part of a row within a convex shape.
struct CoveredSpan {
  double from = std::numeric_limits<double>::infinity();
  double to = -std::numeric_limits<double>::infinity();

  bool IsEmpty() const { return from > to; }
  void Add(double u) {
    from = std::min(from, u);
    to = std::max(to, u);
  }
};

/// Bead from a to b, with half widths `ra` and `rb` there.
struct Bead {
  Vector2 a = Vector2::Zero(), b = Vector2::Zero();
  double ra = 0, rb = 0;
};

void AddDisc(Vector2 middle, double radius, double v, CoveredSpan& span) {
  const double away = v - middle.y(), square = radius * radius - away * away;
  if (square < 0) return;
  span.Add(middle.x() - std::sqrt(square));
  span.Add(middle.x() + std::sqrt(square));
}

void AddEdge(Vector2 a, Vector2 b, double v, CoveredSpan& span) {
  if ((a.y() < v) == (b.y() < v)) return;
  span.Add(a.x() + (b.x() - a.x()) * ((v - a.y()) / (b.y() - a.y())));
}

/// Returns the part of a row within a bead: a disc at either end, and the sides between them. This
/// part is connected.
CoveredSpan Across(const Bead& bead, double v) {
  CoveredSpan span;
  AddDisc(bead.a, bead.ra, v, span);
  AddDisc(bead.b, bead.rb, v, span);
  const double du = bead.b.x() - bead.a.x(), dv = bead.b.y() - bead.a.y();
  const double length = std::sqrt(du * du + dv * dv);
  if (length == 0) return span;
  for (const double side : {-1 / length, 1 / length}) {
    const auto aside = [&](Vector2 p, double radius) {
      return Vector2{p.x() - side * radius * dv, p.y() + side * radius * du};
    };
    AddEdge(aside(bead.a, bead.ra), aside(bead.b, bead.rb), v, span);
  }
  return span;
}

/// Rows over a region, with the edges and beads on each of them.
class CoverRows {
 public:
  CoverRows(const MultiPolygon& region, double pitch) : frame_(kRowsAngle) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    ForEachRing(region, [&](const Polygon& ring) {
      for (const Point p : ring) {
        low = std::min(low, frame_.V(p));
        high = std::max(high, frame_.V(p));
      }
    });
    pitch_ = std::max({pitch, (high - low) / kMostRows, 1.0});
    first_ = low + pitch_ / 2;
    const auto count = static_cast<size_t>(std::max(1.0, std::ceil((high - low) / pitch_)));
    edges_.resize(count);
    beads_.resize(count);
    ForEachRing(region, [&](const Polygon& ring) { AddRing(ring); });
  }

  Vector2 PlaceOf(Point p) const { return {frame_.U(p), frame_.V(p)}; }

  void Add(const Bead& bead) {
    ForEachRow(std::min(bead.a.y() - bead.ra, bead.b.y() - bead.rb),
               std::max(bead.a.y() + bead.ra, bead.b.y() + bead.rb), [&](size_t row, double v) {
                 const CoveredSpan span = Across(bead, v);
                 if (!span.IsEmpty()) beads_[row].push_back(span);
               });
  }

  double CoveredShare() {
    double inside = 0, covered = 0;
    for (size_t row = 0; row < edges_.size(); ++row) {
      std::ranges::sort(edges_[row]);
      std::ranges::sort(beads_[row], {}, &CoveredSpan::from);
      for (size_t i = 0; i + 1 < edges_[row].size(); i += 2) {
        inside += edges_[row][i + 1] - edges_[row][i];
        covered += CoveredBetween(edges_[row][i], edges_[row][i + 1], beads_[row]);
      }
    }
    return inside > 0 ? covered / inside : 0;
  }

 private:
  template <class Visit>
  void ForEachRow(double from_v, double to_v, const Visit& visit) {
    const double last = static_cast<double>(edges_.size()) - 1;
    const double begin = std::max(0.0, std::ceil((from_v - first_) / pitch_));
    const double end = std::min(last, std::floor((to_v - first_) / pitch_));
    for (double row = begin; row <= end; ++row)
      visit(static_cast<size_t>(row), first_ + row * pitch_);
  }

  void AddRing(const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vector2 a = PlaceOf(ring[i]), b = PlaceOf(ring[i + 1 == ring.size() ? 0 : i + 1]);
      ForEachRow(std::min(a.y(), b.y()), std::max(a.y(), b.y()), [&](size_t row, double v) {
        if ((a.y() < v) != (b.y() < v))
          edges_[row].push_back(a.x() + (b.x() - a.x()) * ((v - a.y()) / (b.y() - a.y())));
      });
    }
  }

  static double CoveredBetween(double from, double to, const std::vector<CoveredSpan>& beads) {
    double covered = 0, reached = from;
    for (const CoveredSpan& bead : beads) {
      if (bead.from >= to) break;
      const double begin = std::max(bead.from, reached), end = std::min(bead.to, to);
      if (end > begin) covered += end - begin;
      reached = std::max(reached, end);
    }
    return covered;
  }

  LineAxes frame_;
  double first_ = 0, pitch_ = 1;
  std::vector<std::vector<double>> edges_;       ///< crossings with the region's edges, per row
  std::vector<std::vector<CoveredSpan>> beads_;  ///< parts under beads, per row
};

}  // namespace

double CoveredShare(const MultiPolygon& region, std::span<const Path> paths, Coord height_nm,
                    Coord spacing_nm) {
  if (region.empty()) return 0;
  CoverRows rows(region, static_cast<double>(spacing_nm) / kRowsPerBead);
  for (const Path& path : paths) {
    const auto half = [&](size_t i) {
      return static_cast<double>(Spacing(path.WidthAt(i), height_nm)) / 2;
    };
    const size_t edges = path.points.size() - (path.closed ? 0 : 1);
    for (size_t i = 0; i < edges; ++i) {
      const size_t next = (i + 1) % path.points.size();
      rows.Add(
          {rows.PlaceOf(path.points[i]), rows.PlaceOf(path.points[next]), half(i), half(next)});
    }
  }
  return rows.CoveredShare();
}

}  // namespace slicefarm::infill
