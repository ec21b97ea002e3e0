#pragma once

#include <span>
#include <vector>

#include "absl/status/status.h"

namespace slicefarm {

struct SlicingOptions;
struct BeadingOptions;
struct InfillOptions;
struct OrderingOptions;
struct PlanningOptions;
struct MotionOptions;
struct FdmSettings;
struct ExposureSettings;
struct MillSettings;
struct EngraveSettings;

/// Each CheckOptions checks that the algorithms can work with all values: lengths used as divisors
/// are positive, counts are bounded, and tables of regions have equal lengths. It does not check
/// whether a value is sensible for a user; common/config does this when it reads the setting.
/// Errors: REQUEST_MALFORMED with the name of the member; REQUEST_TOO_LARGE for too many rows of a
/// table. Cost: O(rows of all tables).
absl::Status CheckOptions(const SlicingOptions& options);
absl::Status CheckOptions(const std::vector<BeadingOptions>& table);
absl::Status CheckOptions(const std::vector<InfillOptions>& table);
absl::Status CheckOptions(const OrderingOptions& options);
absl::Status CheckOptions(const PlanningOptions& options);
absl::Status CheckOptions(const MotionOptions& options);
absl::Status CheckOptions(const FdmSettings& settings);
absl::Status CheckOptions(const ExposureSettings& settings);
absl::Status CheckOptions(const MillSettings& settings);
inline absl::Status CheckOptions(const EngraveSettings& /*settings*/) { return absl::OkStatus(); }

}  // namespace slicefarm
