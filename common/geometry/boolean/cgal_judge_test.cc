#include "common/geometry/boolean/cgal_judge_test.h"

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace slicefarm {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Segments = CGAL::Arr_segment_traits_2<Kernel>;

enum Group { kGot, kA, kB, kGroups };

/// Number of edges from left to right minus the number from right to left, for each group of
/// regions.
struct Windings {
  std::array<int, kGroups> by = {};
};
Windings Sum(const Windings& a, const Windings& b, int sign = 1) {
  Windings sum = a;
  for (int i = 0; i < kGroups; ++i) sum.by[i] += sign * b.by[i];
  return sum;
}
struct SumOfOverlapping {
  Windings operator()(const Windings& a, const Windings& b) const { return Sum(a, b); }
};

using Traits = CGAL::Arr_curve_data_traits_2<Segments, Windings, SumOfOverlapping>;
using Arrangement = CGAL::Arrangement_2<Traits>;
using Face = Arrangement::Face_const_handle;
using HalfEdge = Arrangement::Halfedge_const_handle;

struct Place {
  double x = 0, y = 0;
};
Place PlaceOf(const Kernel::Point_2& p) { return {CGAL::to_double(p.x()), CGAL::to_double(p.y())}; }

double DistanceTo(Place p, Place a, Place b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double along =
      square == 0 ? 0 : std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0);
  return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

class Judge {
 public:
  using Belongs = bool (*)(const Windings&);

  void Add(const MultiPolygon& region, Group group) {
    ForEachRing(region, [&](const Polygon& ring) {
      for (size_t i = 0; i < ring.size(); ++i) {
        const Point from = ring[i], to = ring[i + 1 == ring.size() ? 0 : i + 1];
        if (from == to) continue;
        Windings windings;
        windings.by[group] = std::pair(from.x, from.y) < std::pair(to.x, to.y) ? 1 : -1;
        const Segments::Curve_2 segment(Kernel::Point_2(from.x, from.y),
                                        Kernel::Point_2(to.x, to.y));
        curves_.emplace_back(segment, windings);
      }
    });
  }

  Differences Compare(Belongs belongs) {
    CGAL::insert(arrangement_, curves_.begin(), curves_.end());
    CountWindings();
    struct Shape {
      double area2 = 0, perimeter = 0;
    };
    std::map<Face, Shape> faces;  // the faces that differ
    std::vector<std::pair<Place, Place>> boundary;
    std::vector<Place> corners;
    Differences differences;
    for (auto half = arrangement_.halfedges_begin(); half != arrangement_.halfedges_end(); ++half) {
      const Windings& left = windings_.at(half->face());
      const Place from = PlaceOf(half->source()->point()), to = PlaceOf(half->target()->point());
      const double area2 =
          (from.x - origin_.x) * (to.y - origin_.y) - (to.x - origin_.x) * (from.y - origin_.y);
      if (left.by[kGot] < 0 || left.by[kGot] > 1) differences.overlap_nm2 += area2 / 2;
      if (belongs(left) && !belongs(windings_.at(half->twin()->face())))
        boundary.emplace_back(from, to);
      if (belongs(left) == (left.by[kGot] > 0)) continue;
      Shape& face = faces[half->face()];
      face.area2 += area2;
      face.perimeter += std::hypot(to.x - from.x, to.y - from.y);
      corners.push_back(from);
    }
    constexpr double kForgivenNm2 = 4;
    for (const auto& [face, shape] : faces) {
      differences.area_nm2 += shape.area2 / 2;
      differences.thickness_nm =
          std::max(differences.thickness_nm, (shape.area2 - 2 * kForgivenNm2) / shape.perimeter);
    }
    for (const Place corner : corners) {
      double nearest = boundary.empty() ? 0 : INFINITY;  // without a boundary, the area suffices
      for (const auto& [from, to] : boundary)
        nearest = std::min(nearest, DistanceTo(corner, from, to));
      differences.distance_nm = std::max(differences.distance_nm, nearest);
    }
    return differences;
  }

 private:
  /// Counts the winding numbers of all faces, starting at the unbounded face and crossing edges.
  void CountWindings() {
    std::vector<Face> open = {arrangement_.unbounded_face()};
    windings_[open.back()] = {};
    if (arrangement_.number_of_vertices() > 0)
      origin_ = PlaceOf(arrangement_.vertices_begin()->point());
    const auto cross = [&](Arrangement::Ccb_halfedge_const_circulator edge) {
      const auto first = edge;
      do {
        const Face beyond = edge->twin()->face();
        const int sign = edge->direction() == CGAL::ARR_LEFT_TO_RIGHT ? -1 : 1;
        const auto [at, is_new] =
            windings_.emplace(beyond, Sum(windings_.at(edge->face()), edge->curve().data(), sign));
        if (is_new) open.push_back(beyond);
      } while (++edge != first);
    };
    while (!open.empty()) {
      const Face face = open.back();
      open.pop_back();
      for (auto ring = face->outer_ccbs_begin(); ring != face->outer_ccbs_end(); ++ring)
        cross(*ring);
      for (auto ring = face->inner_ccbs_begin(); ring != face->inner_ccbs_end(); ++ring)
        cross(*ring);
    }
  }

  std::vector<Traits::Curve_2> curves_;
  Arrangement arrangement_;
  std::map<Face, Windings> windings_;
  Place origin_;
};

}  // namespace

std::string ToText(const Differences& d) {
  return fmt::format("{} nm2 differ, {} nm thick, {} nm away; {} nm2 overlap", d.area_nm2,
                     d.thickness_nm, d.distance_nm, d.overlap_nm2);
}

Differences JudgeBoolean(const MultiPolygon& got, const MultiPolygon& a, const MultiPolygon& b,
                         Operation op) {
  Judge judge;
  judge.Add(got, kGot);
  judge.Add(a, kA);
  judge.Add(b, kB);
  switch (op) {
    case Operation::kUnion:
      return judge.Compare([](const Windings& w) { return w.by[kA] > 0 || w.by[kB] > 0; });
    case Operation::kIntersection:
      return judge.Compare([](const Windings& w) { return w.by[kA] > 0 && w.by[kB] > 0; });
    case Operation::kDifference:
      break;
  }
  return judge.Compare([](const Windings& w) { return w.by[kA] > 0 && w.by[kB] <= 0; });
}

Differences JudgeEqual(const MultiPolygon& got, const MultiPolygon& want) {
  Judge judge;
  judge.Add(got, kGot);
  judge.Add(want, kA);
  return judge.Compare([](const Windings& w) { return w.by[kA] > 0; });
}

}  // namespace slicefarm
