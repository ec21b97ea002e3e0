#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/macro/template_value.h"

namespace slicefarm::macro {

/// An expression of a template, as a tree.
struct Expression {
  enum class Kind {
    kLiteral,   ///< literal: `value`
    kVariable,  ///< variable `text`; `parts` is empty or has the index
    kSign,      ///< sign: `text` is "-" or "+"
    kNot,
    /// chain of `parts` from left to right, with `operators` between them; the part after =~ and !~
    /// is a literal
    kChain,
    kAnd,  ///< conjunction of all parts
    kOr,
    kChoice,   ///< conditional expression: parts are condition, value if true, value if false
    kCall,     ///< function call: `text` is the function's name, `parts` are its arguments
    kPattern,  ///< argument of one_of that is a regular expression, the only element of `parts`
  };
  Kind kind = Kind::kLiteral;
  std::string text = {};
  TemplateValue value = {};
  std::vector<std::string> operators = {};
  std::vector<Expression> parts = {};
};

/// A statement of a template, or plain text.
struct Statement {
  enum class Kind {
    kText,    ///< plain text that is printed unchanged: `text`
    kPrint,   ///< expression: prints the value of `values[0]`
    kLegacy,  ///< [name], [name_2], [name[index]]: variable `text`, with an index if there is one
    kAssign,  ///< assignment to variable `text`, or to its item `index`
    kLocal,
    kGlobal,
    kIf,      ///< conditional statement: each statement of `body` is a kBranch
    kBranch,  ///< {if c}, {elsif c} or, without `values`, {else}, with its `body`
  };
  /// Kind of the right side of an assignment.
  enum class Right { kValue, kList, kRepeat /* values: count, value */ };
  Kind kind = Kind::kText;
  Right right = Right::kValue;
  int32_t line = 1;
  std::string text = {};
  std::vector<Expression> values = {};
  std::vector<Expression> index = {};  ///< index of the item; at most one expression
  std::vector<Statement> body = {};
};

/// A parsed G-code template.
struct Template {
  std::string setting = {};  ///< setting that contains the template, for errors
  std::vector<Statement> body = {};
};

/// Parses a template in PrusaSlicer's language.
///
///   [key]  [key_0]  [key[0]]  [key_[index]]   a setting, or an item of one, as a profile writes it
///
///   {expression}
///   {if c}..{elsif c}..{else}..{endif}, {if c then a; b elsif d then e else f endif}
///   {local a = 1; global b = (1, 2, 3); b[1] = a; a = 7; c = repeat(3, "x")}
///
///   literals    12  0.5  "text"  true  false
///   operators   ?:  or ||  and &&  == != <> =~ !~  < <= > >=  + -  * / %  not !  - +  ( )
///   patterns    text =~ /regular expression/ (regex.h)
///   functions   min(a, b) max(a, b) int(a) round(a) random(a, b) digits(a, width[, decimals])
///               zdigits(...) is_nil(v) empty(list) size(list)
///               one_of(text, "a", ~"pattern", /pattern/, ...) interpolate_table(x, (x0, y0), ...)
///
/// Errors: InvalidArgument SETTING_MALFORMED with metadata `setting` and `line`. Depth is bounded.
/// Cost: O(length). Source: PrusaSlicer's documentation, "Macros", and the behaviour of its parser.
absl::StatusOr<Template> ParseTemplate(std::string_view setting, std::string_view text);

/// Setting that contains a template, and the object that receives the parsed template.
struct TemplateTarget {
  std::string_view setting;
  const std::string& text;
  Template& parsed;
};

/// Parses several templates. Errors: the error of the first template that ParseTemplate refuses.
absl::Status ParseTemplates(std::span<const TemplateTarget> targets);

/// Returns all variables and functions that a template uses.
std::set<std::string> NamesIn(const Template& code);

/// Returns the global variables that a template declares.
std::set<std::string> GlobalsOf(const Template& code);

/// Payload key of a status: its payload is the name of the variable that the error concerns.
inline constexpr char kVariableUrl[] = "slicefarm/unknown-variable";

/// Returns `fault` as the error of a template in `setting`, with the line: SETTING_MALFORMED, or
/// REQUEST_TOO_LARGE if `fault` is ResourceExhausted.
absl::Status TemplateError(std::string_view setting, int32_t line, const absl::Status& fault);

}  // namespace slicefarm::macro
