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
  std::string text = fmt::format(
      "flavor {}\nconfig {}\nlines {}\nmoves {}\nfilament_mm {:.5f}\nfindings {}\n",
      file->firmware->name(), file->machine.source, report.lines, report.moves, report.filament_mm,
      report.found);
  for (const motion::Finding& finding : report.findings)
    text += fmt::format("line {}: {}\n", finding.line, Shown(finding.text));
  if (report.found > static_cast<int64_t>(report.findings.size())) text += "line ...\n";
  Print(text);
  return report.found == 0 ? ExitCode::kOk : ExitCode::kFindings;
}

}  // namespace

void AddCheck(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("check", "Read a G-code file as strictly as its firmware would");
  const auto options = std::make_shared<GcodeOptions>();
  AddGcodeOptions(*command, *options);
  command->footer(
      "Exit code 1 if something is found, with a `line N: ...` for each finding: unknown commands\n"
      "and words, moves outside of the machine, too thick beads, sums of filament, arcs,\n"
      "retractions and restarts that do not fit, filament pushed cold.\n"
      "Example:\n"
      "  slicefarm check part.gcode --flavor klipper --config prusa.ini");
  command->callback(
      [options, &context] { context.run = [options] { return CheckGcode(*options); }; });
}

}  // namespace slicefarm::cli
