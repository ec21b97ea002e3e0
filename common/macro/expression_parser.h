#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/macro/template.h"

namespace slicefarm::macro {

/// Scanner of a template: reads characters, signs, words and names at its current position.
class TemplateScanner {
 public:
  /// Maximum nesting depth. Deeper templates are refused, so that no template can exhaust the
  /// stack.
  static constexpr int kDeepest = 150;

  explicit TemplateScanner(std::string_view text) : text_(text) {}

  size_t at() const { return at_; }
  /// Moves the scanner to an earlier or later position.
  void GoTo(size_t at) { at_ = at; }
  bool AtEnd() const { return at_ == text_.size(); }
  std::string_view Rest() const { return text_.substr(at_); }
  /// Returns the number of the current line, counted from 1.
  int32_t Line() const;

  /// Returns the character `ahead` characters after the next character that is not blank; '\0' at
  /// the end.
  char Peek(size_t ahead = 0);
  /// Skips blanks and consumes `sign` if it follows. Returns true if it did.
  bool Take(std::string_view sign);
  /// Skips blanks and consumes `word` if it follows as a whole word. Returns true if it did.
  bool TakeWord(std::string_view word);
  /// Returns true if `word` follows as a whole word; consumes nothing.
  bool SeesWord(std::string_view word);
  /// Reads a name. Returns an empty text if no name follows, or if it is a keyword.
  std::string_view TakeName();

  /// Returns an error about the text at the current position.
  absl::Status Unexpected() const;

 private:
  void SkipBlanks();

  std::string_view text_;
  size_t at_ = 0;
  /// line number at position line_at_, so that each line is counted only once
  mutable int32_t line_ = 1;
  mutable size_t line_at_ = 0;
};

/// Parsed expression, or an error.
using ParsedExpression = absl::StatusOr<Expression>;

/// Parses the expression at the scanner's position. `depth`: nesting depth of the enclosing
/// expressions.
ParsedExpression ParseExpression(TemplateScanner& scanner, int& depth);

/// Returns an error about a malformed template, with the text `what`.
absl::Status Malformed(const std::string& what);

}  // namespace slicefarm::macro
