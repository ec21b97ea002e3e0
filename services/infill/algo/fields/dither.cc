#include "services/infill/algo/fields/dither.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "services/infill/algo/fields/blue_noise.h"
#include "services/infill/algo/fields/field_cells.h"

namespace slicefarm::infill {
namespace {

struct Neighbour {
  int64_t x, y;
  double weight;
};
constexpr std::array<Neighbour, 4> kNeighbours = {
    {{1, 0, 7.0}, {-1, 1, 3.0}, {0, 1, 5.0}, {1, 1, 1.0}}};

/// Corrects the error that remains after the last cell. Switches as many cells as the rounded
/// error, beginning with the cells with values nearest to 0.5.
void SettleRest(const std::vector<double>& wanted, const std::vector<double>& values,
                const std::vector<char>& used, std::vector<char>& on) {
  double rest = 0;
  std::vector<size_t> cells;
  for (size_t i = 0; i < on.size(); ++i) {
    if (!used.empty() && used[i] == 0) continue;
    rest += wanted[i] - (on[i] != 0 ? 1 : 0);
    cells.push_back(i);
  }
  const int64_t count = std::llround(std::abs(rest));
  const char from = rest > 0 ? 0 : 1;
  std::erase_if(cells, [&](size_t i) { return on[i] != from; });
  std::ranges::stable_sort(cells, {}, [&](size_t i) { return std::abs(values[i] - 0.5); });
  for (size_t i = 0; i < std::min(cells.size(), static_cast<size_t>(count)); ++i)
    on[cells[i]] = from == 0;
}

std::vector<char> BlueNoise(const std::vector<double>& wanted, const FieldCells& cells) {
  std::vector<char> on;
  for (size_t i = 0; i < wanted.size(); ++i) {
    const auto place = static_cast<int64_t>(i);
    on.push_back(wanted[i] > BlueNoiseAt(cells.first_x + place % cells.width,
                                         cells.first_y + place / cells.width));
  }
  return on;
}

}  // namespace

std::vector<char> FloydSteinberg(const std::vector<double>& wanted, const std::vector<char>& used,
                                 int64_t width, int64_t height) {
  std::vector<double> values = wanted;
  std::vector<char> on(values.size(), 0);
  const auto at = [&](int64_t x, int64_t y) { return static_cast<size_t>(y * width + x); };
  const auto is_used = [&](int64_t x, int64_t y) {
    return x >= 0 && x < width && y < height && (used.empty() || used[at(x, y)] != 0);
  };
  for (int64_t y = 0; y < height; ++y) {
    for (int64_t x = 0; x < width; ++x) {
      if (!is_used(x, y)) continue;
      on[at(x, y)] = values[at(x, y)] >= 0.5;
      const double error = values[at(x, y)] - (on[at(x, y)] != 0 ? 1 : 0);
      double weights = 0;
      for (const Neighbour& n : kNeighbours)
        if (is_used(x + n.x, y + n.y)) weights += n.weight;
      if (weights == 0) continue;
      for (const Neighbour& n : kNeighbours)
        if (is_used(x + n.x, y + n.y)) values[at(x + n.x, y + n.y)] += error * n.weight / weights;
    }
  }
  SettleRest(wanted, values, used, on);
  return on;
}

absl::StatusOr<MultiPolygon> DitheredRegion(const MultiPolygon& region, const LayerField& field,
                                            Dither dither, double greatest, double cell_mm) {
  if (greatest <= 0) return MultiPolygon{};
  const auto cells = FieldCellsOf(region, field, cell_mm);
  if (!cells.ok()) return cells.status();
  std::vector<double> wanted = cells->density;
  for (double& share : wanted) share /= greatest;
  return PartInCells(region, *cells,
                     dither == Dither::kFloydSteinberg
                         ? FloydSteinberg(wanted, cells->touched, cells->width, cells->height)
                         : BlueNoise(wanted, *cells));
}

}  // namespace slicefarm::infill
