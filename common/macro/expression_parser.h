#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/macro/template.h"

namespace slicefarm::macro {

/// Where a parser stands in a template, and the words of its language.
class TemplateScanner {
 public:
  /// Nesting beyond this is refused, so that nobody's template takes the stack.
  static constexpr int kDeepest = 150;

  explicit TemplateScanner(std::string_view text) : text_(text) {}

  size_t at() const { return at_; }
  void GoTo(size_t at) { at_ = at; }
  bool AtEnd() const { return at_ == text_.size(); }
  std::string_view Rest() const { return text_.substr(at_); }
  int32_t Line() const;

  /// The character after blanks, and those beyond it; '\0' at the end.
  char Peek(size_t ahead = 0);
  bool Take(std::string_view sign);
  bool TakeWord(std::string_view word);
  bool SeesWord(std::string_view word);
  /// A name that is no word of the language; empty if there is none.
  std::string_view TakeName();

  absl::Status Unexpected() const;

 private:
  void SkipBlanks();

  std::string_view text_;
  size_t at_ = 0;
  mutable int32_t line_ = 1;  ///< at line_at_: lines are counted once
  mutable size_t line_at_ = 0;
};

/// A parsed part, or why it is none.
using ParsedExpression = absl::StatusOr<Expression>;

/// The expression at the scanner's place. `depth`: of what stands around it.
ParsedExpression ParseExpression(TemplateScanner& scanner, int& depth);

absl::Status Malformed(const std::string& what);

}  // namespace slicefarm::macro
