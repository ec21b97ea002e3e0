#include "common/macro/template_run.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/macro/expression_value.h"
#include "common/macro/template_arithmetic.h"
#include "common/model/limits.h"

namespace slicefarm::macro {
namespace {

/// Converts a value to the type of a variable's old value. Numbers and texts are converted,
/// booleans are not.
absl::StatusOr<TemplateValue> InTypeOf(const TemplateValue& old, TemplateValue value) {
  if (IsUnknown(old) || IsUnknown(value) || old.index() == value.index()) return value;
  if (std::holds_alternative<std::string>(old)) return TemplateValue(ToText(value));
  const auto* whole = std::get_if<int64_t>(&value);
  const auto* real = std::get_if<double>(&value);
  if (std::holds_alternative<double>(old) && whole != nullptr)
    return TemplateValue(static_cast<double>(*whole));
  if (std::holds_alternative<int64_t>(old) && real != nullptr) return Call("int", {&value, 1});
  return absl::InvalidArgumentError("the value has another type than the variable");
}

/// Converts the items of a list literal to one type: to text if one item is a text, otherwise to
/// real numbers if one item is a real number.
absl::Status MakeAlike(std::vector<TemplateValue>& items) {
  const auto any = [&](size_t type) {
    return std::ranges::any_of(items, [&](const TemplateValue& v) { return v.index() == type; });
  };
  const TemplateValue text = std::string(), real = 0.0, truth = false, whole = int64_t{0};
  if (!any(text.index()) && any(truth.index()) && (any(whole.index()) || any(real.index())))
    return absl::InvalidArgumentError("a list cannot mix numbers and truth values");
  const TemplateValue* const type = any(text.index())                          ? &text
                                    : any(real.index()) && !any(truth.index()) ? &real
                                                                               : nullptr;
  if (type == nullptr) return absl::OkStatus();
  for (TemplateValue& item : items) {
    auto alike = InTypeOf(*type, std::move(item));
    if (!alike.ok()) return alike.status();
    item = *std::move(alike);
  }
  return absl::OkStatus();
}

class Runner {
 public:
  Runner(const Template& code, const TemplateScope& scope, TemplateMemory& memory, bool checks)
      : code_(code), checks_(checks), names_(scope, memory), memory_(memory) {}

  absl::StatusOr<std::string> Run() {
    if (absl::Status status = RunAll(code_.body); !status.ok())
      return TemplateError(code_.setting, line_, status);
    return std::move(result_);
  }

 private:
  absl::Status RunAll(const std::vector<Statement>& body) {
    for (const Statement& statement : body) {
      line_ = statement.line;
      if (absl::Status status = RunOne(statement); !status.ok()) return status;
    }
    return absl::OkStatus();
  }

  absl::Status RunOne(const Statement& statement) {
    switch (statement.kind) {
      case Statement::Kind::kText:
        return Print(statement.text);
      case Statement::Kind::kPrint: {
        const auto value = names_.Evaluate(statement.values[0]);
        return value.ok() ? Print(ToText(*value)) : value.status();
      }
      case Statement::Kind::kLegacy: {
        const auto text = names_.Written(statement);
        return text.ok() ? Print(*text) : text.status();
      }
      case Statement::Kind::kIf:
        return RunIf(statement);
      case Statement::Kind::kAssign:
        return Assign(statement);
      default:
        return Declare(statement);
    }
  }

  /// Appends text to the result. The size is limited, because a template can print a long text any
  /// number of times through a short variable.
  absl::Status Print(std::string_view text) {
    if (result_.size() + text.size() > static_cast<size_t>(limits::kMaxExpandedBytes))
      return absl::ResourceExhaustedError("text too long");
    if (!checks_) result_.append(text);
    return absl::OkStatus();
  }

  absl::Status RunIf(const Statement& statement) {
    for (const Statement& branch : statement.body) {
      line_ = branch.line;
      if (branch.values.empty()) return RunAll(branch.body);
      const auto condition = names_.Evaluate(branch.values[0]);
      if (!condition.ok()) return condition.status();
      if (IsUnknown(*condition)) {
        // The condition is unknown: this branch may run, or one of the branches after it.
        if (absl::Status status = RunMaybe(branch.body); !status.ok()) return status;
        continue;
      }
      const auto truth = Truth(*condition);
      if (!truth.ok()) return truth.status();
      if (*truth) return RunAll(branch.body);
    }
    return absl::OkStatus();
  }

  /// Runs a branch during a check; in the print, the branch may not run. Variables that the branch
  /// changes are Unknown afterwards.
  absl::Status RunMaybe(const std::vector<Statement>& body) {
    const TemplateVariables locals = names_.locals();
    const TemplateVariables globals = memory_.globals;
    if (absl::Status status = RunAll(body); !status.ok()) return status;
    Forget(locals, names_.locals());
    Forget(globals, memory_.globals);
    return absl::OkStatus();
  }

  static void Forget(const TemplateVariables& before, TemplateVariables& after) {
    for (auto& [name, variable] : after) {
      const auto old = before.find(name);
      if (old != before.end() && old->second == variable) continue;
      if (variable.items.empty()) variable.items.push_back(Unknown{});
      for (TemplateValue& item : variable.items) item = Unknown{};
    }
  }

