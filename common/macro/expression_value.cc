#include "common/macro/expression_value.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <utility>
#include <vector>

#include "absl/strings/cord.h"
#include "common/macro/template_arithmetic.h"
#include "common/model/limits.h"

namespace slicefarm::macro {
namespace {

/// Maximum total size of intermediate texts and lists of a template.
constexpr int64_t kMaxSpentBytes = 64 * limits::kMaxExpandedBytes;

/// Variables in which custom G-code can report the state of the printer to the slicer.
constexpr std::array<std::string_view, 4> kOutputs = {"position", "e_position", "e_retracted",
                                                      "e_restart_extra"};

absl::Status UnknownName(std::string_view name) {
  absl::Status status =
      absl::InvalidArgumentError("unknown variable \"" + std::string(name) + "\"");
  status.SetPayload(kVariableUrl, absl::Cord(std::string(name)));
  return status;
}

absl::Status NoValue(std::string_view name) {
  absl::Status status =
      absl::InvalidArgumentError("variable \"" + std::string(name) + "\" has no value (nil)");
  status.SetPayload(kVariableUrl, absl::Cord(std::string(name)));
  return status;
}

int64_t BytesOf(const TemplateValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return static_cast<int64_t>(sizeof(TemplateValue) + (text == nullptr ? 0 : text->size()));
}

std::string WrittenItem(const TemplateVariable& variable, int64_t index) {
  const int64_t inside = 0 <= index && index < std::ssize(variable.items) ? index : 0;
  if (inside < std::ssize(variable.written)) return variable.written[static_cast<size_t>(inside)];
  const TemplateValue& value = variable.items[static_cast<size_t>(inside)];
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "1" : "0";
  return ToText(value);
}

}  // namespace

const TemplateVariable* ExpressionValue::Find(std::string_view name) const {
  for (const TemplateVariables* names :
       {&locals_, const_cast<const TemplateVariables*>(&memory_.globals), &scope_.now,
        &scope_.job}) {
    if (const auto found = names->find(name); found != names->end()) return &found->second;
  }
  return nullptr;
}

TemplateVariable* ExpressionValue::Writable(const std::string& name) {
  for (TemplateVariables* names : {&locals_, &memory_.globals}) {
    if (const auto found = names->find(name); found != names->end()) return &found->second;
  }
  const bool is_output = std::ranges::find(kOutputs, name) != kOutputs.end();
  const TemplateVariable* const value = is_output ? Find(name) : nullptr;
  return value == nullptr ? nullptr : &(locals_[name] = *value);
}

absl::Status ExpressionValue::NotWritable(const std::string& name) const {
  if (Find(name) == nullptr) return UnknownName(name);
  return absl::InvalidArgumentError("\"" + name + "\" cannot be changed");
}

absl::Status ExpressionValue::Spend(const TemplateValue& copied, int64_t times) {
  const int64_t bytes = BytesOf(copied);
  if (times > kMaxSpentBytes / bytes || (spent_bytes_ += times * bytes) > kMaxSpentBytes)
    return absl::ResourceExhaustedError("texts and lists too long");
  return absl::OkStatus();
}

absl::Status ExpressionValue::Spend(const TemplateVariable& copied) {
  for (const TemplateValue& item : copied.items)
    if (absl::Status ok = Spend(item); !ok.ok()) return ok;
  return absl::OkStatus();
}

absl::StatusOr<TemplateValue> ExpressionValue::Evaluate(const Expression& expression) {
  switch (expression.kind) {
    case Expression::Kind::kLiteral:
      return expression.value;
    case Expression::Kind::kVariable:
      return ValueOf(expression);
    case Expression::Kind::kSign:
      return Signed(expression);
    case Expression::Kind::kNot:
      return Not(expression);
    case Expression::Kind::kChain:
      return Chain(expression);
    case Expression::Kind::kAnd:
    case Expression::Kind::kOr:
      return Logic(expression);
    case Expression::Kind::kChoice:
      return Choice(expression);
    case Expression::Kind::kCall:
      return Call(expression);
    case Expression::Kind::kPattern:
      return Evaluate(expression.parts[0]);
  }
  return absl::InvalidArgumentError("expression expected");
}

absl::StatusOr<std::optional<int64_t>> ExpressionValue::IndexOf(const Expression& expression) {
  const Result index = Evaluate(expression);
  if (!index.ok()) return index.status();
  if (IsUnknown(*index)) return std::optional<int64_t>();
  const auto* whole = std::get_if<int64_t>(&*index);
  if (whole == nullptr) return absl::InvalidArgumentError("an index is a whole number");
  return *whole;
}

absl::StatusOr<TemplateValue> ExpressionValue::ValueOf(const Expression& variable) {
  int64_t index = 0;
  if (!variable.parts.empty()) {
    const auto found = IndexOf(variable.parts[0]);
    if (!found.ok()) return found.status();
    if (!found->has_value())
      return Find(variable.text) == nullptr ? Result(UnknownName(variable.text)) : Unknown{};
    index = **found;
    if (index < 0) return absl::InvalidArgumentError("a negative index");
  }
  const TemplateVariable* const named = Find(variable.text);
  if (named == nullptr) return UnknownName(variable.text);
  const TemplateValue* const value = ItemOf(*named, index);
  if (value == nullptr || std::holds_alternative<Nil>(*value)) return NoValue(variable.text);
  if (absl::Status ok = Spend(*value); !ok.ok()) return ok;
  return *value;
}

absl::StatusOr<std::string> ExpressionValue::Written(const Statement& legacy) {
  const std::string& name = legacy.text;
  const TemplateVariable* named = Find(name);
  int64_t index = 0;
  const size_t underscore = name.rfind('_');
  if (named == nullptr && underscore != std::string::npos) {
    const char* const end = name.data() + name.size();
    const auto parsed = std::from_chars(name.data() + underscore + 1, end, index);
    const bool is_number = parsed.ec == std::errc() && parsed.ptr == end;
    const bool is_open = underscore + 1 == name.size() && !legacy.index.empty();
    if (is_number || is_open) named = Find(std::string_view(name).substr(0, underscore));
  }
  if (named == nullptr) return UnknownName(name);
  if (!legacy.index.empty()) {
    const auto given = IndexOf(legacy.index[0]);
    if (!given.ok()) return given.status();
    if (!given->has_value()) return std::string();
    index = **given;
  }
  const TemplateValue* const value = ItemOf(*named, index);
  if (value == nullptr || std::holds_alternative<Nil>(*value)) return NoValue(name);
  return WrittenItem(*named, index);
}

absl::StatusOr<TemplateValue> ExpressionValue::Signed(const Expression& expression) {
  Result value = Evaluate(expression.parts[0]);
  if (!value.ok() || IsUnknown(*value) || expression.text == "+") return value;
  return Negated(*value);
}

absl::StatusOr<TemplateValue> ExpressionValue::Not(const Expression& expression) {
  const Result value = Evaluate(expression.parts[0]);
  if (!value.ok() || IsUnknown(*value)) return value;
  const auto truth = Truth(*value);
  if (!truth.ok()) return truth.status();
  return TemplateValue(!*truth);
}

absl::StatusOr<TemplateValue> ExpressionValue::Chain(const Expression& expression) {
  Result value = Evaluate(expression.parts[0]);
  for (size_t i = 1; value.ok() && i < expression.parts.size(); ++i) {
    const Result right = Evaluate(expression.parts[i]);
    if (!right.ok()) return right;
    if (IsUnknown(*value) || IsUnknown(*right)) {
      value = TemplateValue(Unknown{});
    } else {
      value = Apply(expression.operators[i - 1], *std::move(value), *right);
    }
  }
  return value;
}

/// Evaluates `and` and `or`. Parts after the decisive part are not evaluated.
absl::StatusOr<TemplateValue> ExpressionValue::Logic(const Expression& expression) {
  const bool decisive = expression.kind == Expression::Kind::kOr;
  bool open = false;
  for (const Expression& part : expression.parts) {
    const Result value = Evaluate(part);
    if (!value.ok()) return value;
    open = open || IsUnknown(*value);
    if (IsUnknown(*value)) continue;
    const auto truth = Truth(*value);
    if (!truth.ok()) return truth.status();
    if (*truth == decisive) return TemplateValue(decisive);
  }
  return open ? TemplateValue(Unknown{}) : TemplateValue(!decisive);
}

absl::StatusOr<TemplateValue> ExpressionValue::Choice(const Expression& expression) {
  const Result condition = Evaluate(expression.parts[0]);
  if (!condition.ok()) return condition;
  if (IsUnknown(*condition)) {
    for (const size_t part : {1, 2})
      if (Result value = Evaluate(expression.parts[part]); !value.ok()) return value;
    return TemplateValue(Unknown{});
  }
  const auto truth = Truth(*condition);
  if (!truth.ok()) return truth.status();
  return Evaluate(expression.parts[*truth ? 1 : 2]);
}

/// Evaluates is_nil, empty and size, which concern a variable instead of its value.
absl::StatusOr<TemplateValue> ExpressionValue::OfVariable(const Expression& expression) {
  const Expression& variable = expression.parts[0];
  const TemplateVariable* const named = Find(variable.text);
  if (named == nullptr) return UnknownName(variable.text);
  if (expression.text == "is_nil") {
    std::optional<int64_t> index = 0;
    if (!variable.parts.empty()) {
      const auto given = IndexOf(variable.parts[0]);
      if (!given.ok()) return given.status();
      index = *given;
    }
    if (!index.has_value()) return TemplateValue(Unknown{});
    const TemplateValue* const value = ItemOf(*named, *index);
    if (value != nullptr && IsUnknown(*value)) return TemplateValue(false);
    return TemplateValue(value == nullptr || std::holds_alternative<Nil>(*value));
  }
  if (!named->is_list || !variable.parts.empty())
    return absl::InvalidArgumentError("\"" + variable.text + "\" is no list");
  if (expression.text == "empty") return TemplateValue(named->items.empty());
  return TemplateValue(static_cast<int64_t>(named->items.size()));
}

absl::StatusOr<TemplateValue> ExpressionValue::Call(const Expression& expression) {
  const std::string& name = expression.text;
  if (name == "is_nil" || name == "empty" || name == "size") return OfVariable(expression);
  std::vector<TemplateValue> arguments;
  const auto patterns = std::make_unique<bool[]>(expression.parts.size());
  bool unknown = false;
  for (const Expression& part : expression.parts) {
    Result argument = Evaluate(part);
    if (!argument.ok()) return argument;
    unknown = unknown || IsUnknown(*argument);
    patterns[arguments.size()] = part.kind == Expression::Kind::kPattern;
    arguments.push_back(*std::move(argument));
  }
  if (unknown) return TemplateValue(Unknown{});
  if (name == "random") return Random(arguments[0], arguments[1], memory_.random);
  return macro::Call(name, arguments, {patterns.get(), arguments.size()});
}

}  // namespace slicefarm::macro
