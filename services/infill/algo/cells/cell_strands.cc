#include "services/infill/algo/cells/cell_strands.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/base/perfect_matching.h"

namespace slicefarm::infill {
namespace {

/// Lengths of edges as integers, in tiles.
constexpr double kLengthUnit = 1e-9;
/// A corner lies no farther along an edge than this share of it.
constexpr double kMostOfEdge = 0.45;

double CrossOf(Vec a, Vec b) { return a.u * b.v - a.v * b.u; }
double LengthOf(Vec a) { return std::sqrt(a.u * a.u + a.v * a.v); }
Vec Along(Vec from, Vec way, double share) {
  return {from.u + share * way.u, from.v + share * way.v};
}

int32_t Root(std::vector<int32_t>& parent, int32_t i) {
  while (parent[static_cast<size_t>(i)] != i)
    i = parent[static_cast<size_t>(i)] =
        parent[static_cast<size_t>(parent[static_cast<size_t>(i)])];
  return i;
}

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
}

Vec StrandTile::Way(int32_t half) const {
  const TileEdge& edge = tile_.edges[static_cast<size_t>(half / 2)];
  const Vec a = tile_.vertices[static_cast<size_t>(edge.from)];
  const Vec b = tile_.vertices[static_cast<size_t>(edge.to)];
  const double sign = half % 2 == 0 ? 1 : -1;
  return {sign * (b.u + edge.step_u - a.u), sign * (b.v + edge.step_v - a.v)};
}

void StrandTile::MatchVertices() {
  std::vector<WeightedEdge> edges;
  for (int32_t edge = 0; edge < static_cast<int32_t>(tile_.edges.size()); ++edge) {
    const TileEdge& at = tile_.edges[static_cast<size_t>(edge)];
    edges.push_back({at.from, at.to, std::llround(LengthOf(Way(2 * edge)) / kLengthUnit)});
  }
  const PerfectMatching matching =
      LightestPerfectMatching(static_cast<int32_t>(tile_.vertices.size()), edges);
  doubled_.reserve(edges.size());
  for (const WeightedEdge& edge : edges)
    doubled_.push_back(matching.mate[static_cast<size_t>(edge.a)] == edge.b);
}

/// Both lines of a doubled edge stay on their side of it: left first.
void StrandTile::LayCourses() {
  for (int32_t edge = 0; edge < static_cast<int32_t>(doubled_.size()); ++edge) {
    if (!doubled_[static_cast<size_t>(edge)]) continue;
    const Vec way = Way(2 * edge);
    const auto sides = [&](int32_t vertex, int32_t own) {
      std::array<int32_t, 2> others{};
      size_t count = 0;
      for (const int32_t half : leaving_[static_cast<size_t>(vertex)])
        if (half != own) others[count++] = half;
      if (CrossOf(way, Way(others[0])) < CrossOf(way, Way(others[1])))
        std::swap(others[0], others[1]);
      return others;
    };
    const auto from = sides(tile_.edges[static_cast<size_t>(edge)].from, 2 * edge);
    const auto to = sides(tile_.edges[static_cast<size_t>(edge)].to, 2 * edge + 1);
    for (const size_t side : {0, 1}) courses_.push_back({from[side], to[side], 2 * edge});
  }
}

/// Two curves that share a doubled edge become one where their lines there cross.
void StrandTile::JoinCourses() {
  std::vector<int32_t> curve(tile_.edges.size());  // of an edge that is walked once
  std::iota(curve.begin(), curve.end(), 0);
  const auto join = [&curve](int32_t a, int32_t b) {
    a = Root(curve, a / 2), b = Root(curve, b / 2);
    curve[static_cast<size_t>(std::max(a, b))] = std::min(a, b);
    return a != b;
  };
  for (const Course& course : courses_) join(course.from, course.to);
  for (size_t i = 0; i + 1 < courses_.size(); i += 2) {
    if (!join(courses_[i].from, courses_[i + 1].from)) continue;
    std::swap(courses_[i].to, courses_[i + 1].to);
    ++crossings_;
  }
}

Vec StrandTile::Corner(Vec vertex, int32_t half, int32_t along, double gap) const {
  const Vec way = Way(half), doubled = Way(along);
  const double sine = std::abs(CrossOf(way, doubled)) / LengthOf(doubled);  // times the way
  const double share = sine > 0 ? gap / 2 / sine : kMostOfEdge;
  return Along(vertex, way, std::min(share, kMostOfEdge));
}

std::vector<Strand> StrandTile::Strands(double gap) const {
  struct End {
    int32_t strand = 0;
    int32_t end = 0;
  };
  std::vector<End> end_at(2 * tile_.edges.size());
  std::vector<Strand> strands;
  for (int32_t i = 0; i < static_cast<int32_t>(courses_.size()); ++i) {
    const Course& course = courses_[static_cast<size_t>(i)];
    end_at[static_cast<size_t>(course.from)] = {i, 0};
    end_at[static_cast<size_t>(course.to)] = {i, 1};
    const TileEdge& edge = tile_.edges[static_cast<size_t>(course.along / 2)];
    const Vec u = tile_.vertices[static_cast<size_t>(edge.from)];
    const Vec v = Along(u, Way(course.along), 1);
    strands.push_back({{Along(u, Way(course.from), 0.5), Corner(u, course.from, course.along, gap),
                        Corner(v, course.to, course.along, gap), Along(v, Way(course.to), 0.5)},
                       {}});
  }
  const auto second = [this](int32_t strand) {  // where its second vertex lies, from its first
    const Course& course = courses_[static_cast<size_t>(strand)];
    const TileEdge& edge = tile_.edges[static_cast<size_t>(course.along / 2)];
    return std::pair(edge.step_u, edge.step_v);
  };
  for (int32_t i = 0; i < static_cast<int32_t>(courses_.size()); ++i) {
    for (const int32_t end : {0, 1}) {
      const Course& course = courses_[static_cast<size_t>(i)];
      const int32_t half = end == 0 ? course.from : course.to;
      const TileEdge& edge = tile_.edges[static_cast<size_t>(half / 2)];
      const int32_t sign = half % 2 == 0 ? 1 : -1;
      const End to = end_at[static_cast<size_t>(half ^ 1)];
      Strand::Next& next = strands[static_cast<size_t>(i)].next[static_cast<size_t>(end)];
      next = {to.strand, to.end, sign * edge.step_u, sign * edge.step_v};
      if (end == 1) next.step_u += second(i).first, next.step_v += second(i).second;
      if (to.end == 1) {
        next.step_u -= second(to.strand).first;
        next.step_v -= second(to.strand).second;
      }
    }
  }
  return strands;
}

}  // namespace slicefarm::infill
