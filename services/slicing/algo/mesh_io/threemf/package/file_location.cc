#include "services/slicing/algo/mesh_io/threemf/package/file_location.h"

#include <fmt/core.h>

#include <utility>

#include "common/base/error.h"

namespace slicefarm::slicing::threemf {

absl::Status WithLocation(const FileLocation& location, const absl::Status& error) {
  ErrorDetail detail = DetailOf(error);
  detail.metadata["part"] = location.part;
  detail.metadata["line"] = std::to_string(location.line);
  const std::string_view message(error.message().data(), error.message().size());
  return MakeError(error.code(), detail.reason,
                   fmt::format("{} ({}, line {})", message, location.part, location.line),
                   std::move(detail.metadata));
}

}  // namespace slicefarm::slicing::threemf
