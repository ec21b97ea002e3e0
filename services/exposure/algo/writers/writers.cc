#include "services/exposure/algo/writers/writers.h"

#include <fmt/core.h>

#include "common/base/error.h"
#include "services/exposure/algo/writers/cli_writer.h"
#include "services/exposure/algo/writers/dxf_writer.h"
#include "services/exposure/algo/writers/laser_gcode.h"
#include "services/exposure/algo/writers/svg_writer.h"

namespace slicefarm::exposure {
namespace {

struct Writer {
  std::string (*header)(const FileFacts&);
  std::string (*layer)(const ExposedLayer&, const FileFacts&);
  std::string (*footer)(const FileFacts&);
};

Writer WriterOf(OutputFormat format) {
  switch (format) {
    case OutputFormat::kCliAscii:
    case OutputFormat::kCliBinary:
      return {CliHeader, CliLayer, CliFooter};
    case OutputFormat::kGrbl:
    case OutputFormat::kMarlin:
      return {LaserGcodeHeader, LaserGcodeLayer, LaserGcodeFooter};
    case OutputFormat::kSvg:
      return {SvgHeader, SvgLayer, SvgFooter};
    case OutputFormat::kDxf:
      break;
  }
  return {DxfHeader, DxfLayer, DxfFooter};
}

absl::Status OutOfRange(const char* setting, double value, const std::string& limits) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("{} is {}, must be {}", setting, value, limits),
                   {{"setting", setting}});
}

}  // namespace

std::string FileHeader(const FileFacts& facts) {
  return WriterOf(facts.output.format).header(facts);
}
std::string LayerText(const ExposedLayer& layer, const FileFacts& facts) {
  return WriterOf(facts.output.format).layer(layer, facts);
}
std::string FileFooter(const FileFacts& facts) {
  return WriterOf(facts.output.format).footer(facts);
}

absl::Status CheckOutput(const FileFacts& facts) {
  const ExposureOutput& output = facts.output;
  if (!(output.unit_mm >= 1e-6 && output.unit_mm <= 1e3))
    return OutOfRange("unit_mm", output.unit_mm, "1e-6 to 1000");
  if (!(output.full_power_w > 0 && output.full_power_w <= 1e6))
    return OutOfRange("full_power_w", output.full_power_w, "above 0, up to 1e6");
  if (!(output.full_power_s > 0 && output.full_power_s <= 1e6))
    return OutOfRange("full_power_s", output.full_power_s, "above 0, up to 1e6");
  if (output.format == OutputFormat::kDxf && (output.layer < 0 || output.layer >= facts.layers))
    return OutOfRange("layer", output.layer, fmt::format("0 to {}", facts.layers - 1));
  if (output.format != OutputFormat::kGrbl && output.format != OutputFormat::kMarlin)
    return absl::OkStatus();
  for (const ExposureOptions& options : facts.regions)
    for (const ExposureStyle& style : options.styles)
      if (style.power_w > output.full_power_w)
        return OutOfRange("power_w", style.power_w,
                          fmt::format("at most full_power_w, {}", output.full_power_w));
  return absl::OkStatus();
}

}  // namespace slicefarm::exposure
