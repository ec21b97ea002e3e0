#include "services/cli/render/line_style.h"

#include <vector>

#include "absl/strings/numbers.h"
#include "common/base/text.h"

namespace slicefarm::cli {
namespace {

double NumberOf(std::string_view word) {
  double value = 0;
  return absl::SimpleAtod(absl::string_view(word.data(), word.size()), &value) ? value : 0;
}

/// Reads a label such as `hatch 200 W 800 mm/s points every 60 um of 40 us`. Numbers are before
/// their units.
LineStyle StyleOf(std::string_view label) {
  LineStyle style;
  std::vector<std::string_view> words;
  for (const std::string_view word : Split(label, " ")) words.push_back(Trim(word));
  for (size_t i = 1; i < words.size(); ++i) {
    if (words[i] == "W" && style.power_w == 0) {
      style.power_w = NumberOf(words[i - 1]);
      style.kind = Trim(label.substr(0, static_cast<size_t>(words[i - 1].data() - label.data())));
    }
    if (words[i] == "mm/s") style.speed_mm_s = NumberOf(words[i - 1]);
    if (words[i - 1] == "every") style.point_distance_um = NumberOf(words[i]);
    if (words[i - 1] == "of") style.point_time_us = NumberOf(words[i]);
  }
  return style;
}

}  // namespace

double LineStyle::EnergyJPerMm() const {
  if (point_distance_um > 0) return power_w * point_time_us * 1e-6 / (point_distance_um * 1e-3);
  return speed_mm_s > 0 ? power_w / speed_mm_s : 0;
}

std::map<int, LineStyle> StylesOf(std::string_view cli_header) {
  constexpr std::string_view kLabel = "$$LABEL/";
  std::map<int, LineStyle> styles;
  for (size_t at = cli_header.find(kLabel); at != std::string_view::npos;
       at = cli_header.find(kLabel, at + 1)) {
    const std::string_view rest = cli_header.substr(at + kLabel.size());
    const std::string_view label = rest.substr(0, rest.find_first_of("\r\n$"));
    const size_t comma = label.find(',');
    if (comma == std::string_view::npos) continue;
    styles[static_cast<int>(NumberOf(label.substr(0, comma)))] = StyleOf(label.substr(comma + 1));
  }
  return styles;
}

}  // namespace slicefarm::cli
