#include "services/slicing/algo/section/adaptive_heights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "services/slicing/algo/topology/edge_table.h"

namespace slicefarm::slicing {
namespace {

/// Approximate distance between two possible layer ends, in nm. With thick layers the distance is
/// larger, so that a layer has at most kMostSteps possible heights.
constexpr Coord kLeastStepNm = 10'000;
constexpr Coord kMostSteps = 48;
/// Smallest area in nm^2 of a level face that needs a layer top. Smaller faces are not visible.
constexpr double kLeastLevelNm2 = 1e12;
/// Distance below which two level faces count as one.
constexpr Coord kSameNm = 2'000;

/// Costs of a solution. The number of layers counts most, then level faces without a layer top,
/// then changes of height.
constexpr int64_t kLayer = 1'000'000;
constexpr int64_t kMissedLevel = 10 * kLayer;
/// cost of two neighbouring layers with a height ratio above the limit
constexpr int64_t kJump = 5 * kLayer;
constexpr Coord kChangeNm = 100;  ///< change of height that costs 1
constexpr int64_t kNever = std::numeric_limits<int64_t>::max();

struct Slope {
  Coord low = 0;
  Coord high = 0;
  double level = 0;  ///< absolute z component of the unit normal
  double area2_nm2 = 0;
};

Slope SteepnessOf(const IndexedMesh& mesh, const Triangle& t) {
  const std::array<Vertex, 3> v = {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
  const auto a = [&](int i) {
    return std::array<double, 3>{static_cast<double>(v[i].x - v[0].x),
                                 static_cast<double>(v[i].y - v[0].y),
                                 static_cast<double>(v[i].z - v[0].z)};
  };
  const auto p = a(1), q = a(2);
  const double x = p[1] * q[2] - p[2] * q[1], y = p[2] * q[0] - p[0] * q[2],
               z = p[0] * q[1] - p[1] * q[0];
  const double length = std::sqrt(x * x + y * y + z * z);
  const auto [low, high] = std::minmax({v[0].z, v[1].z, v[2].z});
  return {low, high, length > 0 ? std::abs(z) / length : 0, length};
}

/// Returns the heights of level faces between `from` and `to`, upwards. Level faces close to each
/// other count as one.
std::vector<Coord> Levels(const std::vector<Slope>& faces, Coord from, Coord to) {
  std::map<Coord, double> areas;
  for (const Slope& face : faces)
    if (face.low == face.high && from < face.low && face.low < to)
      areas[face.low] += face.area2_nm2 / 2;
  std::vector<Coord> levels;
  for (const auto& [z, area] : areas)
    if (area >= kLeastLevelNm2 && z >= (levels.empty() ? from : levels.back()) + kSameNm)
      levels.push_back(z);
  return levels;
}

/// Possible ends of layers. The heights from one level face to the next are divided into equal
/// steps. The ends continue above the object's top, as far as the last layer may reach.
struct LayerEnds {
  std::vector<Coord> z;
  std::vector<uint8_t> level;  ///< 1 if the height is a level
  size_t top = 0;              ///< index of the object's top
};

LayerEnds EndsFor(const std::vector<Coord>& levels, Coord first, Coord top, Coord step,
                  Coord beyond) {
  LayerEnds places;
  const auto fill = [&](Coord from, Coord to) {
    const Coord steps = std::max<Coord>(1, (to - from + step / 2) / step);
    for (Coord i = 1; i <= steps; ++i) {
      places.z.push_back(from + (to - from) * i / steps);
      places.level.push_back(i == steps ? 1 : 0);
    }
  };
  places.z.push_back(first);
  places.level.push_back(0);
  for (const Coord level : levels) fill(places.z.back(), level);
  if (top > places.z.back()) fill(places.z.back(), top);
  places.top = places.z.size() - 1;
  const Coord end = places.z.back();
  for (Coord z = end + step; z <= end + beyond + step; z += step) {
    places.z.push_back(z);
    places.level.push_back(0);
  }
  return places;
}

/// Returns for each interval between two consecutive possible ends the largest height of a layer
/// that contains the interval.
std::vector<Coord> Bounds(std::vector<Slope> faces, const LayerEnds& places,
                          const AdaptiveHeights& options) {
  const size_t count = places.z.size() - 1;
  std::vector<Coord> bounds(count, options.max_nm);
  const auto allowed = [&](const Slope& face) {
    return static_cast<double>(options.cusp_nm) / face.level;
  };
  std::erase_if(faces, [&](const Slope& face) {
    return face.low == face.high || face.level == 0 ||
           allowed(face) >= static_cast<double>(options.max_nm);
  });
  std::ranges::sort(faces, [&](const Slope& a, const Slope& b) {
    return std::tuple(allowed(a), a.low, a.high) < std::tuple(allowed(b), b.low, b.high);
  });
  // The strictest faces are first. `next` skips the intervals that already have a bound.
  std::vector<size_t> next(count + 1);
  std::iota(next.begin(), next.end(), size_t{0});
  const auto free_from = [&](size_t i) {
    while (next[i] != i) i = next[i] = next[next[i]];
    return i;
  };
  for (const Slope& face : faces) {
    const auto begin = std::ranges::upper_bound(places.z, face.low);
    size_t i = begin == places.z.begin() ? 0 : static_cast<size_t>(begin - places.z.begin()) - 1;
    for (i = free_from(std::min(i, count)); i < count && places.z[i] < face.high;
         i = free_from(i)) {
      bounds[i] = static_cast<Coord>(allowed(face));
      next[i] = i + 1;
    }
  }
  return bounds;
}

/// Returns the height requested for a layer with this bottom, or nothing if any height is allowed.
std::optional<Coord> AskedAt(Coord bottom_nm, const std::vector<RangeInput>& ranges) {
  for (const RangeInput& range : ranges)
    if (range.from_nm <= bottom_nm && bottom_nm < range.to_nm) return range.layer_height_nm;
  return std::nullopt;
}

/// Dynamic program over all possible layer ends. For each end and each height of the last layer, it
/// stores the sequence of layers with the lowest cost. The lowest layer is always allowed, so there
/// is always a solution.
class Fitting {
 public:
  /// `most_nm`: the greatest allowed height of a layer.
  Fitting(const LayerEnds& places, std::vector<Coord> bounds, const HeightProblem& problem,
          const AdaptiveHeights& options, Coord step_nm, Coord most_nm)
      : places_(places),
        bounds_(std::move(bounds)),
        problem_(problem),
        options_(options),
        step_nm_(step_nm),
        most_nm_(most_nm) {
    for (size_t i = 0; i < places.z.size(); ++i) {
      size_t k = i;
      while (k + 1 < places.z.size() && places.z[k + 1] - places.z[i] <= most_nm + step_nm) ++k;
      reach_ = std::max(reach_, k - i);
    }
    states_.assign(places.z.size() * (reach_ + 1), {});
  }

  std::vector<Coord> Tops() {
    At(0, 0) = {0, 0};
    for (size_t i = 0; i < places_.top; ++i)
      for (size_t back = 0; back <= std::min(i, reach_); ++back)
        if (At(i, back).cost != kNever) GoOn(i, back);
    return WayBack(Best());
  }

 private:
  struct State {
    int64_t cost = kNever;
    /// Height of the previous layer, in steps; 0: there is none.
    uint32_t before = 0;
  };
  using Key = std::pair<size_t, size_t>;  // end of a layer, and its height, both in steps

  State& At(size_t place, size_t back) { return states_[place * (reach_ + 1) + back]; }

  /// Tries all layers on top of the layer that ends at index `i` and is `back` steps high.
  void GoOn(size_t i, size_t back) {
    const State from = At(i, back);
    const Coord before = back == 0 ? 0 : places_.z[i] - places_.z[i - back];
    const std::optional<Coord> asked = AskedAt(places_.z[i], problem_.ranges);
    Coord bound = options_.max_nm;
    int64_t missed = 0;
    for (size_t k = i + 1; k < places_.z.size() && k - i <= reach_; ++k) {
      const Coord height = places_.z[k] - places_.z[i];
      bound = std::min(bound, bounds_[k - 1]);
      const Fit fit = FitOf(height, before, bound, asked);
      if (fit == Fit::kTooHigh) return;
      if (fit != Fit::kTooLow) {
        const int64_t change = before == 0 ? 0 : std::abs(height - before) / kChangeNm;
        State& to = At(k, k - i);
        const int64_t jump = fit == Fit::kJump ? kJump : 0;
        const int64_t cost = from.cost + kLayer + missed + change + jump;
        if (cost < to.cost) to = {cost, static_cast<uint32_t>(back)};
      }
      missed += places_.level[k] ? kMissedLevel : 0;
    }
  }

  enum class Fit : uint8_t { kTooLow, kGood, kJump, kTooHigh };

  Fit FitOf(Coord height, Coord before, Coord bound, std::optional<Coord> asked) const {
    if (asked) {  // one step is always this near: steps are at most 1.5 step_nm_
      const Coord off = step_nm_ * 3 / 4 + 1;
      if (height < *asked - off) return Fit::kTooLow;
      return height <= *asked + off ? Fit::kGood : Fit::kTooHigh;
    }
    if (height < options_.min_nm) return Fit::kTooLow;
    const bool lowest = height < options_.min_nm + 2 * step_nm_;
    if (!lowest && (height > options_.max_nm || height > bound)) return Fit::kTooHigh;
    if (before == 0) return Fit::kGood;
    const auto h = static_cast<double>(height), b = static_cast<double>(before);
    if (h * options_.max_ratio < b) return lowest ? Fit::kJump : Fit::kTooLow;
    if (h <= b * options_.max_ratio) return Fit::kGood;
    return lowest ? Fit::kJump : Fit::kTooHigh;
  }

  /// Returns the end of the last layer with the lowest cost: at the object's top, or less than half
  /// a layer away from it.
  Key Best() {
    Key best{0, 0};
    int64_t least = kNever;
    const Coord top = places_.z[places_.top];
    for (size_t i = 0; i < places_.z.size(); ++i) {
      const Coord off = std::abs(places_.z[i] - top);
      if (off > most_nm_ / 2) continue;
      for (size_t back = 0; back <= std::min(i, reach_); ++back) {
        const int64_t cost = At(i, back).cost;
        const bool cut_above = i > places_.top && (places_.z[i] + places_.z[i - back]) / 2 >= top;
        if (cost == kNever || cut_above) continue;
        const int64_t all = cost + (off == 0 ? 0 : kMissedLevel + off / kChangeNm);
        if (all < least) least = all, best = {i, back};
      }
    }
    return best;
  }

  std::vector<Coord> WayBack(Key key) {
    std::vector<Coord> tops;
    while (true) {
      tops.push_back(places_.z[key.first]);
      if (key.second == 0) break;
      const size_t before = At(key.first, key.second).before;
      key = {key.first - key.second, before};
    }
    std::ranges::reverse(tops);
    return tops;
  }

  const LayerEnds& places_;
  const std::vector<Coord> bounds_;
  const HeightProblem& problem_;
  const AdaptiveHeights& options_;
  const Coord step_nm_;
  const Coord most_nm_;
  size_t reach_ = 1;  ///< largest height of a layer, in steps
  std::vector<State> states_;
};

}  // namespace

std::vector<Coord> AdaptiveTops(const HeightProblem& problem, const AdaptiveHeights& options) {
  std::vector<Slope> faces;
  for (const IndexedMesh* mesh : problem.solids)
    for (const Triangle& t : mesh->triangles) faces.push_back(SteepnessOf(*mesh, t));
  if (problem.top_nm <= problem.first_nm) return {problem.first_nm};
  const std::vector<Coord> levels =
      Levels(faces, problem.first_nm + kSameNm, problem.top_nm - kSameNm);
  Coord most = options.max_nm;
  for (const RangeInput& range : problem.ranges) most = std::max(most, range.layer_height_nm);
  const Coord step = std::max(kLeastStepNm, most / kMostSteps);
  const LayerEnds places = EndsFor(levels, problem.first_nm, problem.top_nm, step, most);
  return Fitting(places, Bounds(std::move(faces), places, options), problem, options, step, most)
      .Tops();
}

}  // namespace slicefarm::slicing
