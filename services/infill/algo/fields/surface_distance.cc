#include "services/infill/algo/fields/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/polygon.h"
#include "services/infill/algo/fields/cell_limit.h"

namespace slicefarm::infill {
namespace {

constexpr float kFar = 1e12F;
constexpr auto kCellNm = static_cast<double>(kNmPerMm) * kDistanceCellMm;

/// Marks the cells with their middles inside, by crossings of the outline with the rows of middles.
void MarkInside(const MultiPolygon& outline, int64_t first_x, int64_t first_y, int64_t width,
                int64_t height, std::vector<float>& cells) {
  std::vector<std::vector<double>> crossings(static_cast<size_t>(height));
  ForEachRing(outline, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (a.y == b.y) continue;
      if (a.y > b.y) std::swap(a, b);
      const auto row_above = [&](Coord y) {
        return static_cast<int64_t>(std::ceil(static_cast<double>(y) / kCellNm - 0.5)) - first_y;
      };
      const double slope = static_cast<double>(b.x - a.x) / static_cast<double>(b.y - a.y);
      const int64_t last = std::min(row_above(b.y), height);
      for (int64_t row = std::max<int64_t>(0, row_above(a.y)); row < last; ++row) {
        const double y = (static_cast<double>(row + first_y) + 0.5) * kCellNm;
        crossings[static_cast<size_t>(row)].push_back(static_cast<double>(a.x) +
                                                      slope * (y - static_cast<double>(a.y)));
      }
    }
  });
  for (int64_t row = 0; row < height; ++row) {
    std::vector<double>& at = crossings[static_cast<size_t>(row)];
    std::ranges::sort(at);
    for (size_t i = 0; i + 1 < at.size(); i += 2) {
      const auto cell = [&](double x) {
        return std::clamp<int64_t>(static_cast<int64_t>(std::ceil(x / kCellNm - 0.5)) - first_x, 0,
                                   width);
      };
      for (int64_t x = cell(at[i]); x < cell(at[i + 1]); ++x)
        cells[static_cast<size_t>(row * width + x)] = kFar;
    }
  }
}

/// Transform of squared distances along one line of cells: the lower envelope of one parabola per
/// cell (Felzenszwalb and Huttenlocher, "Distance transforms of sampled functions", 2012).
class LineTransform {
 public:
  void Run(float* values, int64_t count, int64_t step) {
    const auto size = static_cast<size_t>(count);
    places_.resize(size), bounds_.resize(size + 1), result_.resize(size);
    const auto f = [&](int64_t i) { return static_cast<double>(values[i * step]); };
    const auto meet = [&](int64_t p, int64_t q) {
      return ((f(q) + static_cast<double>(q * q)) - (f(p) + static_cast<double>(p * p))) /
             static_cast<double>(2 * (q - p));
    };
    size_t last = 0;
    places_[0] = 0;
    bounds_[0] = -std::numeric_limits<double>::infinity();
    for (int64_t q = 1; q < count; ++q) {
      double at = meet(places_[last], q);
      while (last > 0 && at <= bounds_[last]) at = meet(places_[--last], q);
      places_[++last] = q;
      bounds_[last] = at;
    }
    size_t k = 0;
    for (int64_t q = 0; q < count; ++q) {
      while (k < last && bounds_[k + 1] < static_cast<double>(q)) ++k;
      const auto away = static_cast<double>(q - places_[k]);
      result_[static_cast<size_t>(q)] = static_cast<float>(f(places_[k]) + away * away);
    }
    for (int64_t q = 0; q < count; ++q) values[q * step] = result_[static_cast<size_t>(q)];
  }

 private:
  std::vector<int64_t> places_;
  std::vector<double> bounds_;
  std::vector<float> result_;
};

}  // namespace

double DistanceMap::At(double x_mm, double y_mm) const {
  // Shares are computed before the window's corner is subtracted, so that they do not depend on it.
  const double x = x_mm / kDistanceCellMm - 0.5, y = y_mm / kDistanceCellMm - 0.5;
  const double left = std::floor(x), low = std::floor(y);
  const double right = x - left, up = y - low;
  const auto column = [&](double at, int64_t step) {
    return std::clamp<int64_t>(static_cast<int64_t>(at) + step - first_x, 0, width - 1);
  };
  const auto row = [&](double at, int64_t step) {
    return std::clamp<int64_t>(static_cast<int64_t>(at) + step - first_y, 0, height - 1);
  };
  const int64_t x0 = column(left, 0), x1 = column(left, 1), y0 = row(low, 0), y1 = row(low, 1);
  const auto value = [&](int64_t ix, int64_t iy) {
    return static_cast<double>(mm[static_cast<size_t>(iy * width + ix)]);
  };
  return (value(x0, y0) * (1 - right) + value(x1, y0) * right) * (1 - up) +
         (value(x0, y1) * (1 - right) + value(x1, y1) * right) * up;
}

