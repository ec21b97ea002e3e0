#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/options/settings.h"
#include "slicefarm/v1/settings.pb.h"

namespace slicefarm {

/// Options of the stages. A message is complete or refused: REQUEST_MALFORMED names the field that
/// is missing, not finite, of a wrong size, or outside of what any algorithm can work with. Whether
/// a value makes sense to a user was decided before, where the setting was read (common/config).

absl::Status ToProto(const SlicingOptions& options, v1::SlicingOptions* proto);
absl::StatusOr<SlicingOptions> FromProto(const v1::SlicingOptions& proto);

v1::BeadingOptions ToProto(const BeadingOptions& options);
absl::StatusOr<BeadingOptions> FromProto(const v1::BeadingOptions& proto);

absl::Status ToProto(const OrderingOptions& options, v1::OrderingOptions* proto);
absl::StatusOr<OrderingOptions> FromProto(const v1::OrderingOptions& proto);

absl::Status ToProto(const FdmSettings& settings, v1::FdmSettings* proto);
absl::StatusOr<FdmSettings> FromProto(const v1::FdmSettings& proto);

/// The number of rows of a table of regions, or of options by object.
absl::Status CheckRows(int rows, std::string_view field);

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
