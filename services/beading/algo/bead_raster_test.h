#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/geometry/measure.h"
#include "services/beading/algo/arachne/variable_walls.h"

namespace slicefarm::beading {

/// Shares of an island's area.
struct Coverage {
  double underfill = 0;  ///< not covered
  double overfill = 0;   ///< covered by each bead beyond the first
  double outside = 0;    ///< covered, but not part of the island
};

/// Raster that covers an island with beads, by the area model of Kuipers et al. 2020, section 6.1.
/// A segment is a trapezoid with the half disc at its start, without the disc at its end. Open
/// lines add the disc at their end.
class BeadRaster {
 public:
  BeadRaster(const PolygonWithHoles& island, double pixel_nm) : pixel_(pixel_nm) {
    Box box = Bounds(island.outer);
    constexpr Coord kMargin = 1'000'003;
    origin_ = {box.min.x - kMargin, box.min.y - kMargin};
    columns_ = static_cast<int>(static_cast<double>(box.max.x - origin_.x + kMargin) / pixel_) + 1;
    rows_ = static_cast<int>(static_cast<double>(box.max.y - origin_.y + kMargin) / pixel_) + 1;
    count_.assign(static_cast<size_t>(columns_) * rows_, 0);
    inside_ = Mask({island});
  }

  void Add(const ThickLine& line) {
    const size_t count = line.points.size();
    const size_t edges = line.closed ? count : count - 1;
    for (size_t i = 0; i < edges; ++i)
      AddSegment(line, i, (i + 1) % count, !line.closed && i + 1 == edges);
  }

  /// Counts once where `area` covers, for the infill's area.
  void Add(const MultiPolygon& area) {
    const std::vector<char> mask = Mask(area);
    for (size_t i = 0; i < mask.size(); ++i) count_[i] += mask[i];
  }

  Coverage Measure() const {
    Coverage coverage;
    double area = 0;
    for (size_t i = 0; i < count_.size(); ++i) {
      area += inside_[i];
      if (!inside_[i]) {
        coverage.outside += count_[i];
      } else if (count_[i] == 0) {
        coverage.underfill += 1;
      } else {
        coverage.overfill += count_[i] - 1;
      }
    }
    for (double* share : {&coverage.underfill, &coverage.overfill, &coverage.outside})
      *share /= area;
    return coverage;
  }

 private:
  std::vector<char> Mask(const MultiPolygon& area) const {
    std::vector<char> mask(count_.size());
    for (int row = 0; row < rows_; ++row) {
      const double y = (row + 0.5) * pixel_;
      std::vector<double> xs;
      ForEachRing(area, [&](const Polygon& ring) { Cross(ring, y, xs); });
      std::sort(xs.begin(), xs.end());
      for (size_t i = 0; i + 1 < xs.size(); i += 2) {
        const int first = static_cast<int>(std::ceil(xs[i] / pixel_ - 0.5));
        const int last = static_cast<int>(std::ceil(xs[i + 1] / pixel_ - 0.5));
        for (int column = first; column < last; ++column)
          mask[static_cast<size_t>(row) * columns_ + column] = 1;
      }
    }
    return mask;
  }

  void Cross(const Polygon& ring, double y, std::vector<double>& xs) const {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i] - origin_, b = ring[(i + 1) % ring.size()] - origin_;
      const auto ay = static_cast<double>(a.y), by = static_cast<double>(b.y);
      if ((ay <= y) == (by <= y)) continue;
      const auto ax = static_cast<double>(a.x), bx = static_cast<double>(b.x);
      xs.push_back(ax + (y - ay) * (bx - ax) / (by - ay));
    }
  }

  void AddSegment(const ThickLine& line, size_t from, size_t to, bool ends) {
    const Point a = line.points[from] - origin_, b = line.points[to] - origin_;
    const double ra = static_cast<double>(line.thickness_nm[from]) / 2;
    const double rb = static_cast<double>(line.thickness_nm[to]) / 2;
    const double ax = static_cast<double>(a.x), ay = static_cast<double>(a.y);
    const double length = Distance(a, b), reach = std::max(ra, rb);
    if (length == 0) return;
    const double dx = static_cast<double>(b.x - a.x) / length;
    const double dy = static_cast<double>(b.y - a.y) / length;
    const int left = Pixel(std::min(a.x, b.x), -reach), right = Pixel(std::max(a.x, b.x), reach);
    const int low = Pixel(std::min(a.y, b.y), -reach), high = Pixel(std::max(a.y, b.y), reach);
    for (int row = std::max(0, low); row <= std::min(rows_ - 1, high); ++row) {
      for (int column = std::max(0, left); column <= std::min(columns_ - 1, right); ++column) {
        const double x = (column + 0.5) * pixel_ - ax, y = (row + 0.5) * pixel_ - ay;
        const double along = x * dx + y * dy, across = y * dx - x * dy;
        bool covered = along <= length && std::abs(across) <= ra + (rb - ra) * along / length;
        if (along < 0) covered = along * along + across * across < ra * ra;
        const double beyond = along - length;
        if (beyond * beyond + across * across < rb * rb) covered = ends;
        count_[static_cast<size_t>(row) * columns_ + column] += covered;
      }
    }
  }

  int Pixel(Coord at, double by) const {
    return static_cast<int>((static_cast<double>(at) + by) / pixel_);
  }

  double pixel_;
  Point origin_;
  int columns_ = 0, rows_ = 0;
  std::vector<int> count_;
  std::vector<char> inside_;
};

}  // namespace slicefarm::beading
