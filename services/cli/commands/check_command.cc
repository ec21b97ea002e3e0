#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "services/cli/commands/commands.h"
#include "services/cli/commands/gcode_options.h"
#include "services/cli/console/console.h"
#include "services/motion/algo/program/program_check.h"

namespace slicefarm::cli {
namespace {

/// Replaces control characters by `?`, because the quoted text is from a foreign file.
std::string Shown(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
  return text;
}

ExitCode CheckGcode(const GcodeOptions& options) {
  const auto file = ReadGcode(options);
  if (!file.ok()) return Fail(file.status());
  const motion::ProgramReport report =
      motion::CheckProgram(file->gcode, *file->firmware, file->machine.setup);
  std::string text =
      fmt::format("flavor {}\nconfig {}\nlines {}\nmoves {}\nfilament_mm {:.5f}\nfindings {}\n",
                  file->firmware->name(), file->machine.source, report.lines, report.moves,
                  report.filament_mm, report.found);
  for (const motion::Finding& finding : report.findings)
    text += fmt::format("line {}: {}\n", finding.line, Shown(finding.text));
  if (report.found > static_cast<int64_t>(report.findings.size())) text += "line ...\n";
  Print(text);
  return report.found == 0 ? ExitCode::kOk : ExitCode::kFindings;
}

}  // namespace

void AddCheck(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("check", "Check a G-code file as strictly as its firmware reads it");
  const auto options = std::make_shared<GcodeOptions>();
  AddGcodeOptions(*command, *options);
  command->footer(
      "Prints `line N: ...` for each finding and ends with exit code 1 if there are any: "
      "unknown\ncommands and words, moves outside the machine, lines that are too thick, wrong "
      "extrusion sums,\nwrong arcs, unbalanced retractions, cold extrusion.\nExample:\n  slicefarm "
      "check part.gcode --flavor klipper --config prusa.ini");
  command->callback(
      [options, &context] { context.run = [options] { return CheckGcode(*options); }; });
}

}  // namespace slicefarm::cli
