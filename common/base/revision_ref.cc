#include "common/base/revision_ref.h"

#include <fmt/core.h>

#include <charconv>

#include "absl/strings/escaping.h"
#include "common/base/error.h"

namespace slicefarm {
namespace {

/// Bytes of a text that an error shows; a text may be as long as a request.
constexpr size_t kShownBytes = 100;

}  // namespace

absl::StatusOr<RevisionRef> ParseRevisionRef(std::string_view text) {
  const size_t at = text.rfind('@');
  RevisionRef ref{std::string(text.substr(0, at)), 0};
  if (at == std::string_view::npos) return ref;
  const char* end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data() + at + 1, end, ref.revision);
  if (error == std::errc() && read == end && ref.revision > 0) return ref;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("{}: after '@', the number of a revision is needed",
                               absl::CEscape(std::string(text.substr(0, kShownBytes)))));
}

}  // namespace slicefarm
