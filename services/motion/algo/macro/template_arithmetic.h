#pragma once

#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "services/motion/algo/macro/template_value.h"

namespace slicefarm::motion {

/// The operators and functions of template expressions, see template_expression.h.
/// Errors: InvalidArgument for operands of the wrong type, division by zero and whole numbers that
/// overflow; ResourceExhausted for texts that join to more than limits::kMaxExpandedBytes.
/// Cost: + appends to `a` where it is, so a sum of texts, moved along, is linear in its length.
absl::StatusOr<TemplateValue> Apply(std::string_view op, TemplateValue a, const TemplateValue& b);
absl::StatusOr<TemplateValue> Negated(const TemplateValue& value);
absl::StatusOr<TemplateValue> Call(std::string_view function,
                                   const std::vector<TemplateValue>& arguments);

}  // namespace slicefarm::motion
