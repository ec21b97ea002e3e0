#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"

namespace slicefarm::config {

/// Feature that a job requires and that slicefarm does not have. Without the feature the print
/// would be spoiled or the machine endangered. The job is refused unless it allows the feature to
/// be missing.
struct MissingFeature {
  std::string feature;  ///< name of the feature, one of Allowances()
  /// message for people; also the warning if the job allows the feature to be missing
  std::string text;
  std::map<std::string, std::string> metadata = {};  ///< facts for the error, such as `objects`

  friend bool operator==(const MissingFeature&, const MissingFeature&) = default;
};

/// Feature that may be missing if the job allows it (`--allow`, JobSpec.allow).
struct Allowance {
  std::string_view name;
  std::string_view doc;  ///< consequence of the missing feature, as a description for users
};

inline constexpr std::string_view kPaintedFilaments = "painted_filaments";
inline constexpr std::string_view kSeveralTools = "several_tools";
inline constexpr std::string_view kGcodeTemplates = "gcode_templates";
inline constexpr std::string_view kIncompatibleProfiles = "incompatible_profiles";

/// Returns all features that a job may allow to be missing.
std::span<const Allowance> Allowances();

/// Checks that all names are in Allowances(). Errors: REQUEST_MALFORMED for the first unknown name,
/// with the most similar name (metadata `field`: `allow`, `suggestion`).
absl::Status CheckAllowed(std::span<const std::string> allowed);

/// Checks that all missing features are allowed. Errors: NOT_SUPPORTED for the first feature that
/// is not allowed (metadata: `feature`, `allow`, and MissingFeature::metadata).
absl::Status CheckMissing(std::span<const MissingFeature> missing,
                          std::span<const std::string> allowed);

}  // namespace slicefarm::config
