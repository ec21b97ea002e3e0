#pragma once

#include <array>
#include <limits>
#include <string_view>

#include "absl/status/statusor.h"

namespace slicefarm {

/// Largest flow of a filament as a function of the bead, as Bambu Studio fits it to measurements.
class FlowFit {
 public:
  /// Parses six numbers, separated by spaces: the coefficients of h^2, w^2, h w, h, w and 1. An
  /// empty text and six zeros give no limit. Errors: InvalidArgument for any other text.
  static absl::StatusOr<FlowFit> Parse(std::string_view text);

  /// Returns the largest flow in mm^3/s of a bead with height h and width w in mm. Returns infinity
  /// where there is no limit, or where the fit is 0 or less, which is outside of its measurements.
  double At(double h_mm, double w_mm) const;

 private:
  std::array<double, 6> factors_ = {};
};

}  // namespace slicefarm
