#include "services/slicing/algo/mesh_io/threemf/settings/height_profiles.h"

#include <fmt/core.h>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/model/limits.h"
#include "common/model/options/layer_heights.h"
#include "services/slicing/algo/mesh_io/threemf/package/file_location.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"

namespace slicefarm::slicing::threemf {
namespace {

constexpr std::string_view kObject = "object_id=";
constexpr double kMostObjects = limits::kMaxFileResources;

absl::Status AddProfile(std::string_view line, HeightProfiles& profiles) {
  const size_t bar = line.find('|');
  if (!line.starts_with(kObject) || bar == std::string_view::npos)
    return Malformed("a line is not object_id=NUMBER|heights");
  const auto object = ToNumber(line.substr(kObject.size(), bar - kObject.size()));
  if (!object || !(*object >= 1 && *object <= kMostObjects))
    return Malformed("a line is not object_id=NUMBER|heights");
  const auto heights = ParseLayerHeights(Trim(line.substr(bar + 1)));
  if (!heights.ok())
    return Malformed(fmt::format("layer heights {}", std::string(heights.status().message())));
  if (!heights->empty()) profiles[static_cast<int64_t>(*object)] = PrintLayerHeights(*heights);
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<HeightProfiles> ReadHeightProfiles(std::string_view text, const std::string& part) {
  HeightProfiles profiles;
  int64_t number = 0;
  for (const std::string_view line : Split(text, "\n")) {
    ++number;
    if (Trim(line).empty()) continue;
    if (absl::Status added = AddProfile(Trim(line), profiles); !added.ok())
      return WithLocation({part, number}, added);
  }
  return profiles;
}

}  // namespace slicefarm::slicing::threemf
