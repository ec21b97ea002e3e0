#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

namespace slicefarm::cli {

/// Takes a name for its value. Help lists the names alone: CLI11 would tell the enum's numbers, or
/// bytes, beside them.
template <class Enum>
CLI::Validator OneOf(std::map<std::string, Enum> names) {
  std::string list;
  for (const auto& [name, value] : names) list += (list.empty() ? "{" : ",") + name;
  CLI::CheckedTransformer transformer(std::move(names));
  transformer.description(list + "}");
  return transformer;
}

}  // namespace slicefarm::cli
