#include "services/slicing/algo/mesh_io/text_lines.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>

namespace slicefarm::slicing {
namespace {

bool IsBlank(char c) { return c == ' ' || c == '\\' || (c >= '\t' && c <= '\r'); }

/// Returns the value of a number beyond the range of double: 0 if it is too small, else infinity.
/// from_chars returns no value for such a number, so its exponent or its leading zero decides.
double OutOfDoubleRange(std::string_view number) {
  const size_t exponent = number.find_first_of("eE");
  const bool tiny = exponent == std::string_view::npos
                        ? number.starts_with("0.") || number.starts_with("-0.")
                        : number[exponent + 1] == '-';
  return tiny ? 0.0 : std::numeric_limits<double>::infinity();
}

}  // namespace

std::string_view Words::Next() {
  size_t begin = 0;
  while (begin < rest_.size() && IsBlank(rest_[begin])) ++begin;
  size_t end = begin;
  while (end < rest_.size() && !IsBlank(rest_[end])) ++end;
  const std::string_view word = rest_.substr(begin, end - begin);
  rest_.remove_prefix(end);
  return word;
}

std::optional<double> ParseNumber(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) return OutOfDoubleRange(word);
  return value;
}

LineReader::LineReader(std::string_view text, int64_t max_line_bytes, bool joins)
    : text_(text), max_line_bytes_(static_cast<size_t>(max_line_bytes)), joins_(joins) {
  next_lf_ = std::min(text_.find('\n'), text_.size());
  next_cr_ = std::min(text_.find('\r'), text_.size());
}

size_t LineReader::LineEnd(size_t begin) {
  // The positions of the next line ends are kept between calls. So a text that has only LF or only
  // CR is searched for the missing character only once.
  if (next_lf_ < begin) next_lf_ = std::min(text_.find('\n', begin), text_.size());
  if (next_cr_ < begin) next_cr_ = std::min(text_.find('\r', begin), text_.size());
  return std::min(next_lf_, next_cr_);
}

size_t LineReader::After(size_t end) const {
  return end + (text_.substr(end).starts_with("\r\n") ? 2 : 1);
}

absl::StatusOr<std::optional<std::string_view>> LineReader::Next() {
  if (at_ >= text_.size()) return std::nullopt;
  number_ = next_number_++;
  const size_t begin = at_;
  size_t end = LineEnd(begin);
  const auto joined = [&] {
    return joins_ && end > begin && text_[end - 1] == '\\' && end < text_.size() &&
           end - begin <= max_line_bytes_;
  };
  while (joined()) {
    end = LineEnd(After(end));
    ++next_number_;
  }
  if (end - begin > max_line_bytes_) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed,
                     fmt::format("line {} has {} bytes, at most {} are accepted", number_,
                                 end - begin, max_line_bytes_),
                     {{"limit", std::to_string(max_line_bytes_)},
                      {"got", std::to_string(end - begin)},
                      {"line", std::to_string(number_)}});
  }
  at_ = end < text_.size() ? After(end) : end;
  return text_.substr(begin, end - begin);
}

absl::Status LineReader::Error(Reason reason, std::string_view what) const {
  return MakeError(absl::StatusCode::kInvalidArgument, reason,
                   fmt::format("{} (line {})", what, number_), {{"line", std::to_string(number_)}});
}

}  // namespace slicefarm::slicing
