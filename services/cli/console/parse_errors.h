#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace slicefarm::cli {

/// Returns the error text for a command line that CLI11 could not parse. The text contains the
/// faulty argument and the correct form. `app`: the parser after the failure. `error`: CLI11's
/// exception.
std::string ParseErrorText(const CLI::App& app, const CLI::ParseError& error);

}  // namespace slicefarm::cli
