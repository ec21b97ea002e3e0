#include "services/infill/algo/fields/blue_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "common/base/portable_math.h"

namespace slicefarm::infill {
namespace {

constexpr double kSigma = 1.5;          // width of the filter in cells: Ulichney's choice
constexpr int32_t kCellsPerStart = 10;  // one in this number of cells is set at the start
constexpr uint32_t kSeed = 20'261;

/// Returns e^-x.
double ExpOfMinus(double x) {
  const double s = Sinh(x);
  return 1 / (s + std::sqrt(1 + s * s));
}

/// Set cells, and for each cell how crowded its surroundings are. Opposite sides of the square are
/// neighbours.
class Pattern {
 public:
  explicit Pattern(int32_t side)
      : side_(side), set_(Size(), 0), crowd_(Size(), 0), filter_(Size(), 0) {
    for (int32_t y = 0; y < side; ++y) {
      for (int32_t x = 0; x < side; ++x) {
        const double dx = std::min(x, side - x), dy = std::min(y, side - y);
        const double exponent = (dx * dx + dy * dy) / (2 * kSigma * kSigma);
        filter_[static_cast<size_t>(y * side + x)] = exponent < 50 ? ExpOfMinus(exponent) : 0;
      }
    }
  }

  bool IsSet(int32_t cell) const { return set_[static_cast<size_t>(cell)] != 0; }

  void Set(int32_t cell, bool on) {
    set_[static_cast<size_t>(cell)] = on;
    const int32_t cx = cell % side_, cy = cell / side_;
    for (int32_t y = 0; y < side_; ++y) {
      const int32_t row = (y - cy + side_) % side_ * side_;
      for (int32_t x = 0; x < side_; ++x) {
        const double weight = filter_[static_cast<size_t>(row + (x - cx + side_) % side_)];
        crowd_[static_cast<size_t>(y * side_ + x)] += on ? weight : -weight;
      }
    }
  }

  /// Returns the most crowded set cell. If several are equal, returns the first one.
  int32_t TightestCluster() const {
    return Best([](double a, double b) { return a > b; }, true);
  }
  int32_t LargestVoid() const {
    return Best([](double a, double b) { return a < b; }, false);
  }

 private:
  size_t Size() const { return static_cast<size_t>(side_) * static_cast<size_t>(side_); }

  template <class Better>
  int32_t Best(Better better, bool set) const {
    int32_t best = -1;
    for (int32_t i = 0; i < side_ * side_; ++i) {
      if (IsSet(i) != set) continue;
      if (best < 0 || better(crowd_[static_cast<size_t>(i)], crowd_[static_cast<size_t>(best)]))
        best = i;
    }
    return best;
  }

  int32_t side_;
  std::vector<char> set_;
  std::vector<double> crowd_;
  std::vector<double> filter_;
};

/// Returns random cells that are then evened out: the cell of the tightest cluster moves to the
/// largest void until it would move back. The number of moves is limited, because rounding could
/// make the moves endless.
Pattern Start(int32_t side, uint32_t seed, int32_t count) {
  Pattern pattern(side);
  for (int32_t placed = 0; placed < count;) {
    seed = seed * 1664525U + 1013904223U;  // Numerical Recipes' generator
    const auto cell = static_cast<int32_t>((seed >> 8) % static_cast<uint32_t>(side * side));
    if (pattern.IsSet(cell)) continue;
    pattern.Set(cell, true);
    ++placed;
  }
  for (int32_t move = 0; move < side * side; ++move) {
    const int32_t cluster = pattern.TightestCluster();
    pattern.Set(cluster, false);
    const int32_t empty = pattern.LargestVoid();
    pattern.Set(empty, true);
    if (empty == cluster) break;
  }
  return pattern;
}

}  // namespace

std::vector<int32_t> VoidAndCluster(int32_t side, uint32_t seed) {
  const int32_t size = side * side;
  const int32_t count = std::max(1, size / kCellsPerStart);
  const Pattern start = Start(side, seed, count);
  std::vector<int32_t> ranks(static_cast<size_t>(size), 0);
  Pattern fewer = start;
  for (int32_t rank = count - 1; rank >= 0; --rank) {
    const int32_t cell = fewer.TightestCluster();
    fewer.Set(cell, false);
    ranks[static_cast<size_t>(cell)] = rank;
  }
  Pattern more = start;
  for (int32_t rank = count; rank < size; ++rank) {
    const int32_t cell = more.LargestVoid();
    more.Set(cell, true);
    ranks[static_cast<size_t>(cell)] = rank;
  }
  return ranks;
}

double BlueNoiseAt(int64_t column, int64_t row) {
  static const std::vector<int32_t>& ranks =
      *new std::vector<int32_t>(VoidAndCluster(kBlueNoiseSide, kSeed));
  const auto wrap = [](int64_t i) {
    return static_cast<size_t>((i % kBlueNoiseSide + kBlueNoiseSide) % kBlueNoiseSide);
  };
  return (ranks[wrap(row) * kBlueNoiseSide + wrap(column)] + 0.5) /
         (kBlueNoiseSide * kBlueNoiseSide);
}

}  // namespace slicefarm::infill
