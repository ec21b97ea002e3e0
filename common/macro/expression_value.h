#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/macro/template.h"
#include "common/macro/template_run.h"
#include "common/macro/template_value.h"

namespace slicefarm::macro {

/// Evaluates the expressions of a template. A name is looked up first in the local variables, then
/// in the global variables, then in `scope`.
class ExpressionValue {
 public:
  /// REQUIRES: `scope` and `memory` outlive this object.
  ExpressionValue(const TemplateScope& scope, TemplateMemory& memory)
      : scope_(scope), memory_(memory) {}

  /// Returns the value of an expression. Errors: InvalidArgument, with the variable under
  /// kVariableUrl if the error concerns one; ResourceExhausted.
  absl::StatusOr<TemplateValue> Evaluate(const Expression& expression);

  /// Returns the text of the statement [name], [name_2] or [name[index]].
  absl::StatusOr<std::string> Written(const Statement& legacy);

  /// Returns the value of an expression as a whole number; nullopt if the value is Unknown.
  absl::StatusOr<std::optional<int64_t>> IndexOf(const Expression& expression);

  /// Returns the variable with a name; nullptr if there is none.
  const TemplateVariable* Find(std::string_view name) const;
  /// Returns the variable with a name if templates may change it, otherwise nullptr.
  TemplateVariable* Writable(const std::string& name);
  /// Returns the error for an assignment to a name that is not writable.
  absl::Status NotWritable(const std::string& name) const;

  TemplateVariables& locals() { return locals_; }

  /// Adds the size of a copied value to the template's total. Returns ResourceExhausted if the
  /// total exceeds the limit for one template.
  absl::Status Spend(const TemplateVariable& copied);
  absl::Status Spend(const TemplateValue& copied, int64_t times = 1);

 private:
  using Result = absl::StatusOr<TemplateValue>;

  Result ValueOf(const Expression& variable);
  Result Signed(const Expression& expression);
  Result Not(const Expression& expression);
  Result Chain(const Expression& expression);
  Result Logic(const Expression& expression);
  Result Choice(const Expression& expression);
  Result Call(const Expression& expression);
  Result OfVariable(const Expression& expression);

  const TemplateScope& scope_;
  TemplateMemory& memory_;
  TemplateVariables locals_;
  int64_t spent_bytes_ = 0;
};

}  // namespace slicefarm::macro
