#include "common/model/fields/density_field.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "common/base/portable_math.h"

namespace slicefarm {
namespace {

constexpr double kLeastExponent = -300;  // below that e^x counts as 0

/// Returns e^x for x <= 0.
double ExpOfNegative(double x) {
  if (x < kLeastExponent) return 0;
  const double s = Sinh(-x);
  return 1 / (s + std::sqrt(1 + s * s));
}

double Tanh(double x) {
  const double e = ExpOfNegative(-2 * std::abs(x));
  return std::copysign((1 - e) / (1 + e), x);
}

double Power(double base, double exponent) {
  return base <= 0 ? 0 : ExpOfNegative(std::min(0.0, exponent * Log1p(base - 1)));
}

double InTable(const std::vector<double>& at, const std::vector<double>& values, double where) {
  const auto above = std::upper_bound(at.begin(), at.end(), where) - at.begin();
  if (above == 0) return values.front();
  if (above == std::ssize(at)) return values.back();
  const auto i = static_cast<size_t>(above);
  const double share = (where - at[i - 1]) / (at[i] - at[i - 1]);
  return values[i - 1] + (values[i] - values[i - 1]) * share;
}

bool AllEqual(std::span<const double> values) {
  return std::ranges::all_of(values, [&](double v) { return v == values.front(); });
}

/// Returns true if the grid is constant over x and y at the height: each of the two node sheets
/// next to it has a single value.
bool IsUniformAt(const FieldGrid& grid, double z_mm) {
  const auto sheet = static_cast<size_t>(grid.count[0]) * static_cast<size_t>(grid.count[1]);
  const double at = std::clamp((z_mm - grid.origin_mm[2]) / grid.spacing_mm[2], 0.0,
                               static_cast<double>(grid.count[2] - 1));
  const auto below = static_cast<size_t>(at);
  const size_t above = std::min(below + 1, static_cast<size_t>(grid.count[2]) - 1);
  const std::span values(grid.values);
  return AllEqual(values.subspan(below * sheet, sheet)) &&
         AllEqual(values.subspan(above * sheet, sheet));
}

}  // namespace

double DensityOf(double value, DensityLaw law, double steepness, double threshold) {
  switch (law) {
    case DensityLaw::kLinear:
      return value;
    case DensityLaw::kSimp:
      return Power(value, steepness);
    case DensityLaw::kRamp:
      return value / (1 + steepness * (1 - value));
    case DensityLaw::kHeaviside: {
      const double low = Tanh(steepness * threshold);
      return (low + Tanh(steepness * (value - threshold))) /
             (low + Tanh(steepness * (1 - threshold)));
    }
  }
  return value;
}

double DensityField::At(const PositionMm& position_mm, double to_surface_mm) const {
  double value = 0;
  switch (kind) {
    case Kind::kHeight:
      value = InTable(at_mm, values, position_mm[2]);
      break;
    case Kind::kSurfaceDistance:
      value = InTable(at_mm, values, to_surface_mm);
      break;
    case Kind::kGrid:
      value = grid.At(position_mm);
      break;
  }
  return DensityOf(value, law, steepness, threshold);
}

std::optional<double> DensityField::UniformAt(double z_mm) const {
  if (kind == Kind::kGrid && !IsUniformAt(grid, z_mm)) return std::nullopt;
  if (kind == Kind::kSurfaceDistance && !AllEqual(values)) return std::nullopt;
  return At({0, 0, z_mm}, 0);
}

double DensityField::Greatest() const {
  const std::vector<double>& all = kind == Kind::kGrid ? grid.values : values;
  return DensityOf(*std::ranges::max_element(all), law, steepness, threshold);  // laws rise
}

double DensityField::Least() const {
  const std::vector<double>& all = kind == Kind::kGrid ? grid.values : values;
  return DensityOf(*std::ranges::min_element(all), law, steepness, threshold);
}

double DensityField::ReachMm() const { return kind == Kind::kSurfaceDistance ? at_mm.back() : 0; }

}  // namespace slicefarm
