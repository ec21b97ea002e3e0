#include "common/model/options/flow_fit.h"

#include <limits>
#include <vector>

#include "common/base/text.h"

namespace slicefarm {

absl::StatusOr<FlowFit> FlowFit::Parse(std::string_view text) {
  FlowFit fit;
  std::vector<std::string_view> words = Split(text, " \t");
  std::erase(words, std::string_view());
  if (words.empty()) return fit;
  const absl::Status malformed = absl::InvalidArgumentError(
      "must be six numbers, separated by spaces: the factors of h^2, w^2, h w, h, w and 1");
  if (words.size() != fit.factors_.size()) return malformed;
  for (size_t i = 0; i < words.size(); ++i) {
    const auto factor = ToNumber(words[i]);
    if (!factor) return malformed;
    fit.factors_[i] = *factor;
  }
  return fit;
}

double FlowFit::At(double h_mm, double w_mm) const {
  const auto [hh, ww, hw, h, w, one] = factors_;
  const double flow =
      hh * h_mm * h_mm + ww * w_mm * w_mm + hw * h_mm * w_mm + h * h_mm + w * w_mm + one;
  return flow > 0 ? flow : std::numeric_limits<double>::infinity();
}

}  // namespace slicefarm