SurfaceDistances::SurfaceDistances(std::span<const SlicedLayer> layers, int32_t object,
                                   double reach_mm)
    : reach_mm_(reach_mm) {
  Box box;
  for (const SlicedLayer& layer : layers) {
    for (const ObjectSection& section : layer.sections) {
      if (section.stack.id != object) continue;
      sections_[section.layer] = &section;
      box.Add(Bounds(OutlineOf(section)));
    }
  }
  if (box.min.x > box.max.x) return;
  // Areas farther outside than the reach have no influence.
  const Box all = box.Grown(static_cast<Coord>(reach_mm * kNmPerMm + 2 * kCellNm));
  const auto cell = [](Coord at) {
    return static_cast<int64_t>(std::floor(static_cast<double>(at) / kCellNm));
  };
  first_x_ = cell(all.min.x), first_y_ = cell(all.min.y);
  width_ = cell(all.max.x) - first_x_ + 1, height_ = cell(all.max.y) - first_y_ + 1;
}

const SurfaceDistances::Squares& SurfaceDistances::Within(int32_t own_layer) {
  std::shared_ptr<const Squares>& known = within_[own_layer];
  if (known != nullptr) return *known;
  const MultiPolygon& outline = OutlineOf(*sections_.at(own_layer));
  // In a prism, consecutive layers are equal.
  if (const auto before = within_.find(own_layer - 1);
      before != within_.end() && before->second != nullptr &&
      OutlineOf(*sections_.at(own_layer - 1)) == outline) {
    known = before->second;
    return *known;
  }
  auto squares = std::make_shared<Squares>(static_cast<size_t>(width_ * height_), 0.0F);
  MarkInside(outline, first_x_, first_y_, width_, height_, *squares);
  LineTransform transform;
  for (int64_t y = 0; y < height_; ++y) transform.Run(squares->data() + y * width_, width_, 1);
  for (int64_t x = 0; x < width_; ++x) transform.Run(squares->data() + x, height_, width_);
  known = std::move(squares);
  return *known;
}

absl::StatusOr<DistanceMap> SurfaceDistances::Of(int32_t own_layer) {
  const double cells = static_cast<double>(width_) * static_cast<double>(height_);
  if (absl::Status ok = CheckFieldSize(kMaxFieldCells, cells); !ok.ok()) return ok;
  DistanceMap map{first_x_, first_y_, width_, height_, {}};
  const ObjectSection& own = *sections_.at(own_layer);
  const double z_mm = ToMm(own.z_nm) - ToMm(own.height_nm) / 2;
  std::vector<float> least(static_cast<size_t>(width_ * height_),
                           static_cast<float>(reach_mm_ * reach_mm_));
  // Air begins at the end of the last available layer, if this end is within reach at all.
  const auto air_below = [&](double away_mm) {
    for (float& square : least) square = std::min(square, static_cast<float>(away_mm * away_mm));
  };
  for (const int32_t step : {-1, 1}) {
    for (int32_t layer = step < 0 ? own_layer : own_layer + 1;; layer += step) {
      const auto found = sections_.find(layer);
      const ObjectSection* section = found == sections_.end() ? nullptr : found->second;
      if (section == nullptr) {
        const ObjectSection& last = *sections_.at(layer - step);
        const double end_mm = ToMm(step < 0 ? last.z_nm - last.height_nm : last.z_nm);
        air_below(std::abs(end_mm - z_mm));
        break;
      }
      const double top_mm = ToMm(section->z_nm), bottom_mm = top_mm - ToMm(section->height_nm);
      const double rise_mm = std::max({0.0, bottom_mm - z_mm, z_mm - top_mm});
      if (rise_mm >= reach_mm_) break;
      const Squares& squares = Within(layer);
      for (size_t i = 0; i < least.size(); ++i) {
        // The edge is half a cell from the middle of the nearest cell outside.
        const double cells = std::max(0.0, std::sqrt(static_cast<double>(squares[i])) - 0.5);
        const double flat_mm = cells * kDistanceCellMm;
        least[i] = std::min(least[i], static_cast<float>(flat_mm * flat_mm + rise_mm * rise_mm));
      }
    }
  }
  map.mm.reserve(least.size());
  for (const float square : least) map.mm.push_back(std::sqrt(square));
  // Layers are requested in upward order: layers far below are no longer needed.
  while (!within_.empty()) {
    const ObjectSection& lowest = *sections_.at(within_.begin()->first);
    if (ToMm(lowest.z_nm) >= z_mm - reach_mm_ - 1) break;
    within_.erase(within_.begin());
  }
  return map;
}

}  // namespace slicefarm::infill
