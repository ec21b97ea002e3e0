#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace slicefarm::cli {

/// Returns what is wrong with the command line, in words that name the argument and what to write
/// in its place. `app`: as it was when parsing failed with `error`.
std::string ParseErrorText(const CLI::App& app, const CLI::ParseError& error);

}  // namespace slicefarm::cli
