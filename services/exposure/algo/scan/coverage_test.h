#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Raster of points that counts how often lines of a round spot melt each point. It is an
/// independent check, because it does not use the code that creates the lines.
class MeltedRaster {
 public:
  MeltedRaster(const MultiPolygon& region, Coord step_nm) : step_(step_nm), box_(Bounds(region)) {
    columns_ = static_cast<size_t>((box_.max.x - box_.min.x) / step_) + 1;
    rows_ = static_cast<size_t>((box_.max.y - box_.min.y) / step_) + 1;
    inside_.resize(columns_ * rows_);
    melted_.resize(columns_ * rows_);
    for (size_t row = 0; row < rows_; ++row) MarkRow(region, row);
  }

  /// Adds a line. A line melts each point once, even if it passes the point several times.
  void Add(std::span<const Point> line, Coord spot_nm) {
    std::vector<size_t> hit;
    for (size_t i = 0; i + 1 < line.size(); ++i) AddEdge(line[i], line[i + 1], spot_nm, hit);
    std::sort(hit.begin(), hit.end());
    hit.erase(std::unique(hit.begin(), hit.end()), hit.end());
    for (const size_t cell : hit) ++melted_[cell];
  }

  /// Returns the share of the region's points that are melted at least `times`.
  double Share(int times) const {
    double inside = 0, melted = 0;
    for (size_t i = 0; i < inside_.size(); ++i) {
      if (!inside_[i]) continue;
      ++inside;
      melted += melted_[i] >= times ? 1 : 0;
    }
    return inside > 0 ? melted / inside : 1;
  }

  /// Returns the largest number of lines that melt a point of the region.
  int Most() const {
    int most = 0;
    for (size_t i = 0; i < inside_.size(); ++i)
      if (inside_[i]) most = std::max(most, melted_[i]);
    return most;
  }

 private:
  double X(size_t column) const {
    return static_cast<double>(box_.min.x + static_cast<Coord>(column) * step_);
  }
  double Y(size_t row) const {
    return static_cast<double>(box_.min.y + static_cast<Coord>(row) * step_);
  }

  void MarkRow(const MultiPolygon& region, size_t row) {
    std::vector<double> crossings;
    const double y = Y(row) + 0.25;
    ForEachRing(region, [&](const Polygon& ring) {
      for (size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        if ((static_cast<double>(a.y) < y) == (static_cast<double>(b.y) < y)) continue;
        crossings.push_back(static_cast<double>(a.x) + (y - static_cast<double>(a.y)) *
                                                           static_cast<double>(b.x - a.x) /
                                                           static_cast<double>(b.y - a.y));
      }
    });
    std::sort(crossings.begin(), crossings.end());
    for (size_t column = 0; column < columns_; ++column) {
      const auto before = std::lower_bound(crossings.begin(), crossings.end(), X(column));
      inside_[row * columns_ + column] = (before - crossings.begin()) % 2 == 1;
    }
  }

  void AddEdge(Point a, Point b, Coord spot_nm, std::vector<size_t>& hit) const {
    const auto cells = [&](Coord low, Coord high, Coord origin, size_t count) {
      const auto clamp = [&](Coord v) {
        return static_cast<size_t>(std::clamp<Coord>(v, 0, static_cast<Coord>(count) - 1));
      };
      return std::pair(clamp((low - spot_nm / 2 - origin) / step_),
                       clamp((high + spot_nm / 2 - origin) / step_ + 1));
    };
    const auto [r0, r1] = cells(std::min(a.y, b.y), std::max(a.y, b.y), box_.min.y, rows_);
    const double ex = static_cast<double>(b.x - a.x), ey = static_cast<double>(b.y - a.y);
    const double length2 = ex * ex + ey * ey, reach = static_cast<double>(spot_nm) / 2 + 2;
    for (size_t row = r0; row <= r1; ++row) {
      // Only the part of the edge within reach of the row.
      const double up = Y(row) - static_cast<double>(a.y);
      const double t0 = ey != 0 ? std::clamp((up - std::copysign(reach, ey)) / ey, 0.0, 1.0) : 0;
      const double t1 = ey != 0 ? std::clamp((up + std::copysign(reach, ey)) / ey, 0.0, 1.0) : 1;
      const Coord x0 = a.x + std::llround(t0 * ex), x1 = a.x + std::llround(t1 * ex);
      const auto [c0, c1] = cells(std::min(x0, x1), std::max(x0, x1), box_.min.x, columns_);
      for (size_t column = c0; column <= c1; ++column) {
        const double px = X(column) - static_cast<double>(a.x),
                     py = Y(row) - static_cast<double>(a.y);
        const double t = length2 > 0 ? std::clamp((px * ex + py * ey) / length2, 0.0, 1.0) : 0;
        if (std::hypot(px - t * ex, py - t * ey) <= reach) hit.push_back(row * columns_ + column);
      }
    }
  }

  Coord step_;
  Box box_;
  size_t columns_ = 0, rows_ = 0;
  std::vector<bool> inside_;
  std::vector<int> melted_;
};

}  // namespace slicefarm::exposure
