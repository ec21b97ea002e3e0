#include "common/config/missing_feature.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "common/base/error.h"
#include "common/config/table/suggest.h"

namespace slicefarm::config {
namespace {

constexpr Allowance kAllowances[] = {
    {kPaintedFilaments, "print objects that are painted with several filaments with one filament"},
    {kSeveralTools,
     "print objects or parts that are assigned to several extruders with the first of these "
     "extruders"},
    {kGcodeTemplates,
     "omit custom G-code that cannot be expanded (never start_gcode and end_gcode)"},
    {kIncompatibleProfiles,
     "use profiles although their compatible_printers_condition or compatible_prints_condition is "
     "false"},
    {"colorprint_heights", "omit the colour changes at the heights in colorprint_heights"},
    {"printer_technology", "use a profile of a resin printer (printer_technology = SLA)"},
};

}  // namespace

std::span<const Allowance> Allowances() { return kAllowances; }

absl::Status CheckAllowed(std::span<const std::string> allowed) {
  for (const std::string& name : allowed) {
    if (std::ranges::find(kAllowances, name, &Allowance::name) != std::end(kAllowances)) continue;
    std::vector<std::string_view> names;
    for (const Allowance& each : kAllowances) names.push_back(each.name);
    const std::string nearest = Nearest(name, names);
    std::map<std::string, std::string> metadata = {{"field", "allow"}};
    if (!nearest.empty()) metadata["suggestion"] = nearest;
    std::string list;
    for (const std::string_view each : names)
      list += fmt::format("{}{}", list.empty() ? "" : ", ", each);
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
        fmt::format("allow: there is no feature '{}'{}; the features are: {}", name,
                    nearest.empty() ? "" : fmt::format("; do you mean {}?", nearest), list),
        std::move(metadata));
  }
  return absl::OkStatus();
}

absl::Status CheckMissing(std::span<const MissingFeature> missing,
                          std::span<const std::string> allowed) {
  for (const MissingFeature& each : missing) {
    if (std::ranges::find(allowed, each.feature) != allowed.end()) continue;
    std::map<std::string, std::string> metadata = each.metadata;
    metadata["feature"] = metadata["allow"] = each.feature;
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNotSupported,
                     "not supported: " + each.text, std::move(metadata));
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::config
