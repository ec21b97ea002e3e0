#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace slicefarm::cli {

/// Says that `text` is none of `names`, and which of them is meant, most likely.
std::string NoSuchChoice(const std::string& text, const std::vector<std::string>& names);

/// "{grid,snug}".
std::string ListOf(const std::vector<std::string>& names);

/// The keys of a map.
template <class Value>
std::vector<std::string> NamesOf(const std::map<std::string, Value>& values) {
  std::vector<std::string> names;
  for (const auto& [name, value] : values) names.push_back(name);
  return names;
}

/// Takes one of the names.
CLI::Validator OneOf(std::vector<std::string> names);

/// Takes a name for its value. Help lists the names alone: CLI11 would tell the enum's numbers, or
/// bytes, beside them.
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

/// Says what is wrong with a number, or nothing. Whole ones: without a fraction.
std::string FaultOfNumber(const std::string& text, double min, double max, bool whole,
                          bool open_end);

/// Takes a number from `min` to `max`.
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

/// Takes a number above 0, or one of 0 and above.
CLI::Validator AboveZero();
CLI::Validator ZeroOrMore();

}  // namespace slicefarm::cli
