#include "common/macro/expression_parser.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <span>
#include <utility>

#include "absl/strings/ascii.h"
#include "common/base/text.h"

namespace slicefarm::macro {
namespace {

/// Maximum length of text that an error quotes.
constexpr size_t kQuoted = 20;

constexpr std::string_view kWords[] = {"and",    "digits", "else",   "elsif",  "empty",
                                       "endif",  "false",  "global", "if",     "int",
                                       "is_nil", "local",  "max",    "min",    "interpolate_table",
                                       "not",    "one_of", "or",     "random", "repeat",
                                       "round",  "size",   "true",   "zdigits"};

/// A function and the number of its arguments.
struct Function {
  std::string_view name;
  size_t least;
  size_t most;
};
constexpr Function kFunctions[] = {{"min", 2, 2},    {"max", 2, 2},    {"int", 1, 1},
                                   {"round", 1, 1},  {"random", 2, 2}, {"digits", 2, 3},
                                   {"zdigits", 2, 3}};
constexpr std::string_view kOfVariables[] = {"is_nil", "empty", "size"};

/// Operators by precedence, lowest first. If one operator begins with another, the longer one is
/// listed first.
constexpr std::string_view kEqualities[] = {"==", "!=", "<>", "=~", "!~"};
constexpr std::string_view kComparisons[] = {"<=", ">=", "<", ">"};
constexpr std::string_view kSums[] = {"+", "-"};
constexpr std::string_view kProducts[] = {"*", "/", "%"};
constexpr std::span<const std::string_view> kLevels[] = {kEqualities, kComparisons, kSums,
                                                         kProducts};

bool StartsName(char c) { return absl::ascii_isalpha(static_cast<unsigned char>(c)) || c == '_'; }

Expression Made(Expression::Kind kind, std::string_view text) {
  return {.kind = kind, .text = std::string(text)};
}

Expression Made(Expression::Kind kind, std::string_view text, Expression part) {
  Expression made = Made(kind, text);
  made.parts.push_back(std::move(part));
  return made;
}

Expression LiteralOf(TemplateValue value) {
  return {.kind = Expression::Kind::kLiteral, .value = std::move(value)};
}

/// Recursive descent parser.
class ExpressionParser {
 public:
  ExpressionParser(TemplateScanner& scanner, int& depth) : in_(scanner), depth_(depth) {}

  ParsedExpression Choice() {
    if (++depth_ > TemplateScanner::kDeepest) return Malformed("expression too deep");
    ParsedExpression condition = Or();
    if (condition.ok() && in_.Take("?")) condition = ChosenBy(*std::move(condition));
    --depth_;
    return condition;
  }

 private:
  ParsedExpression ChosenBy(Expression condition) {
    Expression choice = Made(Expression::Kind::kChoice, "?");
    choice.parts.push_back(std::move(condition));
    if (absl::Status ok = AddPart(choice, Choice()); !ok.ok()) return ok;
    if (!in_.Take(":")) return Malformed("\":\" expected");
    if (absl::Status ok = AddPart(choice, Choice()); !ok.ok()) return ok;
    return choice;
  }

  ParsedExpression Or() {
    return Logic(Expression::Kind::kOr, "or", "||", [this] { return And(); });
  }
  ParsedExpression And() {
    return Logic(Expression::Kind::kAnd, "and", "&&", [this] { return Chain(0); });
  }

  template <typename Operand>
  ParsedExpression Logic(Expression::Kind kind, std::string_view word, std::string_view sign,
                         const Operand& operand) {
    ParsedExpression first = operand();
    if (!first.ok()) return first;
    Expression logic = Made(kind, word);
    logic.parts.push_back(*std::move(first));
    while (in_.TakeWord(word) || in_.Take(sign))
      if (absl::Status ok = AddPart(logic, operand()); !ok.ok()) return ok;
    return Single(std::move(logic));
  }

  /// Parses operators of one precedence level. A long chain becomes one node instead of a deep
  /// tree, so that no template can exhaust the stack.
  ParsedExpression Chain(size_t level) {
    if (level == std::size(kLevels)) return Unary();
    ParsedExpression first = Chain(level + 1);
    if (!first.ok()) return first;
    Expression chain = Made(Expression::Kind::kChain, {});
    chain.parts.push_back(*std::move(first));
    for (;;) {
      const std::string_view op = TakeOneOf(kLevels[level]);
      if (op.empty()) return Single(std::move(chain));
      chain.operators.emplace_back(op);
      absl::Status ok = AddPart(chain, op.back() == '~' ? Pattern() : Chain(level + 1));
      if (!ok.ok()) return ok;
    }
  }

  static absl::Status AddPart(Expression& whole, ParsedExpression part) {
    if (!part.ok()) return part.status();
    whole.parts.push_back(*std::move(part));
    return absl::OkStatus();
  }

  /// Returns the only part of an expression with one part; otherwise returns the expression
  /// unchanged.
  static Expression Single(Expression whole) {
    if (whole.parts.size() > 1) return whole;
    Expression only = std::move(whole.parts.front());
    return only;
  }

