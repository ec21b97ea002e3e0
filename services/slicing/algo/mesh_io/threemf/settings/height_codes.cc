#include "services/slicing/algo/mesh_io/threemf/settings/height_codes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/text_lines.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"

namespace slicefarm::slicing::threemf {
namespace {

/// Numbers of the code types, equal in both families of slicers.
enum CodeType { kColorChange = 0, kPausePrint = 1, kToolChange = 2, kTemplate = 3, kCustom = 4 };

/// Returns the type of a code that has only G-code text, as in files of PrusaSlicer 2.2.
int TypeBefore23(std::string_view gcode) {
  if (gcode == "M600") return kColorChange;
  if (gcode == "M601") return kPausePrint;
  return gcode == "tool_change" ? kToolChange : kCustom;
}

std::string OneLineOf(std::string_view text) {
  return std::string(Trim(ReplaceControls(text, ' ')));
}

/// Returns lines of G-code with all control characters except line ends and tabs replaced by
/// spaces.
std::string LinesOf(std::string_view text) {
  std::string lines(text);
  for (char& c : lines)
    if (IsControl(c) && c != '\n' && c != '\r' && c != '\t') c = ' ';
  return lines;
}

/// Name of PrusaSlicer's element for all codes of a bed.
constexpr std::string_view kOfBed = "custom_gcodes_per_print_z";

/// Adds a root element if needed. With several beds PrusaSlicer writes several roots, which is no
/// valid XML.
std::string WithOneRoot(std::string_view text) {
  const std::string element = fmt::format("<{}", kOfBed);
  const size_t first = text.find(element);
  if (first == std::string_view::npos || text.find(element, first + 1) == std::string_view::npos)
    return std::string(text);
  return fmt::format("{}<beds>{}</beds>", text.substr(0, first), text.substr(first));
}

/// Handler of <code print_z type color extra>, or <layer top_z ...> in a <plate> with <plate_info
/// id>.
class HeightCodesHandler : public XmlHandler {
 public:
  absl::Status Start(std::string_view name, XmlAttributes attributes, int64_t) override {
    if (name == "plate") plate_ = ++plates_;
    if (name == "plate_info") TakePlate(Find(attributes, "id"), 1);
    if (name == kOfBed) TakePlate(Find(attributes, "bed_idx"), 0);
    if (name == "code") return Add(attributes, "print_z");
    return name == "layer" ? Add(attributes, "top_z") : absl::OkStatus();
  }

  absl::Status End(std::string_view) override { return absl::OkStatus(); }

  PlateHeightCodes Take() && { return std::move(codes_); }

 private:
  void TakePlate(std::optional<std::string_view> number, int64_t first) {
    const auto plate = ParseNumber(number.value_or(""));
    if (plate && *plate >= static_cast<double>(first) && *plate < limits::kMaxProjectPlates)
      plate_ = static_cast<int64_t>(*plate) - first + 1;
  }

  absl::Status Add(XmlAttributes attributes, std::string_view height) {
    const std::optional<double> z = ParseNumber(Find(attributes, height).value_or(""));
    const double most_mm = ToMm(static_cast<double>(limits::kMaxPrintHeight));
    if (!z || !(*z > 0 && *z <= most_mm)) return Malformed("a height is not a number above 0");
    const std::string_view gcode = Find(attributes, "gcode").value_or("");
    std::optional<double> type = ParseNumber(Find(attributes, "type").value_or(""));
    if (!Find(attributes, "type")) type = TypeBefore23(gcode);
    if (!type) return Malformed("a type is not a number");
    if (++count_ > kMaxHeightCodes)
      return LimitError(Reason::kMeshTooLarge, "codes at heights", kMaxHeightCodes, count_);
    const std::string_view extra = Find(attributes, "extra").value_or("");
    const std::string_view color = Find(attributes, "color").value_or("");
    std::vector<HeightCode>& codes = codes_[plate_];
    switch (static_cast<int>(std::lround(std::clamp(*type, -1.0, 100.0)))) {
      case kColorChange:
        codes.push_back({FromMm(*z), HeightCodeKind::kColorChange, OneLineOf(color)});
        return absl::OkStatus();
      case kPausePrint:
        codes.push_back({FromMm(*z), HeightCodeKind::kPause, OneLineOf(extra)});
        return absl::OkStatus();
      case kTemplate:
        codes.push_back({FromMm(*z), HeightCodeKind::kTemplate, {}});
        return absl::OkStatus();
      case kCustom:
        codes.push_back(
            {FromMm(*z), HeightCodeKind::kCustom, LinesOf(extra.empty() ? gcode : extra)});
        return absl::OkStatus();
      default:
        return absl::OkStatus();
    }
  }

  PlateHeightCodes codes_;
  int64_t plates_ = 0;
  int64_t plate_ = 1;
  int64_t count_ = 0;
};

}  // namespace

absl::StatusOr<PlateHeightCodes> ReadHeightCodes(std::string_view text, const std::string& part) {
  HeightCodesHandler handler;
  absl::Status status = ParseXml(WithOneRoot(text), part, handler);
  if (!status.ok()) return status;
  return std::move(handler).Take();
}

}  // namespace slicefarm::slicing::threemf
