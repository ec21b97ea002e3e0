#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "services/motion/algo/macro/template_value.h"

namespace slicefarm::motion {

/// The text of a template with its placeholders filled in:
///
///   [key]  [key_0]  [key[0]]     a variable, or an element of one
///   {expression}                 see template_expression.h
///   {if c}..{elsif c}..{else}..{endif}   nested as deep as one likes
///
/// Errors: InvalidArgument SETTING_MALFORMED naming `setting`, the line and, if there is one, the
/// unknown `variable`; with `limit`, if more than limits::kMaxExpandedBytes would come out.
/// Cost: O(result) and that of the expressions.
absl::StatusOr<std::string> ExpandTemplate(std::string_view setting, std::string_view text,
                                           const TemplateVariables& variables);

}  // namespace slicefarm::motion
