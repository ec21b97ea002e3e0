#pragma once

#include <functional>
#include <span>
#include <vector>

#include "common/model/fields/density_field.h"
#include "services/infill/algo/lines/piece.h"

namespace slicefarm::infill {

/// Returns a grid of `count` x `count` nodes over [0, side]^2 that does not depend on the height.
inline FieldGrid GridOf(int count, double side_mm,
                        const std::function<double(double x, double y)>& value) {
  const double step = side_mm / (count - 1);
  FieldGrid grid{{count, count, 1}, {0, 0, 0}, {step, step, 1}, {}};
  for (int y = 0; y < count; ++y)
    for (int x = 0; x < count; ++x) grid.values.push_back(value(x * step, y * step));
  return grid;
}

inline DensityField GridField(int count, double side_mm,
                              const std::function<double(double x, double y)>& value) {
  return {.kind = DensityField::Kind::kGrid, .grid = GridOf(count, side_mm, value)};
}

/// Returns the length of lines in each square cell of [0, side]^2, in mm, measured in small steps.
inline std::vector<double> LengthByCell(std::span<const Polyline> lines, double side_mm,
                                        double cell_mm) {
  const auto count = static_cast<int>(std::round(side_mm / cell_mm));
  std::vector<double> lengths(static_cast<size_t>(count * count), 0);
  constexpr double kStepMm = 0.02;
  for (const Polyline& line : lines) {
    for (size_t i = 1; i < line.size(); ++i) {
      const double length = ToMm(Distance(line[i - 1], line[i]));
      const int steps = std::max(1, static_cast<int>(length / kStepMm));
      for (int k = 0; k < steps; ++k) {
        const double share = (k + 0.5) / steps;
        const double x = ToMm(line[i - 1].x + share * (line[i].x - line[i - 1].x));
        const double y = ToMm(line[i - 1].y + share * (line[i].y - line[i - 1].y));
        const int column = static_cast<int>(x / cell_mm), row = static_cast<int>(y / cell_mm);
        if (x < 0 || y < 0 || column >= count || row >= count) continue;
        lengths[static_cast<size_t>(row * count + column)] += length / steps;
      }
    }
  }
  return lengths;
}

}  // namespace slicefarm::infill
