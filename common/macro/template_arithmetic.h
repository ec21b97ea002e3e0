#pragma once

#include <random>
#include <span>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/macro/template_value.h"

namespace slicefarm::macro {

/// Applies an operator of template expressions; see template.h. Errors: InvalidArgument for
/// operands of the wrong type, division by zero and integer overflow; ResourceExhausted for joined
/// texts longer than limits::kMaxExpandedBytes. Cost: + appends to `a` in place, so a sum of texts
/// is linear in its length if the texts are moved.
absl::StatusOr<TemplateValue> Apply(std::string_view op, TemplateValue a, const TemplateValue& b);
/// Returns the value with its sign changed.
absl::StatusOr<TemplateValue> Negated(const TemplateValue& value);
/// Applies `function` to `arguments`; the parser has checked their number. `patterns`: for one_of,
/// marks the arguments that are regular expressions.
absl::StatusOr<TemplateValue> Call(std::string_view function,
                                   std::span<const TemplateValue> arguments,
                                   std::span<const bool> patterns = {});
/// Returns a random number: an integer in [from, to], or a real number if `to` is not given.
absl::StatusOr<TemplateValue> Random(const TemplateValue& from, const TemplateValue& to,
                                     std::mt19937& random);

/// Returns the value of a condition. Errors: InvalidArgument if it is neither a boolean nor a
/// number.
absl::StatusOr<bool> Truth(const TemplateValue& value);

}  // namespace slicefarm::macro
