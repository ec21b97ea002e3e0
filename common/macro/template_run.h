#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "absl/status/statusor.h"
#include "common/macro/template.h"
#include "common/macro/template_value.h"

namespace slicefarm::macro {

/// What outlives a template of a job: its global variables, and where its random numbers are.
struct TemplateMemory {
  TemplateVariables globals;
  std::mt19937 random;  ///< the same for each job, so that its bytes are
};

/// What a template may read: what holds for the whole job, and over it what is so now.
struct TemplateScope {
  const TemplateVariables& job;
  const TemplateVariables& now;
};

/// The text that a template comes to. Of lists an index past their end gives the first item, as a
/// list without an index does. + also joins texts; / of whole numbers is whole; and, or, ?: and
/// {if} leave unread what they do not take.
/// Errors: InvalidArgument SETTING_MALFORMED naming setting, line and, if there is one, the unknown
/// `variable`; with `limit`, if more than limits::kMaxExpandedBytes would come out, or lists and
/// texts on the way come to many times that. Cost: O(template + what it joins and copies).
absl::StatusOr<std::string> RunTemplate(const Template& code, const TemplateScope& scope,
                                        TemplateMemory& memory);

/// The same before the print, with Unknown for what only that tells: whatever hangs on it is read
/// either way. Finds names that do not exist and operands that do not fit.
absl::Status CheckTemplate(const Template& code, const TemplateScope& scope,
                           TemplateMemory& memory);

/// For one template by itself.
absl::StatusOr<std::string> ExpandTemplate(std::string_view setting, std::string_view text,
                                           const TemplateVariables& variables);

}  // namespace slicefarm::macro
