#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/wire/fields/fields.h"
#include "common/wire/options/options_check.h"

namespace slicefarm {

/// Returns the options that PackFields wrote, after a check by CheckOptions. Errors: any error of
/// UnpackFields and CheckOptions.
template <typename Options>
absl::StatusOr<Options> OptionsFromBytes(std::string_view bytes) {
  absl::StatusOr<Options> options = UnpackFields<Options>(bytes);
  if (!options.ok()) return options;
  if (absl::Status status = CheckOptions(*options); !status.ok()) return status;
  return options;
}

}  // namespace slicefarm
