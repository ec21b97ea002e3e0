#include "common/geometry/skeleton/chords.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/portable_math.h"

namespace slicefarm {
namespace {

/// Distance below which two points on a curved edge are merged.
constexpr double kLeastChordNm = 5'000;
constexpr int kMaxChords = 256;  ///< maximum number of chords of one edge

class ChordMaker {
 public:
  ChordMaker(SkeletalGraph graph, const SkeletalOptions& options)
      : graph_(std::move(graph)), options_(options) {}

  SkeletalGraph Make() && {
    curves_.swap(graph_.half_edges);
    graph_.half_edges.reserve(2 * curves_.size());
    first_.resize(curves_.size());
    for (int half = 0; half < static_cast<int>(curves_.size()); half += 2) AddChords(half);
    // A curve begins where the one before it ends.
    for (size_t half = 0; half < curves_.size(); ++half)
      Link(first_[half ^ 1] ^ 1, first_[curves_[half].next]);
    return std::move(graph_);
  }

 private:
  void Link(int half, int next) {
    graph_.half_edges[half].next = next;
    graph_.half_edges[next].previous = half;
  }

  void AddChords(int curve) {
    const HalfEdge left = curves_[curve], right = curves_[curve + 1];
    int at = left.from;
    first_[curve] = static_cast<int>(graph_.half_edges.size());
    for (const SkeletalNode& node : NodesAlong(curve)) {
      graph_.nodes.push_back(node);
      AddChord(at, left, static_cast<int>(graph_.nodes.size()) - 1, right);
      at = static_cast<int>(graph_.nodes.size()) - 1;
    }
    AddChord(at, left, right.from, right);
    first_[curve + 1] = static_cast<int>(graph_.half_edges.size()) - 1;
  }

  /// Adds a chord that is linked to the chords before and after it, as if these existed.
  void AddChord(int from, const HalfEdge& left, int to, const HalfEdge& right) {
    const int half = static_cast<int>(graph_.half_edges.size());
    graph_.half_edges.push_back({from, half + 2, half - 2, left.feature, left.is_corner});
    graph_.half_edges.push_back({to, half - 1, half + 3, right.feature, right.is_corner});
  }

  std::vector<SkeletalNode> NodesAlong(int curve) const {
    const HalfEdge &left = curves_[curve], &right = curves_[curve + 1];
    if (left.is_corner && right.is_corner)
      return BetweenCorners(left.feature, right.feature, left.from, right.from);
    if (left.is_corner) return AlongParabola(left.feature, right.feature, left.from, right.from);
    if (right.is_corner) return AlongParabola(right.feature, left.feature, left.from, right.from);
    return {};
  }

  /// Returns sorted parameters strictly between `from` and `to`: `marks`, and further parameters so
  /// that no step is longer than `step`. No two parameters are nearer to each other than
  /// kLeastChordNm.
  std::vector<double> Parameters(double from, double to, std::vector<double> marks,
                                 double step) const {
    const double low = std::min(from, to), high = std::max(from, to);
    std::erase_if(marks, [&](double m) { return m <= low || m >= high; });
    marks.push_back(high);
    std::sort(marks.begin(), marks.end());
    std::vector<double> parameters;
    double at = low;
    for (const double mark : marks) {
      const int pieces = std::clamp(static_cast<int>(std::ceil((mark - at) / step)), 1, kMaxChords);
      for (int i = 1; i <= pieces; ++i) {
        const double p = at + (mark - at) * i / pieces;
        const double before = parameters.empty() ? low : parameters.back();
        if (p - before >= kLeastChordNm && high - p >= kLeastChordNm) parameters.push_back(p);
      }
      at = mark;
    }
    if (from > to) std::reverse(parameters.begin(), parameters.end());
    return parameters;
  }

  double StepFor(double height) const {
    return std::min(options_.step_nm, std::sqrt(8 * std::max(height, 1.0) * options_.tolerance_nm));
  }

  /// Returns nodes with equal distances to a corner and to the line of an edge.
  std::vector<SkeletalNode> AlongParabola(int corner, int edge, int from, int to) const {
    const Vector2 focus = ToVector(graph_.boundary[corner].from);
    const BoundaryEdge& directrix = graph_.boundary[edge];
    const Point d = directrix.to - directrix.from;
    const double length = Norm(d);
    const double ux = static_cast<double>(d.x) / length, uy = static_cast<double>(d.y) / length;
    const double height = directrix.SideOf(focus) / length;
    if (height < 1) return {};
    const auto along = [&](int node) {
      const Vector2 p = graph_.nodes[node].place;
      return (p.x() - focus.x()) * ux + (p.y() - focus.y()) * uy;
    };
    const double mark = height * Tan(options_.transition_angle / 2);
    std::vector<SkeletalNode> nodes;
    for (const double t : Parameters(along(from), along(to), {-mark, 0, mark}, StepFor(height))) {
      const double radius = (t * t + height * height) / (2 * height);
      const double rise = radius - height;
      nodes.push_back({{focus.x() + t * ux - rise * uy, focus.y() + t * uy + rise * ux}, radius});
    }
    return nodes;
  }

  /// Returns nodes with equal distances to two corners.
  std::vector<SkeletalNode> BetweenCorners(int a, int b, int from, int to) const {
    const Vector2 p = ToVector(graph_.boundary[a].from), q = ToVector(graph_.boundary[b].from);
    const double half = Hypot(q.x() - p.x(), q.y() - p.y()) / 2;
    if (half < 1) return {};
    const Vector2 middle = {(p.x() + q.x()) / 2, (p.y() + q.y()) / 2};
    const double ux = -(q.y() - p.y()) / (2 * half), uy = (q.x() - p.x()) / (2 * half);
    const auto along = [&](int node) {
      const Vector2 at = graph_.nodes[node].place;
      return (at.x() - middle.x()) * ux + (at.y() - middle.y()) * uy;
    };
    const double mark = half * Tan(options_.transition_angle / 2);
    // The radius becomes straighter with the distance from the centre. Even steps of u in t = half
    // sinh(u) therefore have an error of at most half u^2 / 8.
    const auto stretched = [&](double t) { return half * Asinh(t / half); };
    std::vector<SkeletalNode> nodes;
    for (const double u : Parameters(stretched(along(from)), stretched(along(to)),
                                     {-stretched(mark), 0, stretched(mark)}, StepFor(half))) {
      const double t = half * Sinh(u / half);
      nodes.push_back({{middle.x() + t * ux, middle.y() + t * uy}, Hypot(t, half)});
    }
    return nodes;
  }

  SkeletalGraph graph_;
  const SkeletalOptions& options_;
  std::vector<HalfEdge> curves_;  ///< half-edges before they are divided
  std::vector<int> first_;        ///< first chord of each curve
};

}  // namespace

SkeletalGraph WithChords(SkeletalGraph graph, const SkeletalOptions& options) {
  return ChordMaker(std::move(graph), options).Make();
}

}  // namespace slicefarm
