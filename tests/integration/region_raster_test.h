#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"

namespace slicefarm {

/// Region as square pixels, by plain arithmetic without boolean operations and offsets. All rasters
/// of an operation have the same frame. Lengths are in nm. A pixel is in the region if its middle
/// is.
struct RasterFrame {
  Point origin;
  Coord pixel_nm = 100'000;
  int32_t columns = 0;
  int32_t rows = 0;

  friend bool operator==(const RasterFrame&, const RasterFrame&) = default;
};

inline RasterFrame FrameAround(const Box& box, Coord margin_nm, Coord pixel_nm) {
  const auto pixels = [&](Coord from, Coord to) {
    return static_cast<int32_t>((to - from + 2 * margin_nm) / pixel_nm + 1);
  };
  return {{box.min.x - margin_nm, box.min.y - margin_nm},
          pixel_nm,
          pixels(box.min.x, box.max.x),
          pixels(box.min.y, box.max.y)};
}

class Raster {
 public:
  explicit Raster(const RasterFrame& frame)
      : frame_(frame), bits_(static_cast<size_t>(frame.columns) * frame.rows, 0) {}

  /// Adds a region: the pixels between the crossings of each row's middle with its edges.
  void Fill(const MultiPolygon& region) {
    std::vector<std::vector<double>> crossings(static_cast<size_t>(frame_.rows));
    ForEachRing(region, [&](const Polygon& ring) {
      for (size_t i = 0; i < ring.size(); ++i)
        AddCrossings(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], crossings);
    });
    for (int32_t row = 0; row < frame_.rows; ++row) {
      std::vector<double>& xs = crossings[static_cast<size_t>(row)];
      std::sort(xs.begin(), xs.end());
      for (size_t k = 0; k + 1 < xs.size(); k += 2)
        for (auto x = std::max(0, Up(xs[k])); x < std::min(frame_.columns, Up(xs[k + 1])); ++x)
          At(x, row) = 1;
    }
  }

  /// Adds the pixels within `reach_nm` of a line.
  void Stroke(Point a, Point b, double reach_nm) {
    const int32_t x0 = Column(std::min(a.x, b.x) - reach_nm),
                  x1 = Column(std::max(a.x, b.x) + reach_nm);
    const int32_t y0 = Row(std::min(a.y, b.y) - reach_nm), y1 = Row(std::max(a.y, b.y) + reach_nm);
    for (int32_t y = y0; y <= y1; ++y)
      for (int32_t x = x0; x <= x1; ++x)
        if (DistanceToSegment(Middle(x, y), a, b) <= reach_nm) At(x, y) = 1;
  }

  bool Holds(Point p) const { return Get(Column(p.x), Row(p.y)); }
  bool Empty() const { return std::find(bits_.begin(), bits_.end(), 1) == bits_.end(); }
  double AreaMm2() const {
    const double side = ToMm(static_cast<double>(frame_.pixel_nm));
    return static_cast<double>(std::count(bits_.begin(), bits_.end(), 1)) * side * side;
  }

  Raster& operator|=(const Raster& other) {
    return Each(other, [](auto a, auto b) { return a | b; });
  }
  Raster& operator&=(const Raster& other) {
    return Each(other, [](auto a, auto b) { return a & b; });
  }
  Raster& operator-=(const Raster& other) {
    return Each(other, [](auto a, auto b) { return a & ~b & 1; });
  }

  /// Returns the pixels within `reach_nm` of the region. With a negative reach it returns the
  /// pixels deeper than this inside the region. Cost: O(pixels * reach / pixel).
  Raster Grown(double reach_nm) const {
    if (reach_nm < 0) return Inverse().Grown(-reach_nm).Inverse();
    const double reach = reach_nm / static_cast<double>(frame_.pixel_nm);
    const auto far = static_cast<int32_t>(reach) + 1;
    const std::vector<int32_t> away = ColumnDistances(far);
    Raster grown(frame_);
    for (int32_t y = 0; y < frame_.rows; ++y)
      for (int32_t x = 0; x < frame_.columns; ++x)
        for (int32_t i = std::max(0, x - far); i <= std::min(frame_.columns - 1, x + far); ++i) {
          const double dx = i - x, dy = away[static_cast<size_t>(y) * frame_.columns + i];
          if (dx * dx + dy * dy > reach * reach) continue;
          grown.At(x, y) = 1;
          break;
        }
    return grown;
  }

 private:
  int32_t Up(double column) const { return static_cast<int32_t>(std::ceil(column - 0.5)); }
  int32_t Place(double at, int32_t count) const {
    const double pixel = std::floor(at / static_cast<double>(frame_.pixel_nm));
    return static_cast<int32_t>(std::clamp(pixel, 0.0, count - 1.0));
  }
  int32_t Column(double x) const {
    return Place(x - static_cast<double>(frame_.origin.x), frame_.columns);
  }
  int32_t Row(double y) const {
    return Place(y - static_cast<double>(frame_.origin.y), frame_.rows);
  }
  Point Middle(int32_t x, int32_t y) const {
    return {frame_.origin.x + x * frame_.pixel_nm + frame_.pixel_nm / 2,
            frame_.origin.y + y * frame_.pixel_nm + frame_.pixel_nm / 2};
  }
  uint8_t& At(int32_t x, int32_t y) { return bits_[static_cast<size_t>(y) * frame_.columns + x]; }
  bool Get(int32_t x, int32_t y) const {
    return bits_[static_cast<size_t>(y) * frame_.columns + x] != 0;
  }

  void AddCrossings(Point a, Point b, std::vector<std::vector<double>>& crossings) const {
    const auto pixel = static_cast<double>(frame_.pixel_nm);
    const double ax = static_cast<double>(a.x - frame_.origin.x) / pixel,
                 ay = static_cast<double>(a.y - frame_.origin.y) / pixel,
                 bx = static_cast<double>(b.x - frame_.origin.x) / pixel,
                 by = static_cast<double>(b.y - frame_.origin.y) / pixel;
    const double low = std::min(ay, by), high = std::max(ay, by);
    for (int32_t row = std::max(0, Up(low)); row < frame_.rows && row + 0.5 < high; ++row)
      crossings[static_cast<size_t>(row)].push_back(ax + (row + 0.5 - ay) / (by - ay) * (bx - ax));
  }

  /// Returns the distances to the nearest pixel of the region in the same column, at most `far`.
  std::vector<int32_t> ColumnDistances(int32_t far) const {
    std::vector<int32_t> away(bits_.size(), far);
    const auto width = static_cast<size_t>(frame_.columns);
    for (size_t i = 0; i < bits_.size(); ++i)
      away[i] = bits_[i] ? 0 : i < width ? far : std::min(far, away[i - width] + 1);
    for (size_t i = bits_.size(); i-- > width;)
      away[i - width] = std::min(away[i - width], away[i] + 1);
    return away;
  }

  Raster Inverse() const {
    Raster inverse(frame_);
    for (size_t i = 0; i < bits_.size(); ++i) inverse.bits_[i] = bits_[i] ? 0 : 1;
    return inverse;
  }

  template <typename F>
  Raster& Each(const Raster& other, F f) {
    for (size_t i = 0; i < bits_.size(); ++i)
      bits_[i] = static_cast<uint8_t>(f(bits_[i], other.bits_[i]));
    return *this;
  }

  RasterFrame frame_;
  std::vector<uint8_t> bits_;
};

}  // namespace slicefarm
