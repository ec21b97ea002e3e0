#include "services/motion/algo/macro/template_expression.h"

#include <cctype>
#include <charconv>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "absl/strings/ascii.h"
#include "absl/strings/cord.h"
#include "common/base/text.h"
#include "services/motion/algo/macro/template_absences.h"
#include "services/motion/algo/macro/template_arithmetic.h"

namespace slicefarm::motion {
namespace {

constexpr int kDeepest = 100;
/// As much of the text as an error quotes.
constexpr size_t kQuoted = 20;
constexpr char kVariableUrl[] = "slicefarm/unknown-variable";

using Result = absl::StatusOr<TemplateValue>;

absl::Status Wrong(const std::string& what) { return absl::InvalidArgumentError(what); }

absl::Status Unknown(std::string_view name) {
  const std::string_view why = WhyAbsent(name);
  absl::Status status = Wrong("unknown variable \"" + std::string(name) + "\"" +
                              (why.empty() ? "" : ": " + std::string(why)));
  status.SetPayload(kVariableUrl, absl::Cord(std::string(name)));
  return status;
}

bool StartsName(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Operators by how tightly they bind, the loosest first; of one that begins another, the longer
/// first.
struct Level {
  std::span<const std::string_view> operators;
};
constexpr std::string_view kEqualities[] = {"==", "!=", "=~", "!~"};
constexpr std::string_view kComparisons[] = {"<>", "<=", ">=", "<", ">"};
constexpr std::string_view kSums[] = {"+", "-"};
constexpr std::string_view kProducts[] = {"*", "/", "%"};
constexpr Level kLevels[] = {{kEqualities}, {kComparisons}, {kSums}, {kProducts}};

/// Recursive descent. While `evaluate_` is false, values are zeros that nobody looks at.
class Parser {
 public:
  Parser(std::string_view text, const TemplateVariables& variables, bool evaluate)
      : text_(text), variables_(variables), evaluate_(evaluate) {}

  Result All() {
    Result value = Choice();
    if (value.ok() && Peek() != '\0') return Unexpected();
    return value;
  }

 private:
  Result Choice() {
    if (++depth_ > kDeepest) return Wrong("expression too deep");
    Result condition = Or();
    if (condition.ok() && Take("?")) condition = ChosenBy(*condition);
    --depth_;
    return condition;
  }

  Result ChosenBy(const TemplateValue& condition) {
    const auto truth = TruthNow(condition);
    if (!truth.ok()) return truth.status();
    Result yes = Skippable(*truth, [this] { return Choice(); });
    if (!yes.ok()) return yes;
    if (!Take(":")) return Wrong("\":\" expected");
    Result no = Skippable(!*truth, [this] { return Choice(); });
    return !no.ok() || !*truth ? no : yes;
  }

  Result Or() {
    return Logic("or", "||", true, [this] { return And(); });
  }
  Result And() {
    return Logic("and", "&&", false, [this] { return Not(); });
  }

  /// The operand on the right counts only if the left one is not `decisive`.
  template <typename Operand>
  Result Logic(std::string_view word, std::string_view sign, bool decisive,
               const Operand& operand) {
    Result left = operand();
    while (left.ok() && (TakeWord(word) || Take(sign))) {
      const auto truth = TruthNow(*left);
      if (!truth.ok()) return truth.status();
      const Result right = Skippable(*truth != decisive, operand);
      if (!right.ok()) return right;
      if (*truth == decisive) {
        left = TemplateValue(decisive);
        continue;
      }
      const auto other = TruthNow(*right);
      if (!other.ok()) return other.status();
      left = TemplateValue(*other);
    }
    return left;
  }

  Result Not() {
    if (!TakeWord("not") && !(Peek() == '!' && Peek(1) != '=' && Take("!"))) return Binary(0);
    if (++depth_ > kDeepest) return Wrong("expression too deep");
    const Result value = Not();
    --depth_;
    if (!value.ok()) return value;
    const auto truth = TruthNow(*value);
    if (!truth.ok()) return truth.status();
    return TemplateValue(!*truth);
  }

  Result Binary(size_t level) {
    if (level == std::size(kLevels)) return Unary();
    Result left = Binary(level + 1);
    while (left.ok()) {
      const std::string_view op = TakeOneOf(kLevels[level].operators);
      if (op.empty()) break;
      const Result right = op.back() == '~' ? Pattern() : Binary(level + 1);
      if (!right.ok()) return right;
      if (evaluate_) left = Apply(op, *std::move(left), *right);
    }
    return left;
  }

  Result Unary() {
    if (++depth_ > kDeepest) return Wrong("expression too deep");
    Result value = Take("-") ? Minus() : Primary();
    --depth_;
    return value;
  }

  Result Minus() {
    const Result value = Unary();
    return value.ok() && evaluate_ ? Negated(*value) : value;
  }

  Result Primary() {
    const char next = Peek();
    if (next == '(') return Parenthesised();
    if (next == '"') return Text();
    if (absl::ascii_isdigit(next) || (next == '.' && absl::ascii_isdigit(Peek(1)))) return Number();
    if (StartsName(next)) return Named();
    return next == '\0' ? Wrong("expression expected") : Unexpected();
  }

  Result Parenthesised() {
    Take("(");
    Result value = Choice();
    if (value.ok() && !Take(")")) return Wrong("\")\" expected");
    return value;
  }

  Result Text() {
    std::string text;
    for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
      char c = text_[at_];
      if (c == '\\' && at_ + 1 < text_.size()) {
        c = text_[++at_];
        if (c == 'n') c = '\n';
      }
      text += c;
    }
    if (at_ == text_.size()) return Wrong("text without end");
    ++at_;
    return TemplateValue(std::move(text));
  }

  /// A regular expression between slashes, as text.
  Result Pattern() {
    if (!Take("/")) return Wrong("\"/\" expected");
    std::string pattern;
    for (; at_ < text_.size() && text_[at_] != '/'; ++at_) {
      const bool escaped = text_[at_] == '\\' && at_ + 1 < text_.size();
      if (escaped && text_[at_ + 1] != '/') pattern += text_[at_];
      if (escaped) ++at_;
      pattern += text_[at_];
    }
    if (at_ == text_.size()) return Wrong("regular expression without end");
    ++at_;
    return TemplateValue(std::move(pattern));
  }

  Result Number() {
    const char* begin = text_.data() + at_;
    const char* end = text_.data() + text_.size();
    int64_t whole = 0;
    const auto [whole_end, whole_error] = std::from_chars(begin, end, whole);
    const bool real = whole_end != end && (*whole_end == '.' || *whole_end == 'e');
    if (whole_error == std::errc() && !real) {
      at_ += static_cast<size_t>(whole_end - begin);
      return TemplateValue(whole);
    }
    double number = 0;
    const auto [number_end, number_error] = std::from_chars(begin, end, number);
    if (number_error != std::errc()) return Wrong("number out of range");
    at_ += static_cast<size_t>(number_end - begin);
    return TemplateValue(number);
  }

  Result Named() {
    const std::string_view name = TakeName();
    if (name == "true" || name == "false") return TemplateValue(name == "true");
    if (Peek() == '(') return FunctionCall(name);
    int64_t index = 0;
    if (Take("[")) {
      const Result value = Choice();
      if (!value.ok()) return value;
      if (!Take("]")) return Wrong("\"]\" expected");
      const auto* whole = std::get_if<int64_t>(&*value);
      if (evaluate_ && whole == nullptr) return Wrong("an index is a whole number");
      if (whole != nullptr) index = *whole;
    }
    return evaluate_ ? Lookup(name, index) : TemplateValue(int64_t{0});
  }

  Result FunctionCall(std::string_view name) {
    Take("(");
    std::vector<TemplateValue> arguments;
    do {
      Result argument = Choice();
      if (!argument.ok()) return argument;
      arguments.push_back(*std::move(argument));
    } while (Take(","));
    if (!Take(")")) return Wrong("\")\" expected");
    return evaluate_ ? Call(name, arguments) : TemplateValue(int64_t{0});
  }

  Result Lookup(std::string_view name, int64_t index) const {
    const TemplateValue* value = FindValue(variables_, name, index);
    if (value == nullptr) return Unknown(name);
    return *value;
  }

  /// Reads a part whose value counts only if `counts`.
  template <typename Part>
  Result Skippable(bool counts, const Part& part) {
    const bool before = std::exchange(evaluate_, evaluate_ && counts);
    Result value = part();
    evaluate_ = before;
    return value;
  }

  absl::StatusOr<bool> TruthNow(const TemplateValue& value) const {
    return evaluate_ ? Truth(value) : false;
  }

  void SkipSpace() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }

