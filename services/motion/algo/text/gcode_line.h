#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace slicefarm::motion {

inline constexpr std::string_view kWordTwice = "a word is repeated";

/// One parsed line of G-code. Views point into the line.
///   G1 X10 Y-.5 E.03     command "G1", letter G, number 1, words X, Y and E
///   SET_FAN SPEED=1      command "SET_FAN", letter 0, parameters "SPEED=1"
///   ;TYPE:Perimeter      comment "TYPE:Perimeter"
struct GcodeLine {
  std::string_view command;     ///< command such as "G1"; empty if the line has only a comment
  char letter = 0;              ///< G, M, T, ... if the command is a letter and a number, else 0
  int number = -1;              ///< number after the letter, without decimals; M862.3: 862
  std::string_view parameters;  ///< text after the command, up to the comment
  std::string_view comment;     ///< text after `;`
  std::string_view fault;       ///< reason why the words cannot be read; empty if they can
  bool has_lists = false;       ///< true if a word has several numbers (`E1:0`) or a text in quotes

  /// Returns true if the line has the command of this letter and number.
  bool Is(char l, int n) const { return letter == l && number == n; }
  /// Returns true if the line has the word, with or without a number.
  bool Has(char word) const { return (present_ & Bit(word)) != 0; }
  /// Returns the number of a word; for a list, the first number. Returns nothing if the word is
  /// missing, has no number as in `G28 X`, or is a text.
  std::optional<double> operator[](char word) const {
    if ((valued_ & Bit(word)) == 0) return std::nullopt;
    return values_[static_cast<size_t>(word - 'A')];
  }
  /// Returns the text of the parameter `NAME=...`, or nothing if the command has no such parameter.
  std::optional<std::string_view> Named(std::string_view name) const;
  /// Returns the number of the parameter `NAME=...`, or nothing if it is missing or no number.
  std::optional<double> NamedNumber(std::string_view name) const;

 private:
  friend GcodeLine ParseGcodeLine(std::string_view line);
  static constexpr uint32_t Bit(char word) { return 1u << (word - 'A'); }
  void ReadWords(std::string_view text);

  std::array<double, 26> values_;
  uint32_t present_ = 0;
  uint32_t valued_ = 0;
};

/// Parses a line. Letters may be upper or lower case, with or without blanks between words. Line
/// numbers (N12) and checksums (*71) are accepted. Commands with text as parameters (M117, M486 A,
/// ...) have no words, nor have commands that are not a letter and a number. Numbers beyond 1e9 and
/// repeated words are faults (GcodeLine::fault).
GcodeLine ParseGcodeLine(std::string_view line);

}  // namespace slicefarm::motion
