#include "common/macro/regex.h"

#include <re2/re2.h>

#include <string>

#include "absl/strings/str_cat.h"

namespace slicefarm::macro {
namespace {

constexpr size_t kLongest = 1'000;
constexpr int64_t kMaxBytes = 1 << 20;  // memory limit of the automaton

RE2::Options Options() {
  RE2::Options options;
  options.set_encoding(RE2::Options::EncodingLatin1);
  options.set_dot_nl(true);
  options.set_log_errors(false);
  options.set_max_mem(kMaxBytes);
  return options;
}

}  // namespace

absl::StatusOr<bool> MatchesPattern(std::string_view text, std::string_view pattern) {
  if (pattern.size() > kLongest) {
    return absl::InvalidArgumentError("regular expression: too long");
  }
  const RE2 expression(std::string("(?m)").append(pattern), Options());
  if (!expression.ok()) {
    return absl::InvalidArgumentError(absl::StrCat("regular expression: ", expression.error()));
  }
  return RE2::FullMatch(re2::StringPiece(text.data(), text.size()), expression);
}

}  // namespace slicefarm::macro
