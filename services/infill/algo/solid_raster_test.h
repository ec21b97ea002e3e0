#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"
#include "common/model/bead_section.h"
#include "common/model/layers/layer.h"
#include "common/model/path.h"
#include "services/infill/algo/quality/fill_plastic.h"

namespace slicefarm::infill {

/// Cover of a region by beads, as shares of its area, counted on pixels. It shares no code with the
/// functions that make the beads.
struct RasterCover {
  double empty = 0;    ///< share that no bead's outer width covers
  double twice = 0;    ///< plastic minus the area of the union of the beads' strips
  double outside = 0;  ///< area covered outside of the region by more than `margin_nm`
  double plastic = 0;  ///< plastic of the beads, relative to a full region
};

class CoverRaster {
 public:
  CoverRaster(const MultiPolygon& region, Coord pixel_nm, Coord margin_nm)
      : pixel_(static_cast<double>(pixel_nm)), margin_(static_cast<double>(margin_nm)) {
    const Box box = Bounds(region);
    const Coord frame = 1'000'000;
    x0_ = static_cast<double>(box.min.x - frame), y0_ = static_cast<double>(box.min.y - frame);
    columns_ = static_cast<int>(static_cast<double>(box.max.x + frame) - x0_) / pixel_nm;
    rows_ = static_cast<int>(static_cast<double>(box.max.y + frame) - y0_) / pixel_nm;
    cells_.assign(static_cast<size_t>(columns_) * rows_, 0);
    for (int row = 0; row < rows_; ++row) MarkRegion(region, row);
  }

  RasterCover Of(const std::vector<Path>& paths, Coord height_nm, double area_nm2) {
    double plastic_mm3 = 0;
    for (const Path& path : paths) {
      plastic_mm3 += PlasticMm3(path, height_nm);
      const size_t edges = path.points.size() - (path.closed ? 0 : 1);
      for (size_t i = 0; i < edges; ++i) {
        const size_t j = (i + 1) % path.points.size();
        const Coord width = (path.WidthAt(i) + path.WidthAt(j)) / 2;
        const double strip = SectionMm2(width, height_nm) * 1e12 / static_cast<double>(height_nm);
        Mark(path.points[i], path.points[j], static_cast<double>(width) / 2, kCovered);
        Mark(path.points[i], path.points[j], strip / 2, kStrip);
        Mark(path.points[i], path.points[j], static_cast<double>(width) / 2 - margin_, kFar);
      }
    }
    return Count(plastic_mm3 * 1e18 / static_cast<double>(height_nm), area_nm2);
  }

 private:
  enum Bit : uint8_t { kRegion = 1, kCovered = 2, kStrip = 4, kFar = 8 };

  double X(int column) const { return x0_ + (column + 0.5) * pixel_; }
  double Y(int row) const { return y0_ + (row + 0.5) * pixel_; }
  uint8_t& Cell(int row, int column) {
    return cells_[static_cast<size_t>(row) * columns_ + column];
  }

  void MarkRegion(const MultiPolygon& region, int row) {
    std::vector<double> crossings;
    ForEachRing(region, [&](const Polygon& ring) {
      for (size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()];
        const auto ay = static_cast<double>(a.y), by = static_cast<double>(b.y);
        if ((ay <= Y(row)) == (by <= Y(row))) continue;
        crossings.push_back(static_cast<double>(a.x) +
                            (Y(row) - ay) / (by - ay) * static_cast<double>(b.x - a.x));
      }
    });
    std::ranges::sort(crossings);
    for (size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const auto column = [&](double x) {
        return static_cast<int>(std::ceil((x - x0_) / pixel_ - 0.5));
      };
      for (int c = column(crossings[i]); c < column(crossings[i + 1]); ++c) Cell(row, c) |= kRegion;
    }
  }

  void Mark(Point a, Point b, double radius, Bit bit) {
    const auto column = [&](double x) { return static_cast<int>(std::floor((x - x0_) / pixel_)); };
    const auto row = [&](double y) { return static_cast<int>(std::floor((y - y0_) / pixel_)); };
    const auto [x0, x1] = std::minmax(a.x, b.x);
    const auto [y0, y1] = std::minmax(a.y, b.y);
    const int left = std::max(0, column(static_cast<double>(x0) - radius));
    const int right = std::min(columns_ - 1, column(static_cast<double>(x1) + radius));
    const int bottom = std::max(0, row(static_cast<double>(y0) - radius));
    const int top = std::min(rows_ - 1, row(static_cast<double>(y1) + radius));
    for (int r = bottom; r <= top; ++r)
      for (int c = left; c <= right; ++c)
        if ((Cell(r, c) & bit) == 0 &&
            DistanceToSegment({std::llround(X(c)), std::llround(Y(r))}, a, b) <= radius)
          Cell(r, c) |= bit;
  }

  RasterCover Count(double plastic_nm2, double area_nm2) const {
    double empty = 0, strips = 0, outside = 0;
    for (const uint8_t cell : cells_) {
      empty += (cell & (kRegion | kCovered)) == kRegion;
      strips += (cell & kStrip) != 0;
      outside += (cell & (kRegion | kFar)) == kFar;
    }
    const double pixel_area = pixel_ * pixel_;
    return {empty * pixel_area / area_nm2, (plastic_nm2 - strips * pixel_area) / area_nm2,
            outside * pixel_area / area_nm2, plastic_nm2 / area_nm2};
  }

  double pixel_, margin_, x0_ = 0, y0_ = 0;
  int columns_ = 0, rows_ = 0;
  std::vector<uint8_t> cells_;
};

/// Returns the cover of a region by a group of paths.
inline RasterCover CoverOf(const std::vector<Path>& paths, const MultiPolygon& region,
                           Coord height_nm, Coord pixel_nm = 20'000, Coord margin_nm = 180'000) {
  CoverRaster raster(region, pixel_nm, margin_nm);
  return raster.Of(paths, height_nm, Area(region));
}

/// Evenness of the flow along paths, and the narrowest bead. Links between solid lines, which are
/// thinner than half a line, are not part of the flow along a line.
struct Flow {
  /// Number of changes by more than 30 % between beads; beads shorter than 20 um are skipped.
  int jumps = 0;
  double length_m = 0;
  Coord narrowest_nm = 0;
};

inline Flow FlowOf(const std::vector<Path>& paths, Coord height_nm) {
  constexpr double kLeastNm = 20'000, kJump = 1.3, kLinkMm2 = 0.03;
  Flow flow{.narrowest_nm = 1'000'000'000};
  for (const Path& path : paths) {
    double last = 0;
    for (size_t i = 1; i < path.points.size(); ++i) {
      const Coord width = (path.WidthAt(i - 1) + path.WidthAt(i)) / 2;
      const double length = Distance(path.points[i - 1], path.points[i]);
      flow.length_m += length / 1e9;
      if (length < kLeastNm) continue;
      const double section = SectionMm2(width, height_nm);
      if (section < kLinkMm2) {
        last = 0;
        continue;
      }
      flow.narrowest_nm = std::min(flow.narrowest_nm, width);
      if (last > 0 && std::max(last, section) > kJump * std::min(last, section)) ++flow.jumps;
      last = section;
    }
  }
  return flow;
}

}  // namespace slicefarm::infill
