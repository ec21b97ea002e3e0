#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace slicefarm::motion {

inline constexpr std::string_view kWordTwice = "a word is there twice";

/// One line of G-code, taken apart. Views point into the line.
///   G1 X10 Y-.5 E.03     command "G1", letter G, number 1, words X, Y and E
///   SET_FAN SPEED=1      command "SET_FAN", letter 0, parameters "SPEED=1"
///   ;TYPE:Perimeter      comment "TYPE:Perimeter"
struct GcodeLine {
  std::string_view command;     ///< empty: nothing but a comment
  char letter = 0;              ///< G, M, T, ... of a command of letter and number, else 0
  int number = -1;              ///< M862.3: 862
  std::string_view parameters;  ///< what follows the command, up to the comment
  std::string_view comment;     ///< behind `;`
  std::string_view fault;       ///< why words cannot be read; empty: they can
  bool has_lists = false;       ///< a word has several numbers (`E1:0`) or a text in quotes

  bool Is(char l, int n) const { return letter == l && number == n; }
  bool Has(char word) const { return (present_ & Bit(word)) != 0; }
  /// The number of a word, of a list the first; nothing if it is not there, bare as in `G28 X`, or
  /// a text.
  std::optional<double> operator[](char word) const {
    if ((valued_ & Bit(word)) == 0) return std::nullopt;
    return values_[static_cast<size_t>(word - 'A')];
  }
  /// The text of `NAME=...` among the parameters.
  std::optional<std::string_view> Named(std::string_view name) const;
  std::optional<double> NamedNumber(std::string_view name) const;

 private:
  friend GcodeLine ParseGcodeLine(std::string_view line);
  static constexpr uint32_t Bit(char word) { return 1u << (word - 'A'); }
  void ReadWords(std::string_view text);

  std::array<double, 26> values_;
  uint32_t present_ = 0;
  uint32_t valued_ = 0;
};

/// Takes a line apart, in either case, with or without blanks between words, line numbers (N12) and
/// checksums (*71). Commands whose parameters are text (M117, M486 A, ...) have no words, nor have
/// those of more than a letter and a number. Numbers beyond 1e9 are a fault, as are words that are
/// there twice.
GcodeLine ParseGcodeLine(std::string_view line);

}  // namespace slicefarm::motion
