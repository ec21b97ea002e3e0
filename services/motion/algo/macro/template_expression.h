#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "services/motion/algo/macro/template_value.h"

namespace slicefarm::motion {

/// What an expression of a template comes to.
///
///   literals    12  0.5  "text"  true  false
///   variables   temperature  temperature[0]  temperature[initial_extruder]
///   operators   ?:  or ||  and &&  == !=  < <= > >= <>  + -  * / %  not ! -  ( )
///   patterns    text =~ /regular expression/  text !~ /.../  (text_pattern.h)
///   functions   min(a,b) max(a,b) int(a) round(a) digits(a, width[, decimals]) zdigits(...)
///
/// An index past a list's end gives its first element. + also joins texts; / of whole numbers is
/// whole. With `evaluate` false, only the form is checked.
/// Errors: InvalidArgument whose message says what is wrong; UnknownVariable() gives the variable,
/// if it is about one; ResourceExhausted for a text longer than limits::kMaxExpandedBytes. The
/// depth of what is read is bounded. Cost: O(length * longest text), as each variable that is named
/// is copied; patterns as text_pattern.h says. Source: PrusaSlicer's documentation, "Macros".
absl::StatusOr<TemplateValue> EvaluateExpression(std::string_view text,
                                                 const TemplateVariables& variables, bool evaluate);

/// The truth of a condition: InvalidArgument if it is neither a truth value nor a number.
absl::StatusOr<bool> Truth(const TemplateValue& value);

/// The name of the variable that an error of EvaluateExpression is about; empty if it is about
/// something else.
std::string UnknownVariable(const absl::Status& status);

}  // namespace slicefarm::motion