  std::string_view TakeOneOf(std::span<const std::string_view> signs) {
    const bool unequal = in_.Peek() == '<' && in_.Peek(1) == '>';
    for (const std::string_view sign : signs) {
      if (unequal && sign == "<") continue;
      if (in_.Take(sign)) return sign;
    }
    return {};
  }

  ParsedExpression Unary() {
    if (++depth_ > TemplateScanner::kDeepest) return Malformed("expression too deep");
    ParsedExpression value = Signed();
    --depth_;
    return value;
  }

  ParsedExpression Signed() {
    if (in_.TakeWord("not") || in_.Take("!")) return Around(Expression::Kind::kNot, "!");
    if (in_.Take("-")) return Around(Expression::Kind::kSign, "-");
    if (in_.Take("+")) return Around(Expression::Kind::kSign, "+");
    return Primary();
  }

  ParsedExpression Around(Expression::Kind kind, std::string_view sign) {
    ParsedExpression inner = Unary();
    if (!inner.ok()) return inner;
    return Made(kind, sign, *std::move(inner));
  }

  ParsedExpression Primary() {
    const char next = in_.Peek();
    if (next == '(') return Parenthesised();
    if (next == '"') return Text();
    if (absl::ascii_isdigit(static_cast<unsigned char>(next)) ||
        (next == '.' && absl::ascii_isdigit(static_cast<unsigned char>(in_.Peek(1)))))
      return Number();
    if (StartsName(next)) return Named();
    return next == '\0' ? Malformed("expression expected") : in_.Unexpected();
  }

  ParsedExpression Parenthesised() {
    in_.Take("(");
    ParsedExpression value = Choice();
    if (value.ok() && !in_.Take(")")) return Malformed("\")\" expected");
    return value;
  }

  ParsedExpression Text() {
    const std::string_view rest = in_.Rest();
    std::string text;
    size_t at = 1;
    for (; at < rest.size() && rest[at] != '"'; ++at) {
      char c = rest[at];
      if (c == '\\' && at + 1 < rest.size()) {
        c = rest[++at];
        if (c == 'n') c = '\n';
        if (c == 'r') c = '\r';
      }
      text += c;
    }
    if (at == rest.size()) return Malformed("text without end");
    in_.GoTo(in_.at() + at + 1);
    return LiteralOf(std::move(text));
  }

  /// Parses a regular expression between slashes and returns it as text.
  ParsedExpression Pattern() {
    if (in_.Peek() != '/') return Malformed("\"/\" expected");
    const std::string_view rest = in_.Rest();
    std::string pattern;
    size_t at = 1;
    for (; at < rest.size() && rest[at] != '/'; ++at) {
      const bool escaped = rest[at] == '\\' && at + 1 < rest.size();
      if (escaped && rest[at + 1] != '/') pattern += rest[at];
      if (escaped) ++at;
      pattern += rest[at];
    }
    if (at == rest.size()) return Malformed("regular expression without end");
    in_.GoTo(in_.at() + at + 1);
    return LiteralOf(std::move(pattern));
  }

  ParsedExpression Number() {
    const std::string_view rest = in_.Rest();
    const char* const end = rest.data() + rest.size();
    int64_t whole = 0;
    const auto [whole_end, whole_error] = std::from_chars(rest.data(), end, whole);
    const bool real = whole_end != end && (*whole_end == '.' || *whole_end == 'e');
    if (whole_error == std::errc() && !real) {
      in_.GoTo(in_.at() + static_cast<size_t>(whole_end - rest.data()));
      return LiteralOf(whole);
    }
    double number = 0;
    const auto [number_end, number_error] = std::from_chars(rest.data(), end, number);
    if (number_error != std::errc()) return Malformed("number out of range");
    in_.GoTo(in_.at() + static_cast<size_t>(number_end - rest.data()));
    return LiteralOf(number);
  }

  ParsedExpression Named() {
    for (const bool truth : {true, false})
      if (in_.TakeWord(truth ? "true" : "false")) return LiteralOf(truth);
    for (const Function& function : kFunctions)
      if (in_.TakeWord(function.name)) return Call(function);
    for (const std::string_view name : kOfVariables)
      if (in_.TakeWord(name)) return OfVariable(name);
    if (in_.TakeWord("one_of")) return OneOf();
    if (in_.TakeWord("interpolate_table")) return Table();
    return Variable();
  }

  ParsedExpression Variable() {
    const std::string_view name = in_.TakeName();
    if (name.empty()) return in_.Unexpected();
    if (in_.Peek() == '(') return Malformed("unknown function \"" + std::string(name) + "\"");
    Expression variable = Made(Expression::Kind::kVariable, name);
    if (!in_.Take("[")) return variable;
    ParsedExpression index = Choice();
    if (!index.ok()) return index;
    if (!in_.Take("]")) return Malformed("\"]\" expected");
    variable.parts.push_back(*std::move(index));
    return variable;
  }

