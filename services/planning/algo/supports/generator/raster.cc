#include "services/planning/algo/supports/generator/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace slicefarm::planning {
namespace {

constexpr int kReach = 31;  ///< search distance in pixels; see kFarthest
constexpr int kBlock = 64;  ///< pixels of a row per block; fixed, so that the compiler vectorizes

Coord FloorDiv(Coord a, Coord b) { return a / b - (a % b < 0 ? 1 : 0); }

std::array<PixelDistance, kReach * kReach + 1> MakeRoots() {
  std::array<PixelDistance, kReach * kReach + 1> roots{};
  for (size_t i = 1; i < roots.size(); ++i)
    roots[i] = static_cast<PixelDistance>(
        std::min<long>(kFarthest, std::lround(kDistanceSteps * (std::sqrt(i) - 0.5))));
  return roots;
}

/// Returns distances along columns, up to kReach.
std::vector<uint8_t> ColumnDistances(const Bitmap& bitmap) {
  const PixelGrid& grid = bitmap.grid();
  std::vector<uint8_t> far(grid.size(), kReach);
  const auto row = [&](int32_t y) { return far.data() + static_cast<size_t>(y) * grid.width; };
  for (int32_t y = 0; y < grid.height; ++y) {
    uint8_t* here = row(y);
    const uint8_t* set = bitmap.Row(y);
    for (int32_t x = 0; x < grid.width; ++x) {
      const int before = y > 0 ? row(y - 1)[x] : kReach;
      here[x] = set[x] ? 0 : static_cast<uint8_t>(std::min(before + 1, kReach));
    }
  }
  for (int32_t y = grid.height - 2; y >= 0; --y) {
    uint8_t* here = row(y);
    const uint8_t* above = row(y + 1);
    for (int32_t x = 0; x < grid.width; ++x)
      here[x] = std::min(here[x], static_cast<uint8_t>(above[x] + 1));
  }
  return far;
}

/// Computes the minimum of squared[x + d] + d^2 for |d| <= kReach, for a block of pixels. `squared`
/// has kReach more pixels on both sides.
void LeastSum(const int16_t* squared, int16_t* least) {
  for (int i = 0; i < kBlock; ++i) least[i] = squared[i];
  for (int d = 1; d <= kReach; ++d) {
    const auto more = static_cast<int16_t>(d * d);
    if (d % 4 == 1) {  // stops if no farther pixel can give a smaller sum
      int16_t most = 0;
      for (int i = 0; i < kBlock; ++i) most = std::max(most, least[i]);
      if (most <= more) return;
    }
    for (int i = 0; i < kBlock; ++i) {
      const auto left = static_cast<int16_t>(squared[i - d] + more);
      const auto right = static_cast<int16_t>(squared[i + d] + more);
      least[i] = std::min(least[i], std::min(left, right));
    }
  }
}

}  // namespace

int32_t PixelGrid::Column(Coord x) const {
  return static_cast<int32_t>(std::clamp<Coord>(FloorDiv(x - origin.x, pixel_nm), 0, width - 1));
}

int32_t PixelGrid::Row(Coord y) const {
  return static_cast<int32_t>(std::clamp<Coord>(FloorDiv(y - origin.y, pixel_nm), 0, height - 1));
}

PixelGrid GridOver(const Box& box, Coord pixel_nm) {
  PixelGrid grid;
  grid.pixel_nm = pixel_nm;
  const Coord left = FloorDiv(box.min.x, pixel_nm), bottom = FloorDiv(box.min.y, pixel_nm);
  grid.origin = {left * pixel_nm, bottom * pixel_nm};
  grid.width = static_cast<int32_t>(FloorDiv(box.max.x, pixel_nm) - left + 1);
  grid.height = static_cast<int32_t>(FloorDiv(box.max.y, pixel_nm) - bottom + 1);
  return grid;
}

void Bitmap::Fill(const MultiPolygon& region) {
  crossings_.resize(static_cast<size_t>(grid_.height));
  int32_t first = grid_.height, last = -1;
  // Returns the first row with its centres at y or above, not clamped to the grid.
  const auto row_from = [&](Coord y) {
    return FloorDiv(y - grid_.origin.y + grid_.pixel_nm - grid_.pixel_nm / 2 - 1, grid_.pixel_nm);
  };
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
      if (a.y > b.y) std::swap(a, b);
      const auto from = static_cast<int32_t>(std::clamp<Coord>(row_from(a.y), 0, grid_.height));
      const auto to = static_cast<int32_t>(std::clamp<Coord>(row_from(b.y), 0, grid_.height));
      if (from >= to) continue;
      const double slope = static_cast<double>(b.x - a.x) / static_cast<double>(b.y - a.y);
      first = std::min(first, from);
      last = std::max(last, to - 1);
      for (int32_t y = from; y < to; ++y) {
        const double x = a.x + slope * static_cast<double>(grid_.Centre(0, y).y - a.y);
        const double column = (x - grid_.origin.x) / grid_.pixel_nm - 0.5;
        crossings_[y].push_back(
            static_cast<int32_t>(std::clamp<double>(std::ceil(column), 0, grid_.width)));
      }
    }
  });
  for (int32_t y = first; y <= last; ++y) {
    std::vector<int32_t>& xs = crossings_[y];
    std::sort(xs.begin(), xs.end());
    for (size_t k = 0; k + 1 < xs.size(); k += 2) std::fill(Row(y) + xs[k], Row(y) + xs[k + 1], 1);
    xs.clear();
  }
}