  absl::Status Assign(const Statement& statement) {
    TemplateVariable* const variable = names_.Writable(statement.text);
    if (variable == nullptr) return names_.NotWritable(statement.text);
    if (statement.index.empty()) return Store(statement, *variable);
    const auto index = names_.IndexOf(statement.index[0]);
    if (!index.ok()) return index.status();
    if (statement.right != Statement::Right::kValue || !variable->is_list)
      return absl::InvalidArgumentError("\"" + statement.text + "\" is not a list of lists");
    auto value = names_.Evaluate(statement.values[0]);
    if (!value.ok()) return value.status();
    if (!index->has_value()) return ForgetItems(*variable);
    if (**index < 0 || **index >= std::ssize(variable->items))
      return absl::InvalidArgumentError("index out of range");
    TemplateValue& item = variable->items[static_cast<size_t>(**index)];
    auto alike = InTypeOf(item, *std::move(value));
    if (!alike.ok()) return alike.status();
    item = *std::move(alike);
    return absl::OkStatus();
  }

  static absl::Status ForgetItems(TemplateVariable& variable) {
    for (TemplateValue& item : variable.items) item = Unknown{};
    return absl::OkStatus();
  }

  absl::Status Declare(const Statement& statement) {
    const bool global = statement.kind == Statement::Kind::kGlobal;
    TemplateVariables& names = global ? memory_.globals : names_.locals();
    TemplateVariables& others = global ? names_.locals() : memory_.globals;
    if (others.contains(statement.text))
      return absl::InvalidArgumentError("\"" + statement.text + "\" is " +
                                        (global ? "a local" : "a global") + " variable already");
    if (const auto found = names.find(statement.text); found != names.end())
      return Store(statement, found->second);
    auto made = RightOf(statement);
    if (!made.ok()) return made.status();
    if (made->is_list && made->items.empty() && statement.right == Statement::Right::kList)
      return absl::InvalidArgumentError("an empty list has no type");
    names.emplace(statement.text, *std::move(made));
    return absl::OkStatus();
  }

  /// Stores the right side in an existing variable, in its type.
  absl::Status Store(const Statement& statement, TemplateVariable& variable) {
    auto right = RightOf(statement);
    if (!right.ok()) return right.status();
    const bool one_item = statement.right == Statement::Right::kList && right->items.size() == 1;
    if (right->is_list && !variable.is_list && one_item) right->is_list = false;
    if (right->is_list != variable.is_list)
      return absl::InvalidArgumentError("\"" + statement.text + "\" is " +
                                        (variable.is_list ? "a list" : "no list"));
    if (!variable.items.empty()) {
      for (TemplateValue& item : right->items) {
        auto alike = InTypeOf(variable.items[0], std::move(item));
        if (!alike.ok()) return alike.status();
        item = *std::move(alike);
      }
    }
    variable = *std::move(right);
    return absl::OkStatus();
  }

  absl::StatusOr<TemplateVariable> RightOf(const Statement& statement) {
    if (statement.right == Statement::Right::kList) return ListOf(statement);
    if (statement.right == Statement::Right::kRepeat) return Repeated(statement);
    const Expression& value = statement.values[0];
    if (value.kind == Expression::Kind::kVariable && value.parts.empty()) {
      const TemplateVariable* const variable = names_.Find(value.text);
      const bool copies = variable != nullptr && variable->is_list;
      if (copies) {
        if (absl::Status ok = names_.Spend(*variable); !ok.ok()) return ok;
        return TemplateVariable::List(variable->items);
      }
    }
    auto evaluated = names_.Evaluate(value);
    if (!evaluated.ok()) return evaluated.status();
    return TemplateVariable(*std::move(evaluated));
  }

  absl::StatusOr<TemplateVariable> ListOf(const Statement& statement) {
    std::vector<TemplateValue> items;
    for (const Expression& value : statement.values) {
      auto item = names_.Evaluate(value);
      if (!item.ok()) return item.status();
      items.push_back(*std::move(item));
    }
    if (absl::Status alike = MakeAlike(items); !alike.ok()) return alike;
    return TemplateVariable::List(std::move(items));
  }

  absl::StatusOr<TemplateVariable> Repeated(const Statement& statement) {
    const auto count = names_.IndexOf(statement.values[0]);
    if (!count.ok()) return count.status();
    auto value = names_.Evaluate(statement.values[1]);
    if (!value.ok()) return value.status();
    if (!count->has_value()) return TemplateVariable::List({Unknown{}});
    if (**count < 0) return absl::InvalidArgumentError("repeat: a negative count");
    if (absl::Status ok = names_.Spend(*value, **count); !ok.ok()) return ok;
    return TemplateVariable::List(
        std::vector<TemplateValue>(static_cast<size_t>(**count), *std::move(value)));
  }

  const Template& code_;
  const bool checks_;
  ExpressionValue names_;
  TemplateMemory& memory_;
  int32_t line_ = 1;
  std::string result_;
};

}  // namespace

absl::StatusOr<std::string> RunTemplate(const Template& code, const TemplateScope& scope,
                                        TemplateMemory& memory) {
  return Runner(code, scope, memory, false).Run();
}

absl::Status CheckTemplate(const Template& code, const TemplateScope& scope,
                           TemplateMemory& memory) {
  return Runner(code, scope, memory, true).Run().status();
}

absl::StatusOr<std::string> ExpandTemplate(std::string_view setting, std::string_view text,
                                           const TemplateVariables& variables) {
  const auto code = ParseTemplate(setting, text);
  if (!code.ok()) return code.status();
  TemplateMemory memory;
  const TemplateVariables nothing;
  return RunTemplate(*code, {variables, nothing}, memory);
}

}  // namespace slicefarm::macro