  ParsedExpression Call(const Function& function) {
    if (!in_.Take("(")) return Malformed("\"(\" expected");
    Expression call = Made(Expression::Kind::kCall, function.name);
    do {
      ParsedExpression argument = Choice();
      if (!argument.ok()) return argument;
      call.parts.push_back(*std::move(argument));
    } while (in_.Take(","));
    if (!in_.Take(")")) return Malformed("\")\" expected");
    const size_t count = call.parts.size();
    if (function.least <= count && count <= function.most) return call;
    return Malformed("wrong number of arguments of " + call.text);
  }

  ParsedExpression OfVariable(std::string_view name) {
    if (!in_.Take("(")) return Malformed("\"(\" expected");
    ParsedExpression variable = Variable();
    if (!variable.ok()) return variable;
    if (!in_.Take(")")) return Malformed("\")\" expected");
    return Made(Expression::Kind::kCall, name, *std::move(variable));
  }

  /// Parses one_of; commas between its patterns are optional.
  ParsedExpression OneOf() {
    if (!in_.Take("(")) return Malformed("\"(\" expected");
    ParsedExpression subject = Unary();
    if (!subject.ok()) return subject;
    Expression call = Made(Expression::Kind::kCall, "one_of", *std::move(subject));
    in_.Take(",");
    while (!in_.Take(")")) {
      const bool slashes = in_.Peek() == '/';
      const bool tilde = !slashes && in_.Take("~");
      ParsedExpression pattern = slashes ? Pattern() : Unary();
      if (!pattern.ok()) return pattern;
      if (slashes || tilde) pattern = Made(Expression::Kind::kPattern, "~", *std::move(pattern));
      call.parts.push_back(*std::move(pattern));
      in_.Take(",");
    }
    return call;
  }

  /// Parses x, then x and y of each point; commas between the points are optional.
  ParsedExpression Table() {
    if (!in_.Take("(")) return Malformed("\"(\" expected");
    ParsedExpression x = Unary();
    if (!x.ok()) return x;
    Expression call = Made(Expression::Kind::kCall, "interpolate_table", *std::move(x));
    if (!in_.Take(",")) return Malformed("\",\" expected");
    while (in_.Take("(")) {
      for (const std::string_view after : {",", ")"}) {
        ParsedExpression coordinate = Unary();
        if (!coordinate.ok()) return coordinate;
        call.parts.push_back(*std::move(coordinate));
        if (!in_.Take(after)) return Malformed("\"" + std::string(after) + "\" expected");
      }
      in_.Take(",");
    }
    if (call.parts.size() < 3) return Malformed("a table needs a point");
    if (!in_.Take(")")) return Malformed("\")\" expected");
    return call;
  }

  TemplateScanner& in_;
  int& depth_;
};

}  // namespace

absl::Status Malformed(const std::string& what) { return absl::InvalidArgumentError(what); }

int32_t TemplateScanner::Line() const {
  const auto breaks = [&](size_t from, size_t to) {
    const auto begin = text_.begin();
    return static_cast<int32_t>(
        std::count(begin + static_cast<ptrdiff_t>(from), begin + static_cast<ptrdiff_t>(to), '\n'));
  };
  line_ += at_ >= line_at_ ? breaks(line_at_, at_) : -breaks(at_, line_at_);
  line_at_ = at_;
  return line_;
}

void TemplateScanner::SkipBlanks() {
  while (at_ < text_.size() && absl::ascii_isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
}

char TemplateScanner::Peek(size_t ahead) {
  SkipBlanks();
  return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
}

bool TemplateScanner::Take(std::string_view sign) {
  SkipBlanks();
  if (!Rest().starts_with(sign)) return false;
  at_ += sign.size();
  return true;
}

bool TemplateScanner::SeesWord(std::string_view word) {
  SkipBlanks();
  const std::string_view rest = Rest();
  return rest.starts_with(word) && (rest.size() == word.size() || !IsOfName(rest[word.size()]));
}

bool TemplateScanner::TakeWord(std::string_view word) {
  if (!SeesWord(word)) return false;
  at_ += word.size();
  return true;
}

std::string_view TemplateScanner::TakeName() {
  SkipBlanks();
  size_t end = at_;
  while (end < text_.size() && IsOfName(text_[end])) ++end;
  const std::string_view name = text_.substr(at_, end - at_);
  if (name.empty() || !StartsName(name.front())) return {};
  if (std::find(std::begin(kWords), std::end(kWords), name) != std::end(kWords)) return {};
  at_ = end;
  return name;
}

absl::Status TemplateScanner::Unexpected() const {
  return AtEnd() ? Malformed("unexpected end")
                 : Malformed("unexpected \"" + std::string(text_.substr(at_, kQuoted)) + "\"");
}

ParsedExpression ParseExpression(TemplateScanner& scanner, int& depth) {
  return ExpressionParser(scanner, depth).Choice();
}

}  // namespace slicefarm::macro
