#include "services/infill/algo/cells/cell_strands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/disjoint_sets.h"
#include "common/base/perfect_matching.h"

namespace slicefarm::infill {
namespace {

/// Unit of edge lengths as integers, in tiles.
constexpr double kLengthUnit = 1e-9;
/// Largest distance of a bend along an edge, as a share of the edge.
constexpr double kMostOfEdge = 0.45;

/// Slope of an edge that continues the doubled edge in a straight line.
constexpr double kSteepest = 1e9;

}  // namespace

StrandTile::StrandTile(VoronoiTile tile) : tile_(std::move(tile)) {
  leaving_.resize(tile_.vertices.size());
  std::vector<size_t> count(tile_.vertices.size(), 0);
  for (int32_t edge = 0; edge < static_cast<int32_t>(tile_.edges.size()); ++edge) {
    const auto from = static_cast<size_t>(tile_.edges[static_cast<size_t>(edge)].from);
    const auto to = static_cast<size_t>(tile_.edges[static_cast<size_t>(edge)].to);
    leaving_[from][count[from]++] = 2 * edge;
    leaving_[to][count[to]++] = 2 * edge + 1;
  }
  MatchVertices();
  LayCourses();
  JoinCourses();
  LinkStrands();
  MeasureBends();
}

Vector2 StrandTile::DirectionOf(int32_t half) const {
  const TileEdge& edge = tile_.edges[static_cast<size_t>(half / 2)];
  const Vector2 a = tile_.vertices[static_cast<size_t>(edge.from)];
  const Vector2 b = tile_.vertices[static_cast<size_t>(edge.to)];
  const double sign = half % 2 == 0 ? 1 : -1;
  return {sign * (b.x() + edge.step_u - a.x()), sign * (b.y() + edge.step_v - a.y())};
}

void StrandTile::MatchVertices() {
  std::vector<WeightedEdge> edges;
  for (int32_t edge = 0; edge < static_cast<int32_t>(tile_.edges.size()); ++edge) {
    const TileEdge& at = tile_.edges[static_cast<size_t>(edge)];
    edges.push_back({at.from, at.to, std::llround(Norm(DirectionOf(2 * edge)) / kLengthUnit)});
  }
  const PerfectMatching matching =
      LightestPerfectMatching(static_cast<int32_t>(tile_.vertices.size()), edges);
  doubled_.reserve(edges.size());
  for (const WeightedEdge& edge : edges)
    doubled_.push_back(matching.mate[static_cast<size_t>(edge.a)] == edge.b);
}

/// Creates the two lines of each doubled edge, left first. Each line stays on its side of the edge.
void StrandTile::LayCourses() {
  for (int32_t edge = 0; edge < static_cast<int32_t>(doubled_.size()); ++edge) {
    if (!doubled_[static_cast<size_t>(edge)]) continue;
    const Vector2 direction = DirectionOf(2 * edge);
    const auto sides = [&](int32_t vertex, int32_t own) {
      std::array<int32_t, 2> others{};
      size_t count = 0;
      for (const int32_t half : leaving_[static_cast<size_t>(vertex)])
        if (half != own) others[count++] = half;
      if (Cross(direction, DirectionOf(others[0])) < Cross(direction, DirectionOf(others[1])))
        std::swap(others[0], others[1]);
      return others;
    };
    const auto from = sides(tile_.edges[static_cast<size_t>(edge)].from, 2 * edge);
    const auto to = sides(tile_.edges[static_cast<size_t>(edge)].to, 2 * edge + 1);
    for (const size_t side : {0, 1}) courses_.push_back({edge, {from[side], to[side]}});
  }
}

/// Joins two curves that share a doubled edge by crossing their lines there. The shortest suitable
/// edges are used.
void StrandTile::JoinCourses() {
  DisjointSets curves(static_cast<int32_t>(tile_.edges.size()));  // edges used once
  const auto join = [&curves](int32_t a, int32_t b) { return curves.Join(a / 2, b / 2); };
  for (const Course& course : courses_) join(course.ends[0], course.ends[1]);
  std::vector<size_t> pairs;
  for (size_t i = 0; i < courses_.size(); i += 2) pairs.push_back(i);
  std::ranges::stable_sort(pairs, {},
                           [this](size_t i) { return Norm(DirectionOf(2 * courses_[i].edge)); });
  for (const size_t i : pairs) {
    if (!join(courses_[i].ends[0], courses_[i + 1].ends[0])) continue;
    std::swap(courses_[i].ends[1], courses_[i + 1].ends[1]);
    ++crossings_;
  }
}

/// Links each end of a strand with the end of another strand. The two ends meet in the middle of
/// the edge that both strands use.
void StrandTile::LinkStrands() {
  struct End {
    size_t strand = 0;
    int32_t end = 0;
  };
  std::vector<End> end_at(2 * tile_.edges.size());
  for (size_t i = 0; i < courses_.size(); ++i)
    for (const int32_t end : {0, 1})
      end_at[static_cast<size_t>(courses_[i].ends[static_cast<size_t>(end)])] = {i, end};
  strands_.resize(courses_.size());
  for (size_t i = 0; i < courses_.size(); ++i) {
    for (const size_t end : {0, 1}) {
      const int32_t half = courses_[i].ends[end];
      const TileEdge& across = tile_.edges[static_cast<size_t>(half / 2)];
      const int32_t sign = half % 2 == 0 ? 1 : -1;
      const End to = end_at[static_cast<size_t>(half ^ 1)];
      Strand::Next next{static_cast<int32_t>(to.strand), to.end, sign * across.step_u,
                        sign * across.step_v};
      // A strand is in the tile of its doubled edge's first vertex. The second vertex may be in
      // another tile.
      const TileEdge& own = tile_.edges[static_cast<size_t>(courses_[i].edge)];
      const TileEdge& its = tile_.edges[static_cast<size_t>(courses_[to.strand].edge)];
      if (end == 1) next.step_u += own.step_u, next.step_v += own.step_v;
      if (to.end == 1) next.step_u -= its.step_u, next.step_v -= its.step_v;
      strands_[i].next[end] = next;
    }
  }
}

void StrandTile::MeasureBends() {
  for (const Course& course : courses_) {
    const Vector2 doubled = DirectionOf(2 * course.edge);
    const Vector2 first =
        tile_.vertices[static_cast<size_t>(tile_.edges[static_cast<size_t>(course.edge)].from)];
    std::array<Bend, 2>& bends = bends_.emplace_back();
    bends[0].vertex = first;
    bends[1].vertex = {first.x() + doubled.x(), first.y() + doubled.y()};
    for (const size_t end : {0, 1}) {
      bends[end].direction = DirectionOf(course.ends[end]);
      const double aside = std::abs(Cross(bends[end].direction, doubled)) / Norm(doubled);
      bends[end].share_by_gap = aside > 0 ? 0.5 / aside : kSteepest;
    }
  }
}

std::vector<Strand> StrandTile::Strands(double gap) const {
  std::vector<Strand> strands = strands_;
  for (size_t i = 0; i < strands.size(); ++i) {
    const auto& [from, to] = bends_[i];
    strands[i].points = {from.At(0.5), from.At(std::min(kMostOfEdge, gap * from.share_by_gap)),
                         to.At(std::min(kMostOfEdge, gap * to.share_by_gap)), to.At(0.5)};
  }
  return strands;
}

}  // namespace slicefarm::infill
