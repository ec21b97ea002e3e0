#include "services/infill/algo/fields/direction_field.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace slicefarm::infill {
namespace {

/// Smooths the grid by one pass of 1/4, 1/2, 1/4 along each axis. At the ends the outer node counts
/// twice.
void Smooth(FieldGrid& grid) {
  int64_t stride = 1;
  for (size_t axis = 0; axis < 3; ++axis) {
    const int64_t count = grid.count[axis];
    const std::vector<double> before = grid.values;
    for (int64_t i = 0; i < std::ssize(before); ++i) {
      const int64_t at = i / stride % count;
      const auto value = [&](int64_t step) {
        return before[static_cast<size_t>(at + step < 0 || at + step >= count ? i
                                                                              : i + step * stride)];
      };
      grid.values[static_cast<size_t>(i)] = (value(-1) + 2 * value(0) + value(1)) / 4;
    }
    stride *= count;
  }
}

/// Calls visit(j) for the nodes next to node `i`.
template <typename Visit>
void ForEachNeighbour(const FieldGrid& grid, int64_t i, const Visit& visit) {
  int64_t stride = 1;
  for (const int32_t count : grid.count) {
    const int64_t at = i / stride % count;
    if (at > 0) visit(i - stride);
    if (at + 1 < count) visit(i + stride);
    stride *= count;
  }
}

/// Directions as two grids of the same nodes. A node with 0 in both grids has no direction.
struct Doubled {
  FieldGrid& cos2;
  FieldGrid& sin2;

  bool Has(int64_t i) const {
    const auto at = static_cast<size_t>(i);
    return cos2.values[at] != 0 || sin2.values[at] != 0;
  }

  /// Returns the mean direction of the neighbour nodes, as a unit vector, or (0, 0) if they cancel
  /// each other.
  std::pair<double, double> Around(int64_t i) const {
    double c = 0, s = 0, count = 0;
    ForEachNeighbour(cos2, i, [&](int64_t j) {
      c += cos2.values[static_cast<size_t>(j)];
      s += sin2.values[static_cast<size_t>(j)];
      count += Has(j);
    });
    const double length = std::sqrt(c * c + s * s);
    if (length < DirectionField::kLeastLength * count || length == 0) return {0, 0};
    return {c / length, s / length};
  }
};

/// Gives each node without a direction the mean direction of its neighbours, in waves. Cost:
/// O(nodes).
void Continue(Doubled field) {
  const int64_t count = std::ssize(field.cos2.values);
  std::vector<int64_t> wave;
  std::vector<bool> waits(static_cast<size_t>(count), true);
  const auto add_neighbours = [&](int64_t i, std::vector<int64_t>& to) {
    ForEachNeighbour(field.cos2, i, [&](int64_t j) {
      if (field.Has(j) || !waits[static_cast<size_t>(j)]) return;
      waits[static_cast<size_t>(j)] = false;
      to.push_back(j);
    });
  };
  for (int64_t i = 0; i < count; ++i)
    if (field.Has(i)) add_neighbours(i, wave);
  while (!wave.empty()) {
    std::vector<std::pair<double, double>> found;
    for (const int64_t i : wave) found.push_back(field.Around(i));
    std::vector<int64_t> next;
    for (size_t k = 0; k < wave.size(); ++k) {
      field.cos2.values[static_cast<size_t>(wave[k])] = found[k].first;
      field.sin2.values[static_cast<size_t>(wave[k])] = found[k].second;
    }
    for (const int64_t i : wave)
      if (field.Has(i)) add_neighbours(i, next);
    wave = std::move(next);
  }
}

}  // namespace

DirectionField::DirectionField(const StressField& stress) : cos2_(stress.xx), sin2_(stress.xx) {
  double greatest = 0;
  for (size_t i = 0; i < cos2_.values.size(); ++i) {
    cos2_.values[i] = stress.xx.values[i] - stress.yy.values[i];
    sin2_.values[i] = 2 * stress.xy.values[i];
    greatest = std::max({greatest, std::abs(cos2_.values[i]), std::abs(sin2_.values[i])});
  }
  for (size_t i = 0; i < cos2_.values.size(); ++i) {
    double &c = cos2_.values[i], &s = sin2_.values[i];
    if (greatest > 0) c /= greatest, s /= greatest;
    const double length = std::sqrt(c * c + s * s);
    // The principal stresses are the mean stress plus and minus the maximum shear stress.
    const double mean = stress.xx.values[i] + stress.yy.values[i];
    const double turned = greatest > 0 && mean / greatest < -kEqualPull * length ? -1 : 1;
    const bool alike = length < kAlike;
    c = alike ? 0 : turned * c / length;
    s = alike ? 0 : turned * s / length;
  }
  Continue({cos2_, sin2_});
  for (int32_t pass = 0; pass < stress.smoothing; ++pass) Smooth(cos2_), Smooth(sin2_);
}

std::optional<Vector2> DirectionField::At(const PositionMm& position_mm) const {
  const double c = cos2_.At(position_mm), s = sin2_.At(position_mm);
  if (c * c + s * s < kLeastLength * kLeastLength) return std::nullopt;
  // Halves the angle. The formula is chosen by the sign of c, so that no digits are lost.
  const double length = std::sqrt(c * c + s * s);
  if (c >= 0) {
    const double x = std::sqrt((1 + c / length) / 2);
    return Vector2{x, s / length / (2 * x)};
  }
  const double y = std::sqrt((1 - c / length) / 2);
  return Vector2{s / length / (2 * y), y};
}

}  // namespace slicefarm::infill
