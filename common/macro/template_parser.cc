#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "absl/strings/ascii.h"
#include "common/base/error.h"
#include "common/base/text.h"
#include "common/macro/expression_parser.h"
#include "common/macro/template.h"
#include "common/model/limits.h"
#include "common/model/scene/scene.h"

namespace slicefarm::macro {
namespace {

using Body = std::vector<Statement>;
using ParsedBody = absl::StatusOr<Body>;
using ParsedStatement = absl::StatusOr<Statement>;

class TemplateParser {
 public:
  explicit TemplateParser(std::string_view text) : text_(text), in_(text) {}

  ParsedBody All() {
    ParsedBody body = TextBlock();
    if (!body.ok() || in_.AtEnd()) return body;
    return Malformed("{" + std::string(ClosingWord()) + "} without {if}");
  }

  int32_t Line() const { return in_.Line(); }

 private:
  /// Parses text with placeholders, up to the end or to a {elsif}, {else} or {endif}. The opening
  /// brace of this word is consumed.
  ParsedBody TextBlock() {
    Body body;
    while (!in_.AtEnd()) {
      const size_t open = std::min(text_.find_first_of("[{", in_.at()), text_.size());
      if (open > in_.at()) {
        body.push_back(
            {.line = in_.Line(), .text = std::string(text_.substr(in_.at(), open - in_.at()))});
        in_.GoTo(open);
      }
      if (in_.AtEnd()) break;
      if (in_.Take("[")) {
        ParsedStatement legacy = Legacy();
        if (!legacy.ok()) return legacy.status();
        body.push_back(*std::move(legacy));
        continue;
      }
      in_.Take("{");
      if (!ClosingWord().empty()) return body;
      if (absl::Status ok = Code(body); !ok.ok()) return ok;
    }
    return body;
  }

  /// Returns the next word if it is {elsif}, {else} or {endif}; otherwise an empty text.
  std::string_view ClosingWord() {
    for (const std::string_view word : {"elsif", "else", "endif"})
      if (in_.SeesWord(word)) return word;
    return {};
  }

  /// Parses statements up to the brace that closes them.
  absl::Status Code(Body& body) {
    bool any = false;
    while (!in_.Take("}")) {
      if (in_.AtEnd()) return Malformed("\"{\" without \"}\"");
      if (absl::Status ok = OneOfCode(body, any); !ok.ok()) return ok;
    }
    return any ? absl::OkStatus() : Malformed("expression expected");
  }

  /// Parses a statement and the separator after it, or only a separator.
  absl::Status OneOfCode(Body& body, bool& any) {
    any = true;
    if (in_.Take(";")) return absl::OkStatus();
    const bool is_block = in_.SeesWord("if");
    ParsedStatement statement = is_block ? If() : Simple();
    if (!statement.ok()) return statement.status();
    body.push_back(*std::move(statement));
    const bool ends = is_block || in_.Peek() == ';' || in_.Peek() == '}' || !ClosingWord().empty();
    if (ends) return absl::OkStatus();
    return in_.AtEnd() ? Malformed("\"{\" without \"}\"") : in_.Unexpected();
  }

  ParsedStatement If() {
    if (++depth_ > TemplateScanner::kDeepest) return Malformed("{if} too deep");
    Statement statement = {.kind = Statement::Kind::kIf, .line = in_.Line()};
    in_.TakeWord("if");
    do {
      if (absl::Status ok = Conditional(statement); !ok.ok()) return ok;
    } while (in_.TakeWord("elsif"));
    if (in_.TakeWord("else")) {
      if (absl::Status ok = Part(statement, {.kind = Statement::Kind::kBranch, .line = in_.Line()});
          !ok.ok())
        return ok;
    }
    --depth_;
    if (in_.TakeWord("endif")) return statement;
    const std::string_view word = ClosingWord();
    if (word.empty()) return Malformed("{if} without {endif}");
    return Malformed("{" + std::string(word) + "} without {if}");
  }

  /// Parses a condition with the part that depends on it.
  absl::Status Conditional(Statement& statement) {
    Statement branch = {.kind = Statement::Kind::kBranch, .line = in_.Line()};
    auto condition = ParseExpression(in_, depth_);
    if (!condition.ok()) return condition.status();
    branch.values.push_back(*std::move(condition));
    if (in_.Peek() != '}' && !in_.TakeWord("then"))
      return in_.AtEnd() ? Malformed("\"{\" without \"}\"") : in_.Unexpected();
    return Part(statement, std::move(branch));
  }

