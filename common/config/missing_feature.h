#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"

namespace slicefarm::config {

/// A feature that a job asks for and slicefarm lacks, and without which the print is spoilt or the
/// machine in danger. The job is refused unless it allows the feature to be missing.
struct MissingFeature {
  std::string feature;  ///< one of Allowances()
  std::string text;     ///< for people: the warning of a job that allows it
  std::map<std::string, std::string> metadata = {};  ///< facts for the error, such as `objects`

  friend bool operator==(const MissingFeature&, const MissingFeature&) = default;
};

/// A feature that a job may do without when it says so (`--allow`, JobSpec.allow).
struct Allowance {
  std::string_view name;
  std::string_view doc;  ///< consequence of the allowance, for people
};

inline constexpr std::string_view kPaintedFilaments = "painted_filaments";
inline constexpr std::string_view kSeveralTools = "several_tools";
inline constexpr std::string_view kGcodeTemplates = "gcode_templates";
inline constexpr std::string_view kIncompatibleProfiles = "incompatible_profiles";

/// All features that a job may allow to be missing.
std::span<const Allowance> Allowances();

/// Returns REQUEST_MALFORMED for the first name that is none of Allowances(), with the name that
/// comes nearest (metadata `field`: `allow`, `suggestion`).
absl::Status CheckAllowed(std::span<const std::string> allowed);

/// Returns NOT_SUPPORTED for the first feature that is missing and not allowed (metadata
/// `feature`, `allow`, and its own).
absl::Status CheckMissing(std::span<const MissingFeature> missing,
                          std::span<const std::string> allowed);

}  // namespace slicefarm::config
