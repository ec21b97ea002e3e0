#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace slicefarm::cli {

/// Returns the error text for a `text` that is not among `names`. It contains the most similar
/// name.
std::string NoSuchChoice(const std::string& text, const std::vector<std::string>& names);

/// Returns the names in the form "{grid,snug}".
std::string ListOf(const std::vector<std::string>& names);

/// Returns the keys of a map.
template <class Value>
std::vector<std::string> NamesOf(const std::map<std::string, Value>& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  return names;
}

/// Returns a validator that accepts one of the names.
CLI::Validator OneOf(std::vector<std::string> names);

/// Returns a CLI11 transformer from names to values. --help lists only the names; CLI11 alone would
/// add the enumerators' numbers.
template <class Enum>
CLI::Validator OneOf(std::map<std::string, Enum> values) {
  const std::vector<std::string> names = NamesOf(values);
  const CLI::CheckedTransformer transformer(std::move(values));
  return CLI::Validator(
      [transformer, names](std::string& text) {
        return transformer(text).empty() ? std::string() : NoSuchChoice(text, names);
      },
      ListOf(names));
}

/// Returns the error text if `text` is not a number from `min` to `max`; otherwise an empty text.
/// `whole`: the number must be a whole number. `open_end`: the number must be greater than `min`.
std::string FaultOfNumber(const std::string& text, double min, double max, bool whole,
                          bool open_end);

/// Returns a validator that accepts a number from `min` to `max`.
template <class Number>
CLI::Validator InRange(Number min, Number max) {
  static_assert(std::is_arithmetic_v<Number>);
  return CLI::Validator(
      [min, max](std::string& text) {
        return FaultOfNumber(text, static_cast<double>(min), static_cast<double>(max),
                             std::is_integral_v<Number>, false);
      },
      "");
}

/// Returns a validator that accepts a number above 0.
CLI::Validator AboveZero();
/// Returns a validator that accepts a number of at least 0.
CLI::Validator ZeroOrMore();

}  // namespace slicefarm::cli
