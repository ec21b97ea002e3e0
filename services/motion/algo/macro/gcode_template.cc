#include "services/motion/algo/macro/gcode_template.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <map>
#include <optional>
#include <vector>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/base/text.h"
#include "services/motion/algo/macro/template_expression.h"

namespace slicefarm::motion {
namespace {

/// An {if} that is open.
struct Condition {
  bool outer_active;  ///< what stands around it is printed
  bool active;        ///< the branch being read is
  bool done;          ///< a branch has been chosen
  bool has_else;
};

std::string_view FirstWord(std::string_view text) {
  size_t end = 0;
  while (end < text.size() &&
         (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_')) {
    ++end;
  }
  return text.substr(0, end);
}

bool IsName(std::string_view text) {
  return !text.empty() && FirstWord(text).size() == text.size() &&
         std::isdigit(static_cast<unsigned char>(text[0])) == 0;
}

class Expander {
 public:
  Expander(std::string_view text, const TemplateVariables& variables)
      : text_(text), variables_(variables) {}

  absl::Status Run() {
    while (at_ < text_.size()) {
      const size_t open = std::min(text_.find_first_of("[{", at_), text_.size());
      if (const absl::Status status = Print(text_.substr(at_, open - at_)); !status.ok()) {
        return status;
      }
      at_ = open;
      if (at_ == text_.size()) break;
      const absl::Status status = text_[at_] == '[' ? Bracket() : Brace();
      if (!status.ok()) return status;
    }
    if (!conditions_.empty()) return absl::InvalidArgumentError("{if} without {endif}");
    return absl::OkStatus();
  }

  std::string TakeResult() { return std::move(result_); }
  size_t Line() const {
    return 1 + static_cast<size_t>(
                   std::count(text_.begin(), text_.begin() + static_cast<ptrdiff_t>(at_), '\n'));
  }

 private:
  bool Active() const { return conditions_.empty() || conditions_.back().active; }

  /// A variable of a few characters may stand for a long text, as often as one likes.
  absl::Status Print(std::string_view text) {
    if (!Active()) return absl::OkStatus();
    if (result_.size() + text.size() > static_cast<size_t>(limits::kMaxExpandedBytes)) {
      return absl::ResourceExhaustedError("text too long");
    }
    result_.append(text);
    return absl::OkStatus();
  }

  /// [key], [key_0] or [key[expression]].
  absl::Status Bracket() {
    const auto close = ClosingBracket();
    if (!close) return absl::InvalidArgumentError("\"[\" without \"]\"");
    const std::string_view inside = Trim(text_.substr(at_ + 1, *close - at_ - 1));
    const std::string_view name = FirstWord(inside);
    const std::string_view index = inside.substr(name.size());
    if (!IsName(name) || (!index.empty() && (index.front() != '[' || index.back() != ']'))) {
      return absl::InvalidArgumentError("\"[" + std::string(inside) + "]\" is not a variable");
    }
    auto value = EvaluateExpression(inside, variables_, Active());
    if (!value.ok()) {
      if (const TemplateValue* element = Element(inside)) value = *element;
    }
    if (!value.ok()) return value.status();
    absl::Status status = Print(ToText(*value));
    if (status.ok()) at_ = *close + 1;
    return status;
  }

  /// Position of the bracket that closes the one at at_.
  std::optional<size_t> ClosingBracket() const {
    int depth = 0;
    for (size_t i = at_; i < text_.size() && text_[i] != '\n'; ++i) {
      if (text_[i] == '[') ++depth;
      if (text_[i] == ']' && --depth == 0) return i;
    }
    return {};
  }

  /// temperature_1 is temperature[1].
  const TemplateValue* Element(std::string_view name) const {
    const size_t underscore = name.rfind('_');
    if (underscore == std::string_view::npos) return nullptr;
    int64_t index = 0;
    const char* end = name.data() + name.size();
    const auto parsed = std::from_chars(name.data() + underscore + 1, end, index);
    if (parsed.ec != std::errc() || parsed.ptr != end) return nullptr;
    return FindValue(variables_, name.substr(0, underscore), index);
  }

  absl::Status Brace() {
    const auto close = ClosingBrace();
    if (!close) return absl::InvalidArgumentError("\"{\" without \"}\"");
    const std::string_view inside = Trim(text_.substr(at_ + 1, *close - at_ - 1));
    const std::string_view word = FirstWord(inside);
    const std::string_view rest = inside.substr(word.size());
    absl::Status status;
    if (word == "if") {
      status = If(rest);
    } else if (word == "elsif") {
      status = Elsif(rest);
    } else if (inside == "else") {
      status = Else();
    } else if (inside == "endif") {
      status = Endif();
    } else {
      status = Expression(inside);
    }
    if (status.ok()) at_ = *close + 1;
    return status;
  }

  /// Position of the brace that closes the one at at_; texts may hold braces.
  std::optional<size_t> ClosingBrace() const {
    bool in_text = false;
    for (size_t i = at_ + 1; i < text_.size(); ++i) {
      if (in_text && text_[i] == '\\') {
        ++i;
      } else if (text_[i] == '"') {
        in_text = !in_text;
      } else if (text_[i] == '}' && !in_text) {
        return i;
      }
    }
    return {};
  }

  absl::Status Expression(std::string_view text) {
    const auto value = EvaluateExpression(text, variables_, Active());
    if (!value.ok()) return value.status();
    return Print(ToText(*value));
  }

  absl::Status If(std::string_view condition) {
    const bool outer = Active();
    const auto truth = Holds(condition, outer);
    if (!truth.ok()) return truth.status();
    conditions_.push_back({outer, outer && *truth, *truth, false});
    return absl::OkStatus();
  }

  absl::Status Elsif(std::string_view condition) {
    if (conditions_.empty() || conditions_.back().has_else) {
      return absl::InvalidArgumentError("{elsif} without {if}");
    }
    Condition& open = conditions_.back();
    const bool undecided = open.outer_active && !open.done;
    const auto truth = Holds(condition, undecided);
    if (!truth.ok()) return truth.status();
    open.active = undecided && *truth;
    open.done = open.done || *truth;
    return absl::OkStatus();
  }

  absl::Status Else() {
    if (conditions_.empty() || conditions_.back().has_else) {
      return absl::InvalidArgumentError("{else} without {if}");
    }
    Condition& open = conditions_.back();
    open.active = open.outer_active && !open.done;
    open.has_else = true;
    return absl::OkStatus();
  }

  absl::Status Endif() {
    if (conditions_.empty()) return absl::InvalidArgumentError("{endif} without {if}");
    conditions_.pop_back();
    return absl::OkStatus();
  }

  absl::StatusOr<bool> Holds(std::string_view condition, bool evaluate) const {
    const auto value = EvaluateExpression(condition, variables_, evaluate);
    if (!value.ok()) return value.status();
    return evaluate ? Truth(*value) : false;
  }

  std::string_view text_;
  const TemplateVariables& variables_;
  size_t at_ = 0;
  std::string result_;
  std::vector<Condition> conditions_;
};

}  // namespace

absl::StatusOr<std::string> ExpandTemplate(std::string_view setting, std::string_view text,
                                           const TemplateVariables& variables) {
  Expander expander(text, variables);
  const absl::Status status = expander.Run();
  if (status.ok()) return expander.TakeResult();
  const size_t line = expander.Line();
  std::map<std::string, std::string> metadata = {{"setting", std::string(setting)},
                                                 {"line", std::to_string(line)}};
  if (std::string variable = UnknownVariable(status); !variable.empty()) {
    metadata["variable"] = std::move(variable);
  }
  std::string message = std::string(setting) + ", line " + std::to_string(line) + ": " +
                        std::string(status.message());
  if (absl::IsResourceExhausted(status)) {
    metadata["limit"] = std::to_string(limits::kMaxExpandedBytes);
    message += ", at most " + metadata["limit"] + " bytes";
  }
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed, message,
                   std::move(metadata));
}

}  // namespace slicefarm::motion
