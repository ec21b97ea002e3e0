#include "common/wire/support/wire_error.h"

#include <fmt/core.h>

#include <string>

#include "common/base/error.h"

namespace slicefarm {

absl::Status Malformed(std::string_view field, std::string_view what) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("{}: {}", field, what), {{"field", std::string(field)}});
}

absl::Status Within(std::string_view field, const absl::Status& status) {
  ErrorDetail detail = DetailOf(status);
  std::string& path = detail.metadata["field"];
  // A message that does not yet name a field is a complete sentence.
  const std::string_view between = path.empty() ? ": " : ".";
  path = path.empty() ? std::string(field) : fmt::format("{}.{}", field, path);
  return MakeError(status.code(), detail.reason,
                   fmt::format("{}{}{}", field, between, std::string(status.message())),
                   detail.metadata);
}

absl::Status Within(std::string_view field, size_t index, const absl::Status& status) {
  return Within(fmt::format("{}[{}]", field, index), status);
}

}  // namespace slicefarm
