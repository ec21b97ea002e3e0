#pragma once

#include <random>
#include <span>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/macro/template_value.h"

namespace slicefarm::macro {

/// The operators and functions of template expressions, see template.h.
/// Errors: InvalidArgument for operands of the wrong type, division by zero and whole numbers that
/// overflow; ResourceExhausted for texts that join to more than limits::kMaxExpandedBytes.
/// Cost: + appends to `a` where it is, so a sum of texts, moved along, is linear in its length.
absl::StatusOr<TemplateValue> Apply(std::string_view op, TemplateValue a, const TemplateValue& b);
absl::StatusOr<TemplateValue> Negated(const TemplateValue& value);
/// `function` of `arguments`, as many as its parser lets through; of one_of, `patterns` tells which
/// of them are regular expressions.
absl::StatusOr<TemplateValue> Call(std::string_view function,
                                   std::span<const TemplateValue> arguments,
                                   std::span<const bool> patterns = {});
/// From `from` to `to`: whole numbers with both, real ones without `to`.
absl::StatusOr<TemplateValue> Random(const TemplateValue& from, const TemplateValue& to,
                                     std::mt19937& random);

/// The truth of a condition: InvalidArgument if it is neither a truth value nor a number.
absl::StatusOr<bool> Truth(const TemplateValue& value);

}  // namespace slicefarm::macro
