#include "common/wire/options/value_checks.h"

#include "common/base/error.h"

namespace slicefarm {

absl::Status CheckRows(size_t rows, std::string_view table) {
  if (rows < 1) return Malformed(table, "are missing");
  const auto count = static_cast<int64_t>(rows);
  if (count <= limits::kMaxRegionSettings) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "rows of settings", limits::kMaxRegionSettings,
                    count);
}

}  // namespace slicefarm