  /// Parses }text{ or statements, up to the word that ends the part.
  absl::Status Part(Statement& statement, Statement branch) {
    if (in_.Take("}")) {
      ParsedBody body = TextBlock();
      if (!body.ok()) return body.status();
      branch.body = *std::move(body);
      if (in_.AtEnd()) return Malformed("{if} without {endif}");
    } else {
      bool any = false;
      while (ClosingWord().empty()) {
        if (in_.AtEnd()) return Malformed("{if} without {endif}");
        if (absl::Status ok = OneOfCode(branch.body, any); !ok.ok()) return ok;
      }
    }
    statement.body.push_back(std::move(branch));
    return absl::OkStatus();
  }

  ParsedStatement Simple() {
    for (const bool global : {false, true}) {
      const auto kind = global ? Statement::Kind::kGlobal : Statement::Kind::kLocal;
      if (in_.TakeWord(global ? "global" : "local")) return Declaration(kind);
    }
    if (std::optional<ParsedStatement> assignment = Assignment()) return *std::move(assignment);
    Statement print = {.kind = Statement::Kind::kPrint, .line = in_.Line()};
    if (absl::Status ok = Value(print); !ok.ok()) return ok;
    return print;
  }

  ParsedStatement Declaration(Statement::Kind kind) {
    Statement made = {.kind = kind, .line = in_.Line()};
    made.text = in_.TakeName();
    if (made.text.empty()) return in_.Unexpected();
    if (!in_.Take("=")) return Malformed("\"=\" expected");
    if (absl::Status ok = RightSide(made); !ok.ok()) return ok;
    return made;
  }

  /// Parses name = .. or name[index] = ..; returns none if the next text is not an assignment.
  std::optional<ParsedStatement> Assignment() {
    const size_t begin = in_.at();
    Statement assignment = {.kind = Statement::Kind::kAssign, .line = in_.Line()};
    assignment.text = in_.TakeName();
    if (!assignment.text.empty() && in_.Take("[")) {
      auto index = ParseExpression(in_, depth_);
      if (index.ok()) assignment.index.push_back(*std::move(index));
      if (!index.ok() || !in_.Take("]")) assignment.text.clear();
    }
    const bool is_one =
        !assignment.text.empty() && in_.Peek() == '=' && in_.Peek(1) != '=' && in_.Peek(1) != '~';
    if (!is_one) {
      in_.GoTo(begin);
      return {};
    }
    in_.Take("=");
    if (absl::Status ok = RightSide(assignment); !ok.ok()) return ParsedStatement(ok);
    return ParsedStatement(std::move(assignment));
  }

  absl::Status RightSide(Statement& statement) {
    if (in_.TakeWord("repeat")) return Repeat(statement);
    const size_t begin = in_.at();
    if (in_.Take("(")) {
      statement.right = Statement::Right::kList;
      absl::Status list = Items(statement);
      const bool ends = in_.Peek() == ';' || in_.Peek() == '}' || !ClosingWord().empty();
      if (ends || !list.ok()) return list;
      // (1 + 2) * 3 is not a list.
      statement.right = Statement::Right::kValue;
      statement.values.clear();
      in_.GoTo(begin);
    }
    return Value(statement);
  }

  absl::Status Items(Statement& statement) {
    if (in_.Take(")")) return absl::OkStatus();
    do {
      if (absl::Status ok = Value(statement); !ok.ok()) return ok;
    } while (in_.Take(","));
    return in_.Take(")") ? absl::OkStatus() : Malformed("\")\" expected");
  }

  absl::Status Repeat(Statement& statement) {
    statement.right = Statement::Right::kRepeat;
    if (!in_.Take("(")) return Malformed("\"(\" expected");
    absl::Status status = Value(statement);
    if (status.ok() && !in_.Take(",")) return Malformed("\",\" expected");
    if (status.ok()) status = Value(statement);
    if (status.ok() && !in_.Take(")")) return Malformed("\")\" expected");
    return status;
  }

  absl::Status Value(Statement& statement) {
    auto value = ParseExpression(in_, depth_);
    if (!value.ok()) return value.status();
    statement.values.push_back(*std::move(value));
    return absl::OkStatus();
  }