void Bitmap::FillEdges(const MultiPolygon& region) {
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], by = ring[i + 1 < ring.size() ? i + 1 : 0] - a;
      const Coord steps = 1 + 2 * std::max(std::abs(by.x), std::abs(by.y)) / grid_.pixel_nm;
      for (Coord k = 0; k < steps; ++k)
        Row(grid_.Row(a.y + by.y * k / steps))[grid_.Column(a.x + by.x * k / steps)] = 1;
    }
  });
}

std::vector<Polygon> Outline(const Bitmap& bitmap) {
  const PixelGrid& grid = bitmap.grid();
  const auto set = [&](int32_t x, int32_t y) {
    return x >= 0 && y >= 0 && x < grid.width && y < grid.height && bitmap.At(x, y);
  };
  // Edges run with the set pixels to their left. Each ring has an edge along the bottom of a pixel,
  // and `traced` marks these edges.
  std::vector<uint8_t> traced(grid.size(), 0);
  std::vector<Polygon> rings;
  for (int32_t y0 = 0; y0 < grid.height; ++y0) {
    for (int32_t x0 = 0; x0 < grid.width; ++x0) {
      if (!set(x0, y0) || set(x0, y0 - 1)) continue;
      if (traced[static_cast<size_t>(y0) * grid.width + x0]) continue;
      Polygon ring;
      // Start corner of the next edge, and the edge's direction.
      int32_t x = x0, y = y0, dx = 1, dy = 0;
      do {
        if (dx == 1) traced[static_cast<size_t>(y) * grid.width + x] = 1;
        x += dx;
        y += dy;
        // The two pixels ahead, to the left and to the right of the current direction.
        const int32_t lx = x + (dx - dy - 1) / 2, ly = y + (dx + dy - 1) / 2;
        const int32_t rx = x + (dx + dy - 1) / 2, ry = y + (dy - dx - 1) / 2;
        const int32_t was_dx = dx, was_dy = dy;
        if (!set(lx, ly)) {  // turn left: pixels that touch at a corner stay apart
          dx = -was_dy;
          dy = was_dx;
        } else if (set(rx, ry)) {
          dx = was_dy;
          dy = -was_dx;
        }
        if (dx != was_dx || dy != was_dy)
          ring.push_back({grid.origin.x + x * grid.pixel_nm, grid.origin.y + y * grid.pixel_nm});
      } while (x != x0 || y != y0 || dx != 1 || dy != 0);
      rings.push_back(std::move(ring));
    }
  }
  return rings;
}

std::vector<PixelDistance> DistanceTo(const Bitmap& bitmap) {
  static const auto roots = MakeRoots();
  const PixelGrid& grid = bitmap.grid();
  const std::vector<uint8_t> columns = ColumnDistances(bitmap);
  std::vector<PixelDistance> distance(grid.size());
  const int32_t blocks = (grid.width + kBlock - 1) / kBlock;
  constexpr int16_t kFar = kReach * kReach;
  std::vector<int16_t> squared(static_cast<size_t>(blocks) * kBlock + 2 * kReach, kFar);
  std::array<int16_t, kBlock> least{};
  for (int32_t y = 0; y < grid.height; ++y) {
    const uint8_t* column = columns.data() + static_cast<size_t>(y) * grid.width;
    PixelDistance* out = distance.data() + static_cast<size_t>(y) * grid.width;
    for (int32_t x = 0; x < grid.width; ++x)
      squared[static_cast<size_t>(x) + kReach] = static_cast<int16_t>(column[x] * column[x]);
    for (int32_t block = 0; block < blocks; ++block) {
      const int32_t from = block * kBlock, to = std::min(from + kBlock, grid.width);
      LeastSum(squared.data() + kReach + from, least.data());
      for (int32_t x = from; x < to; ++x)
        out[x] = roots[static_cast<size_t>(std::min(least[static_cast<size_t>(x - from)], kFar))];
    }
  }
  return distance;
}

}  // namespace slicefarm::planning
