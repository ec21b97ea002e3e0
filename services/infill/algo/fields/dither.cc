#include "services/infill/algo/fields/dither.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "services/infill/algo/fields/blue_noise.h"
#include "services/infill/algo/fields/cell_limit.h"
#include "services/infill/algo/space_filling/cell_cover.h"

namespace slicefarm::infill {
namespace {

struct Neighbour {
  int64_t x, y;
  double weight;
};
constexpr std::array<Neighbour, 4> kNeighbours = {
    {{1, 0, 7.0}, {-1, 1, 3.0}, {0, 1, 5.0}, {1, 1, 1.0}}};

/// Cells that meet the region's box.
struct Window {
  int64_t first_x, first_y, width, height;
};

Window WindowOf(const MultiPolygon& region, double cell_nm) {
  const Box box = Bounds(region);
  const auto index = [&](Coord at) {
    return static_cast<int64_t>(std::floor(static_cast<double>(at) / cell_nm));
  };
  const int64_t x = index(box.min.x), y = index(box.min.y);
  return {x, y, index(box.max.x - 1) - x + 1, index(box.max.y - 1) - y + 1};
}

/// Which cells the region touches at all, by the area that they have in common.
std::vector<char> Touched(const MultiPolygon& region, const Window& window, Coord cell_nm) {
  std::vector<char> touched(static_cast<size_t>(window.width * window.height), 0);
  for (int64_t y = 0; y < window.height; ++y) {
    const Coord low = (window.first_y + y) * cell_nm;
    const Coord left = window.first_x * cell_nm, right = left + window.width * cell_nm;
    const MultiPolygon row = Intersection(
        region, {{{{left, low}, {right, low}, {right, low + cell_nm}, {left, low + cell_nm}}, {}}});
    for (const PolygonWithHoles& island : row) {
      const Box box = Bounds(island.outer);
      const int64_t first = (box.min.x - left) / cell_nm;
      const int64_t last = std::min((box.max.x - 1 - left) / cell_nm, window.width - 1);
      for (int64_t x = first; x <= last; ++x) touched[static_cast<size_t>(y * window.width + x)] = 1;
    }
  }
  return touched;
}

}  // namespace

namespace {

/// What is left over at the last cells, or was too much there, is made good where the choice was
/// closest: so many cells as that comes to.
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
  if (region.empty() || greatest <= 0) return MultiPolygon{};
  const auto cell_nm = FromMm(cell_mm);
  const Window window = WindowOf(region, static_cast<double>(cell_nm));
  const double cells = static_cast<double>(window.width) * static_cast<double>(window.height);
  if (absl::Status ok = CheckFieldSize(kMaxFieldCells, cells); !ok.ok()) return ok;
  const std::vector<char> touched = Touched(region, window, cell_nm);
  std::vector<double> wanted;
  for (int64_t y = 0; y < window.height; ++y)
    for (int64_t x = 0; x < window.width; ++x)
      wanted.push_back(field.DensityAt((static_cast<double>(window.first_x + x) + 0.5) * cell_mm,
                                       (static_cast<double>(window.first_y + y) + 0.5) * cell_mm) /
                       greatest);
  CellCover cover{.origin = {window.first_x * cell_nm, window.first_y * cell_nm},
                  .cell_nm = cell_nm,
                  .columns = static_cast<int32_t>(window.width),
                  .rows = static_cast<int32_t>(window.height)};
  if (dither == Dither::kFloydSteinberg) {
    cover.inside = FloydSteinberg(wanted, touched, window.width, window.height);
  } else {
    for (int64_t y = 0; y < window.height; ++y)
      for (int64_t x = 0; x < window.width; ++x)
        cover.inside.push_back(wanted[static_cast<size_t>(y * window.width + x)] >
                               BlueNoiseAt(window.first_x + x, window.first_y + y));
  }
  return Intersection(region, Union(OutlineOf(cover), FillRule::kNonZero));
}

}  // namespace slicefarm::infill
