#include "services/infill/algo/lines/level_lines.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace slicefarm::infill {
namespace {

constexpr int kRootSteps = 60;
constexpr double kRootPrecision = 1e-10;

/// Marching squares over one period. The edges of the grid have numbers: 2 (j count + i) is the
/// edge from grid point (i, j) along u, the next number is the edge along v.
class Marcher {
 public:
  Marcher(const std::function<double(Vector2)>& function, int count)
      : function_(function), count_(count), next_(static_cast<size_t>(2 * count * count)) {
    values_.reserve(static_cast<size_t>(count * count));
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < count; ++i) values_.push_back(function({At(i), At(j)}));
  }

  std::vector<LevelLine> Run() {
    for (int j = 0; j < count_; ++j)
      for (int i = 0; i < count_; ++i) March(i, j);
    std::vector<LevelLine> lines;
    for (size_t edge = 0; edge < next_.size(); ++edge)
      if (next_[edge].to >= 0) lines.push_back(Follow(static_cast<int>(edge)));
    return lines;
  }

 private:
  /// Next edge that a line crosses, and its offset in periods.
  struct Next {
    int to = -1;
    int8_t step_u = 0;
    int8_t step_v = 0;
  };
  struct Place {
    int edge = 0;
    int8_t period_u = 0;
    int8_t period_v = 0;
  };

  double At(int i) const { return static_cast<double>(i) / count_; }
  double Value(int i, int j) const {
    return values_[static_cast<size_t>((j % count_) * count_ + i % count_)];
  }
  Place PlaceOf(int i, int j, bool along_v) const {
    return {2 * ((j % count_) * count_ + i % count_) + (along_v ? 1 : 0),
            static_cast<int8_t>(i / count_), static_cast<int8_t>(j / count_)};
  }

  /// Joins the edges of one square. On a counter-clockwise walk around the square, a line leaves
  /// where the sign changes from minus to plus, so that plus is to its left.
  void March(int i, int j) {
    const std::array<bool, 4> plus = {Value(i, j) >= 0, Value(i + 1, j) >= 0,
                                      Value(i + 1, j + 1) >= 0, Value(i, j + 1) >= 0};
    const std::array<Place, 4> sides = {PlaceOf(i, j, false), PlaceOf(i + 1, j, true),
                                        PlaceOf(i, j + 1, false), PlaceOf(i, j, true)};
    std::array<int, 2> in{}, out{};
    int ins = 0, outs = 0;
    for (int side = 0; side < 4; ++side) {
      const bool from = plus[static_cast<size_t>(side)];
      const bool to = plus[static_cast<size_t>((side + 1) % 4)];
      if (from && !to) in[static_cast<size_t>(ins++)] = side;
      if (!from && to) out[static_cast<size_t>(outs++)] = side;
    }
    if (ins == 0) return;
    if (ins == 2) {
      // The middle is positive: lines turn around the negative corners.
      const bool middle = function_({At(i) + 0.5 / count_, At(j) + 0.5 / count_}) >= 0;
      if ((out[0] == (in[0] + 1) % 4) != middle) std::swap(out[0], out[1]);
    }
    for (int k = 0; k < ins; ++k)
      Join(sides[static_cast<size_t>(in[static_cast<size_t>(k)])],
           sides[static_cast<size_t>(out[static_cast<size_t>(k)])]);
  }

  void Join(Place from, Place to) {
    next_[static_cast<size_t>(from.edge)] = {to.edge,
                                             static_cast<int8_t>(to.period_u - from.period_u),
                                             static_cast<int8_t>(to.period_v - from.period_v)};
  }

  LevelLine Follow(int start) {
    LevelLine line;
    int edge = start;
    do {
      const Vector2 root = Root(edge);
      line.points.push_back({root.x() + line.step_u, root.y() + line.step_v});
      const Next next = std::exchange(next_[static_cast<size_t>(edge)], {});
      line.step_u += next.step_u;
      line.step_v += next.step_v;
      edge = next.to;
    } while (edge != start && edge >= 0);
    if (!line.IsClosed())
      line.points.push_back({line.points[0].x() + line.step_u, line.points[0].y() + line.step_v});
    return line;
  }

  /// Returns the zero on an edge, by the Illinois variant of regula falsi.
  Vector2 Root(int edge) const {
    const int i = edge / 2 % count_, j = edge / 2 / count_;
    const bool along_v = edge % 2 != 0;
    const auto at = [&](double t) {
      return along_v ? Vector2{At(i), At(j) + t / count_} : Vector2{At(i) + t / count_, At(j)};
    };
    double low = 0, high = 1;
    double at_low = Value(i, j), at_high = along_v ? Value(i, j + 1) : Value(i + 1, j);
    for (int step = 0, side = 0; step < kRootSteps && high - low > kRootPrecision; ++step) {
      const double t = (low * at_high - high * at_low) / (at_high - at_low);
      const double value = function_(at(t));
      if (std::abs(value) < kRootPrecision) return at(t);
      if ((value >= 0) == (at_high >= 0)) {
        high = t, at_high = value;
        if (side == 1) at_low /= 2;
        side = 1;
      } else {
        low = t, at_low = value;
        if (side == -1) at_high /= 2;
        side = -1;
      }
    }
    return at((low + high) / 2);
  }

  const std::function<double(Vector2)>& function_;
  const int count_;
  std::vector<double> values_;
  std::vector<Next> next_;  ///< next crossing, indexed by edge
};

}  // namespace

std::vector<LevelLine> LevelLines(const std::function<double(Vector2)>& function, int count) {
  return Marcher(function, count).Run();
}

}  // namespace slicefarm::infill
