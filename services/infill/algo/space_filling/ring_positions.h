#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/model/scene/scene.h"
#include "services/infill/algo/space_filling/segment_grid.h"

namespace slicefarm::infill {

/// Rings with positions on them, and a search for positions near a point. A position (`position` in
/// names) is the arc length from the ring's first point forwards, in nm.
class RingPositions {
 public:
  /// Position on a ring, with its distance from a given point, in nm.
  struct Near {
    double position = 0;
    double distance = 0;
  };
  /// Ring near a given point, with its distance from the point, in nm.
  struct NearRing {
    int32_t ring = 0;
    double distance = 0;
  };
  /// Edge of a ring.
  struct Edge {
    Point from, to;
    int32_t ring = 0;
    int32_t index = 0;
  };

  /// Indexes the rings, which must outlive this object. `cell_nm`: side of the cells of the search
  /// grid. REQUIRES: each ring has at least three points.
  RingPositions(std::vector<const Polygon*> rings, double cell_nm);

  const Box& Extent() const { return extent_; }
  int32_t Count() const { return static_cast<int32_t>(rings_.size()); }
  double Length(int32_t ring) const { return along_[first_[ring + 1] + ring]; }

  /// Returns the position reduced to [0, length of the ring).
  double Wrapped(int32_t ring, double position) const;
  /// Returns the point at a position of a ring.
  Point At(int32_t ring, double position) const;

  /// Returns the position on a ring that is nearest to p; nullopt if its distance exceeds `reach`
  /// (in nm).
  std::optional<Near> Nearest(Point p, int32_t ring, double reach) const;

  /// Finds the rings within `reach` of p for which wanted(ring) is true, with their distances, in
  /// any order.
  template <typename Wanted>
  void NearRings(Point p, double reach, const Wanted& wanted, std::vector<NearRing>& found) const {
    found.clear();
    grid_.ForEachNear(p, p, reach, [&](int32_t s) {
      const Segment& segment = segments_[s];
      if (!wanted(segment.ring)) return;
      const double squared = segment.SquaredDistance(p);
      if (squared > reach * reach) return;
      for (NearRing& near : found) {
        if (near.ring != segment.ring) continue;
        near.distance = std::min(near.distance, squared);
        return;
      }
      found.push_back({segment.ring, squared});
    });
    for (NearRing& near : found) near.distance = std::sqrt(near.distance);
  }

  /// Calls visit(edge) for all edges near the segment ab, and also for some that are farther away.
  template <typename Visit>
  void ForEachEdgeNear(Point a, Point b, Visit visit) const {
    grid_.ForEachNear(a, b, 1, [&](int32_t segment) { visit(EdgeOf(segment)); });
  }

  /// Returns the ring position of the point that is nearest to p among all points of `edge`.
  double PositionOn(const Edge& edge, Point p) const;

  /// Calls visit(point) for the ring's points strictly between the positions `from` and `from` +
  /// `length`, forwards.
  template <typename Visit>
  void ForEachCornerBetween(int32_t ring, double from, double length, Visit visit) const {
    const double* const along = Along(ring);
    const auto size = static_cast<int32_t>(rings_[ring]->size());
    const double start = Wrapped(ring, from);
    int32_t corner = EdgeAt(ring, start) + 1;
    for (double turns = 0;; ++corner) {
      if (corner == size) corner = 0, turns += Length(ring);
      if (along[corner] + turns >= start + length) return;
      if (along[corner] + turns > start) visit((*rings_[ring])[corner]);
    }
  }

 private:
  struct Segment {
    Point from, direction;
    double per_squared_length = 0;
    int32_t ring = 0;

    /// Returns the fraction of the segment, in [0, 1], at which its point nearest to p is.
    double Part(Point p) const {
      return std::clamp(Dot(p - from, direction) * per_squared_length, 0.0, 1.0);
    }
    double SquaredDistance(Point p) const {
      const double part = Part(p);
      const double x = static_cast<double>(p.x - from.x) - part * static_cast<double>(direction.x);
      const double y = static_cast<double>(p.y - from.y) - part * static_cast<double>(direction.y);
      return x * x + y * y;
    }
  };

  const double* Along(int32_t ring) const { return &along_[first_[ring] + ring]; }
  int32_t EdgeAt(int32_t ring, double position) const;
  Edge EdgeOf(int32_t segment) const;

  std::vector<const Polygon*> rings_;
  /// Index in `segments_` of each ring's first edge; one more entry than rings.
  std::vector<int32_t> first_;
  std::vector<Segment> segments_;
  /// For each ring: the arc length at each of its points, then its whole length.
  std::vector<double> along_;
  Box extent_;
  SegmentGrid grid_;
};

}  // namespace slicefarm::infill