  char Peek(size_t ahead = 0) {
    SkipSpace();
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  absl::Status Unexpected() const {
    return Wrong("unexpected \"" + std::string(text_.substr(at_, kQuoted)) + "\"");
  }

  bool Take(std::string_view sign) {
    SkipSpace();
    if (!text_.substr(at_).starts_with(sign)) return false;
    at_ += sign.size();
    return true;
  }

  bool TakeWord(std::string_view word) {
    SkipSpace();
    const std::string_view rest = text_.substr(at_);
    if (!rest.starts_with(word)) return false;
    if (rest.size() > word.size() && IsOfName(rest[word.size()])) return false;
    at_ += word.size();
    return true;
  }

  std::string_view TakeOneOf(std::span<const std::string_view> signs) {
    for (const std::string_view sign : signs) {
      if (Take(sign)) return sign;
    }
    return {};
  }

  std::string_view TakeName() {
    const size_t begin = at_;
    while (at_ < text_.size() && IsOfName(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  std::string_view text_;
  const TemplateVariables& variables_;
  bool evaluate_;
  size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

absl::StatusOr<TemplateValue> EvaluateExpression(std::string_view text,
                                                 const TemplateVariables& variables,
                                                 bool evaluate) {
  return Parser(text, variables, evaluate).All();
}

absl::StatusOr<bool> Truth(const TemplateValue& value) {
  if (const auto* truth = std::get_if<bool>(&value)) return *truth;
  if (const auto* whole = std::get_if<int64_t>(&value)) return *whole != 0;
  if (const auto* number = std::get_if<double>(&value)) return *number != 0;
  return absl::InvalidArgumentError("a condition is true or false, not text");
}

std::string UnknownVariable(const absl::Status& status) {
  const auto payload = status.GetPayload(kVariableUrl);
  return payload ? std::string(*payload) : std::string();
}

}  // namespace slicefarm::motion
