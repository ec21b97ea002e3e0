#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "absl/status/statusor.h"
#include "common/macro/template.h"
#include "common/macro/template_value.h"

namespace slicefarm::macro {

/// State that the templates of a job share: global variables, and the state of the random
/// generator.
struct TemplateMemory {
  TemplateVariables globals;
  /// random generator; it starts with the same state for each job, so that equal jobs give equal
  /// bytes
  std::mt19937 random;
};

/// Variables that a template can read. `now` has the current values, which override the values in
/// `job`.
struct TemplateScope {
  const TemplateVariables& job;
  const TemplateVariables& now;
};

/// Returns the expanded text of a template. An index beyond the end of a list gives the first item,
/// and so does a list without an index. + also joins texts; / of integers gives an integer.
/// Operands of `and`, `or` and ?: and branches of {if} that are not needed are not evaluated.
///
/// Errors: SETTING_MALFORMED with metadata `setting`, `line` and, for an unknown name, `variable`.
/// REQUEST_TOO_LARGE with `limit` if the result would exceed limits::kMaxExpandedBytes, or if
/// intermediate lists and texts would exceed a multiple of this limit. Cost: O(template + joined
/// and copied values).
absl::StatusOr<std::string> RunTemplate(const Template& code, const TemplateScope& scope,
                                        TemplateMemory& memory);

/// Checks a template before the print. Values that only the print determines are Unknown, and both
/// branches of a condition that depends on them are checked. The check finds unknown names and
/// operands of wrong types.
absl::Status CheckTemplate(const Template& code, const TemplateScope& scope,
                           TemplateMemory& memory);

/// Parses and expands a single template.
absl::StatusOr<std::string> ExpandTemplate(std::string_view setting, std::string_view text,
                                           const TemplateVariables& variables);

}  // namespace slicefarm::macro
