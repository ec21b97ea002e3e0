#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/predicates.h"
#include "common/geometry/text_format_test.h"
#include "tests/corpus_slice.h"

namespace slicefarm::infill {

// Shapes to be filled, and checks that are valid for any fill.

inline Polygon Circle(double x_mm, double y_mm, double radius_mm, int corners = 96) {
  Polygon ring;
  for (int i = 0; i < corners; ++i) {
    const double t = 2 * std::numbers::pi * i / corners;
    ring.push_back(
        {FromMm(x_mm + radius_mm * std::cos(t)), FromMm(y_mm + radius_mm * std::sin(t))});
  }
  return ring;
}

inline PolygonWithHoles Shape(const std::string& name) {
  const auto text = [](const char* rings) { return MakePolygonsOrDie(rings)[0]; };
  if (name == "square") return text("(0 0, 20 0, 20 20, 0 20)");
  if (name == "disc") return {Circle(0, 0, 10), {}};
  if (name == "annulus") return Difference({{Circle(0, 0, 10), {}}}, {{Circle(0, 0, 4), {}}})[0];
  if (name == "plate") {
    MultiPolygon holes;
    for (const double x : {5.0, 25.0})
      for (const double y : {5.0, 15.0}) holes.push_back({Circle(x, y, 2, 48), {}});
    holes.push_back({Circle(15, 10, 4), {}});
    return Difference(MakePolygonsOrDie("(0 0, 30 0, 30 20, 0 20)"), holes)[0];
  }
  if (name == "comb") {
    return text(
        "(0 0, 23 0, 23 15, 20 15, 20 4, 18 4, 18 15, 15 15, 15 4, 13 4, 13 15, 10 15,"
        " 10 4, 8 4, 8 15, 5 15, 5 4, 3 4, 3 15, 0 15)");
  }
  if (name == "star") {
    PolygonWithHoles star;
    for (int i = 0; i < 14; ++i) {
      const double r = i % 2 == 0 ? 10 : 4, t = std::numbers::pi * i / 7;
      star.outer.push_back({FromMm(r * std::cos(t)), FromMm(r * std::sin(t))});
    }
    return star;
  }
  if (name == "eight") {
    return text("(0 0, 8 0, 8 3.4, 10 3.4, 10 0, 18 0, 18 8, 10 8, 10 4.6, 8 4.6, 8 8, 0 8)");
  }
  if (name == "corridor") {
    PolygonWithHoles spiral;
    constexpr int kSteps = 160;
    for (int i = 0; i <= 2 * kSteps + 1; ++i) {
      const bool back = i > kSteps;
      const double t = 1.5 + 4 * std::numbers::pi * (back ? 2 * kSteps + 1 - i : i) / kSteps;
      const double r = 1.2 * t + (back ? 3 : 0);
      spiral.outer.push_back({FromMm(r * std::cos(t)), FromMm(r * std::sin(t))});
    }
    return Union(std::vector<Polygon>{spiral.outer}, FillRule::kNonZero)[0];
  }
  return text("(0 0, 30 0, 30 1, 0 0.3)");  // sliver
}

inline constexpr const char* kCorpusSlices[] = {
    "ACAM-Base--scaled_outline_mesh0_z1100.txt",
    "OpenRC-motor-cover_outline_mesh0_z56700.txt",
    "Spec-House-1st-Floor_outline_mesh0_z4900.txt",
    "cableChain-XendCover_outline_mesh0_z7700.txt",
    "david-scaled_outline_mesh0_z14100.txt",
    "gripper-2-controles-independentes_outline_mesh0_z100.txt",
};

/// Returns regions that are two lines wide everywhere. Each region is the area of a disc of this
/// width, with its centre moving through one connected part.
inline MultiPolygon TwoLinesWide(const MultiPolygon& region, Coord spacing_nm) {
  const OffsetOptions round{.join = Join::kRound};
  MultiPolygon wide;
  for (const PolygonWithHoles& part : Offset(region, -spacing_nm, round))
    for (PolygonWithHoles& grown : Offset({part}, spacing_nm, round))
      wide.push_back(std::move(grown));
  return wide;
}

inline double LengthOf(const std::vector<Polyline>& paths) {
  double length = 0;
  for (const Polyline& path : paths) length += Length(path);
  return length;
}

/// Returns the number of pairs of segments that meet, except neighbours on a path. It tests all
/// pairs that overlap in x.
inline int CrossingsOf(const std::vector<Polyline>& paths) {
  struct Segment {
    Point a, b;
    size_t path, index;
  };
  std::vector<Segment> segments;
  for (size_t p = 0; p < paths.size(); ++p)
    for (size_t i = 1; i < paths[p].size(); ++i)
      segments.push_back({paths[p][i - 1], paths[p][i], p, i});
  const auto left = [](const Segment& s) { return std::min(s.a.x, s.b.x); };
  std::sort(segments.begin(), segments.end(),
            [&](const Segment& s, const Segment& t) { return left(s) < left(t); });
  int crossings = 0;
  for (size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[i];
    for (size_t j = i + 1; j < segments.size() && left(segments[j]) <= std::max(s.a.x, s.b.x);
         ++j) {
      const Segment& t = segments[j];
      const size_t last = paths[s.path].size() - 1;
      const bool closed = paths[s.path].front() == paths[s.path].back();
      const size_t apart = s.index > t.index ? s.index - t.index : t.index - s.index;
      if (s.path == t.path && (apart == 1 || (closed && apart == last - 1))) continue;
      if (std::max(s.a.y, s.b.y) < std::min(t.a.y, t.b.y) ||
          std::max(t.a.y, t.b.y) < std::min(s.a.y, s.b.y)) {
        continue;
      }
      if (Orientation(s.a, s.b, t.a) * Orientation(s.a, s.b, t.b) <= 0 &&
          Orientation(t.a, t.b, s.a) * Orientation(t.a, t.b, s.b) <= 0) {
        ++crossings;
      }
    }
  }
  return crossings;
}

/// Calls visit(point) along all paths, at steps of at most `step_nm`.
template <typename Visit>
void ForEachPathPoint(const std::vector<Polyline>& paths, double step_nm, Visit visit) {
  for (const Polyline& path : paths) {
    for (size_t i = 1; i < path.size(); ++i) {
      const Point a = path[i - 1], d = path[i] - a;
      const int pieces = 1 + static_cast<int>(Norm(d) / step_nm);
      for (int k = 0; k <= pieces; ++k)
        visit(Point{a.x + d.x * k / pieces, a.y + d.y * k / pieces});
    }
  }
}

/// Returns the greatest distance of the paths outside of a region, in nm.
inline double FarthestOutside(const std::vector<Polyline>& paths, const MultiPolygon& region,
                              double step_nm) {
  double farthest = 0;
  ForEachPathPoint(paths, step_nm, [&](Point p) {
    if (!Inside(p, region)) farthest = std::max(farthest, DistanceToBoundary(p, region));
  });
  return farthest;
}

}  // namespace slicefarm::infill
