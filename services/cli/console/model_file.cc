#include "services/cli/console/model_file.h"

#include <string_view>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/base/utf8.h"
#include "common/model/limits.h"
#include "services/cli/console/files.h"

namespace slicefarm::cli {

std::string NameOf(const std::string& path) {
  if (path == "-") return "stdin";
  // Npos + 1 is 0.
  const std::string_view file = std::string_view(path).substr(path.rfind('/') + 1);
  return ReplaceControls(ToUtf8(file, limits::kMaxNameBytes), '?');
}

absl::StatusOr<MeshFile> ReadModelFile(const std::string& path) {
  auto bytes = ReadFile(path, limits::kMaxMeshBytes);
  if (!bytes.ok()) {
    const ErrorDetail detail = DetailOf(bytes.status());
    if (detail.reason != Reason::kRequestTooLarge) return bytes.status();
    return MakeError(bytes.status().code(), Reason::kMeshTooLarge,
                     std::string(bytes.status().message()), detail.metadata);
  }
  return MeshFile{.name = NameOf(path), .bytes = *std::move(bytes)};
}

}  // namespace slicefarm::cli