  /// Parses the text after "[": name], name_2], name[index]] or name_[index]].
  ParsedStatement Legacy() {
    const size_t open = in_.at();
    Statement legacy = {.kind = Statement::Kind::kLegacy, .line = in_.Line()};
    legacy.text = in_.TakeName();
    if (!legacy.text.empty() && in_.Take("[")) {
      auto index = ParseExpression(in_, depth_);
      if (!index.ok()) return index.status();
      legacy.index.push_back(*std::move(index));
      if (!in_.Take("]")) return Malformed("\"]\" expected");
    }
    if (!legacy.text.empty() && in_.Take("]")) return legacy;
    const std::string_view inside = text_.substr(open, text_.find_first_of("]\n", open) - open);
    in_.GoTo(open);
    const bool closed = open + inside.size() < text_.size() && text_[open + inside.size()] == ']';
    if (!closed) return Malformed("\"[\" without \"]\"");
    return Malformed("\"[" + std::string(inside) + "]\" is not a variable");
  }

  std::string_view text_;
  TemplateScanner in_;
  int depth_ = 0;
};

void AddNames(const std::vector<Expression>& expressions, std::set<std::string>& names) {
  for (const Expression& expression : expressions) {
    if (expression.kind == Expression::Kind::kVariable ||
        expression.kind == Expression::Kind::kCall)
      names.insert(expression.text);
    AddNames(expression.parts, names);
  }
}

void AddNames(const Body& body, std::set<std::string>& names) {
  for (const Statement& statement : body) {
    if (statement.kind != Statement::Kind::kText && !statement.text.empty()) {
      names.insert(statement.text);
      // [name_2] and [name_[index]]
      const size_t underscore = statement.text.rfind('_');
      if (statement.kind == Statement::Kind::kLegacy && underscore != std::string::npos)
        names.insert(statement.text.substr(0, underscore));
    }
    AddNames(statement.values, names);
    AddNames(statement.index, names);
    AddNames(statement.body, names);
  }
}

void AddGlobals(const Body& body, std::set<std::string>& names) {
  for (const Statement& statement : body) {
    if (statement.kind == Statement::Kind::kGlobal) names.insert(statement.text);
    AddGlobals(statement.body, names);
  }
}

}  // namespace

absl::StatusOr<Template> ParseTemplate(std::string_view setting, std::string_view text) {
  // PrusaSlicer removes blanks at the beginning first.
  TemplateParser parser(text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size())));
  ParsedBody body = parser.All();
  if (body.ok()) return Template{std::string(setting), *std::move(body)};
  const std::string_view blanks =
      text.substr(0, std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  const auto lines_before = static_cast<int32_t>(std::count(blanks.begin(), blanks.end(), '\n'));
  return TemplateError(setting, lines_before + parser.Line(), body.status());
}

std::set<std::string> NamesIn(const Template& code) {
  std::set<std::string> names;
  AddNames(code.body, names);
  return names;
}

std::set<std::string> GlobalsOf(const Template& code) {
  std::set<std::string> names;
  AddGlobals(code.body, names);
  return names;
}

absl::Status TemplateError(std::string_view setting, int32_t line, const absl::Status& fault) {
  std::map<std::string, std::string> metadata = {{"setting", std::string(setting)},
                                                 {"line", std::to_string(line)}};
  std::string message =
      std::string(setting) + ", line " + std::to_string(line) + ": " + std::string(fault.message());
  if (const auto variable = fault.GetPayload(kVariableUrl))
    metadata["variable"] = std::string(*variable);
  Reason reason = Reason::kSettingMalformed;
  if (absl::IsResourceExhausted(fault)) {
    reason = Reason::kRequestTooLarge;
    metadata["limit"] = std::to_string(limits::kMaxExpandedBytes);
    message += ", at most " + metadata["limit"] + " bytes";
  }
  return MakeError(absl::StatusCode::kInvalidArgument, reason, message, std::move(metadata));
}

absl::Status ParseTemplates(std::span<const TemplateTarget> targets) {
  for (const TemplateTarget& target : targets) {
    auto parsed = ParseTemplate(target.setting, target.text);
    if (!parsed.ok()) return parsed.status();
    target.parsed = *std::move(parsed);
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::macro
