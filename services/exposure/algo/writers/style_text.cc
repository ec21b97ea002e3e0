#include "services/exposure/algo/writers/style_text.h"

#include <fmt/core.h>

#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {

std::string StyleText(const ExposureOptions& options, size_t kind) {
  const ExposureStyle& style = options.styles[kind];
  std::string text =
      fmt::format("{} {} W {} mm/s", ExposureKindName(static_cast<ExposureKind>(kind)),
                  style.power_w, style.speed_mm_s);
  if (style.focus_mm != 0) text += fmt::format(" focus {} mm", style.focus_mm);
  if (style.frequency_khz != 0) text += fmt::format(" {} kHz", style.frequency_khz);
  if (style.point_distance_nm > 0) {
    text += fmt::format(" points every {} um of {} us and {} us between",
                        static_cast<double>(style.point_distance_nm) / 1000, style.point_time_us,
                        style.point_delay_us);
  }
  return text;
}

}  // namespace slicefarm::exposure
