#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace slicefarm::cli {

/// Returns the error in the command line, naming the argument and the correct form. `app`: state of
/// the parser when it failed with `error`.
std::string ParseErrorText(const CLI::App& app, const CLI::ParseError& error);

}  // namespace slicefarm::cli
