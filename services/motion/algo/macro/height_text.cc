#include "services/motion/algo/macro/height_text.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/gcode/gcode_text.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::motion {
namespace {

/// Tolerance of heights. Heights in files are sums of layer heights, each of which is rounded.
constexpr Coord kSameHeightNm = 100;

absl::StatusOr<std::string> TextOfCode(const HeightCode& code, const macro::JobCode& templates,
                                       int32_t tool, const macro::TemplateScope& variables,
                                       macro::TemplateMemory& memory) {
  const auto filled = [&](std::string head,
                          const macro::Template& part) -> absl::StatusOr<std::string> {
    auto text = macro::RunTemplate(part, variables, memory);
    if (!text.ok()) return text.status();
    return absl::StrCat(head, *text, "\n");
  };
  switch (code.kind) {
    case HeightCodeKind::kColorChange:
      return filled(absl::StrCat(";COLOR_CHANGE,T", tool, ",", code.text, "\n"),
                    templates.color_change);
    case HeightCodeKind::kPause: {
      const std::string shown = code.text.empty() ? "" : absl::StrCat("M117 ", code.text, "\n");
      return filled(absl::StrCat(";PAUSE_PRINT\n", shown), templates.pause);
    }
    case HeightCodeKind::kTemplate:
      return filled(";CUSTOM_GCODE\n", templates.at_height);
    case HeightCodeKind::kCustom:
      return absl::StrCat(";CUSTOM_GCODE\n", code.text, "\n");
    case HeightCodeKind::kRetractLength:
      return absl::StrCat("; retract_length = ", code.text, "\n");
  }
  return std::string();
}

}  // namespace

absl::StatusOr<HeightTexts> HeightTexts::Of(const MotionOptions& options) {
  HeightTexts texts;
  auto codes = ParseHeightCodes(options.writing.height_code);
  if (!codes.ok())
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
        absl::StrCat("custom_gcode_per_print_z: ", std::string(codes.status().message())),
        {{"setting", "custom_gcode_per_print_z"}});
  texts.codes_ = *std::move(codes);
  for (const HeightCode& code : texts.codes_)
    if (code.kind == HeightCodeKind::kRetractLength)
      texts.lengths_.emplace_back(code.print_z_nm, slicefarm::RetractLengthMm(code).value_or(0));
  texts.tool_ = std::max(options.tool().number, 0);
  return texts;
}

std::span<const HeightCode> HeightTexts::CodesIn(const LayerFrame& layer) const {
  const Coord top_nm = layer.print_z_nm + kSameHeightNm;
  const Coord bottom_nm = top_nm - layer.height_nm;
  const auto first = std::ranges::upper_bound(codes_, bottom_nm, {}, &HeightCode::print_z_nm);
  const auto last = std::ranges::upper_bound(codes_, top_nm, {}, &HeightCode::print_z_nm);
  return {first, std::max(first, last)};
}

bool HeightTexts::PrimesAt(const LayerFrame& layer) const {
  return std::ranges::any_of(CodesIn(layer), [](const HeightCode& code) {
    return code.kind == HeightCodeKind::kColorChange;
  });
}

double HeightTexts::RetractLengthMm(Coord z_nm, double usual_mm) const {
  const auto next = std::ranges::upper_bound(lengths_, z_nm + kSameHeightNm, {},
                                             &std::pair<Coord, double>::first);
  return next == lengths_.begin() ? usual_mm : std::prev(next)->second;
}

absl::StatusOr<std::string> HeightTexts::At(const LayerFrame& layer, const macro::JobCode& code,
                                            const macro::TemplateScope& variables,
                                            macro::TemplateMemory& memory) const {
  std::string gcode;
  for (const HeightCode& at : CodesIn(layer)) {
    const auto text = TextOfCode(at, code, tool_, variables, memory);
    if (!text.ok()) return text.status();
    gcode += *text;
  }
  return gcode;
}

absl::StatusOr<std::string> CodeAfterChange(const LayerFrame& layer, const macro::JobCode& code,
                                            const HeightTexts& heights,
                                            const macro::TemplateScope& variables,
                                            macro::TemplateMemory& memory) {
  auto after = macro::RunTemplate(code.layer, variables, memory);
  if (!after.ok()) return after.status();
  const auto at_height = heights.At(layer, code, variables, memory);
  if (!at_height.ok()) return at_height.status();
  if (at_height->empty()) return after;
  GcodeText text;
  text.Lines(*after).Lines(*at_height);
  return text.Take();
}

}  // namespace slicefarm::motion
