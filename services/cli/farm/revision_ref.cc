#include "services/cli/farm/revision_ref.h"

#include <fmt/core.h>

#include "absl/strings/numbers.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {

absl::StatusOr<RevisionRef> ParseRevisionRef(std::string_view text) {
  const size_t at = text.rfind('@');
  RevisionRef ref{std::string(text.substr(0, at)), 0};
  if (at == std::string_view::npos) return ref;
  if (!absl::SimpleAtoi(std::string(text.substr(at + 1)), &ref.revision) || ref.revision < 1)
    return Malformed(fmt::format("{}: after '@', the number of a revision is needed", text));
  return ref;
}

}  // namespace slicefarm::cli
