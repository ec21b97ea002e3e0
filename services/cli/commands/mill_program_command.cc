#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "common/model/milling/cutter_text.h"
#include "services/cli/choice_option.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console.h"
#include "services/cli/files.h"
#include "services/cli/models/mill_mesh.h"
#include "services/milling/algo/motion/mill_program.h"
#include "services/milling/algo/output/level_svg.h"
#include "services/milling/algo/output/mill_report.h"
#include "services/milling/algo/output/program_text.h"

namespace slicefarm::cli {
namespace {

struct MillCommandOptions {
  std::string model;
  std::string output;
  std::string cutter = "ball:4";
  std::string stock;
  std::string svg;
  size_t svg_step = 0;
  double stepover_percent = 40;
  bool no_finishing = false;
  MillDialect dialect = MillDialect::kLinuxCnc;
  MillingOptions how;
  int threads = 1;
};

absl::StatusOr<milling::MillingJob> PrepareJob(const MillCommandOptions& options) {
  MillingOptions how = options.how;
  const auto cutter = ParseCutter(options.cutter);
  if (!cutter.ok()) return cutter.status();
  how.cutter = *cutter;
  how.stepover_share = options.stepover_percent / 100;
  how.finishing = !options.no_finishing;
  auto part = ReadTriangles(options.model);
  if (!part.ok()) return part.status();
  std::optional<milling::TriangleMesh> stock;
  if (!options.stock.empty()) {
    auto mesh = ReadTriangles(options.stock);
    if (!mesh.ok()) return mesh.status();
    stock = *std::move(mesh);
  }
  return milling::PrepareMilling(*std::move(part), std::move(stock), how);
}

std::string RowsOf(const MillReport& report) {
  std::string rows;
  double seconds = 0;
  const char* const names[] = {"roughing", "finishing", "rest"};
  for (size_t i = 0; i < report.phases.size(); ++i) {
    const PhaseReport& phase = report.phases[i];
    seconds += phase.seconds;
    rows += fmt::format("{0}_cut_mm {1:.1f}\n{0}_rapid_mm {2:.1f}\n{0}_moves {3}\n{0}_arcs {4}\n",
                        names[i], phase.cut_mm, phase.rapid_mm, phase.moves, phase.arcs);
  }
  return rows + fmt::format("ways {}\nseconds {:.1f}\nremoved_mm3 {:.1f}\nchecked {}\ngouges {}\n",
                            report.ways, seconds, report.removed_mm3, report.checked,
                            report.gouges);
}

absl::Status Mill(const MillCommandOptions& options) {
  const auto job = PrepareJob(options);
  if (!job.ok()) return job.status();
  const auto steps = milling::MillSteps(*job, 0, job->steps.size(), {}, options.threads);
  if (!steps.ok()) return steps.status();
  if (!options.svg.empty() && options.svg_step < steps->size()) {
    const absl::Status written =
        WriteFile(options.svg, milling::LevelSvg(*job, (*steps)[options.svg_step]));
    if (!written.ok()) return written;
  }
  const auto program = milling::AssembleProgram(*job, *steps);
  if (!program.ok()) return program.status();
  const auto report = milling::ReportOf(*job, *program, {}, options.threads);
  if (!report.ok()) return report.status();
  const absl::Status written =
      WriteFile(options.output,
                milling::ProgramText(*program, job->options, *milling::DialectOf(options.dialect)));
  if (!written.ok()) return written;
  Print(fmt::format("steps {}\n", steps->size()) + RowsOf(*report));
  return absl::OkStatus();
}

/// A number of mm, mm/min or degrees.
void AddNumber(CLI::App& command, const std::string& name, double& value, const std::string& help) {
  command.add_option(name, value, help)->capture_default_str()->type_name("N");
}

void AddStrategy(CLI::App& command, MillCommandOptions& options) {
  MillingOptions& how = options.how;
  command.add_option("--stock", options.stock, "STL of the stock; else a box around the part")
      ->type_name("FILE");
  AddNumber(command, "--stock-margin", how.stock_margin_mm, "Of the box, at its sides and top");
  AddNumber(command, "--stepdown", how.stepdown_mm, "Most between two levels of roughing");
  AddNumber(command, "--stepover", options.stepover_percent,
            "Between two ways of a level, % of the diameter; at most 50");
  AddNumber(command, "--allowance", how.allowance_mm, "What roughing leaves for finishing");
  AddNumber(command, "--minimum-width", how.minimum_width_mm,
            "Ways for the tip narrower than this are not roughed");
  command.add_flag("--no-finishing", options.no_finishing, "Roughing only");
  AddNumber(command, "--finish-stepdown", how.finish_stepdown_mm, "Most between two waterlines");
  AddNumber(command, "--finish-stepover", how.finish_stepover_mm, "Between parallel ways");
  AddNumber(command, "--rest-angle", how.rest_angle_deg,
            "Flatter than this the part is finished by parallel ways");
  command.add_flag("--finish-floor", how.finish_floor,
                   "Parallel ways on the stock's floor beside the part, too");
  AddNumber(command, "--sampling", how.sampling_mm, "Distance of fibers");
  AddNumber(command, "--tolerance", how.tolerance_mm, "Of all ways");
  AddNumber(command, "--bottom", how.bottom_mm, "How high above the stock's bottom the tip stays");
  command.add_flag("--open-mesh", how.open_mesh, "The part is a surface that encloses nothing");
}

void AddMachining(CLI::App& command, MillCommandOptions& options) {
  MachiningOptions& machining = options.how.machining;
  const std::map<std::string, EntryKind> entries = {
      {"helix", EntryKind::kHelix}, {"ramp", EntryKind::kRamp}, {"plunge", EntryKind::kPlunge}};
  const std::map<std::string, Coolant> coolants = {
      {"off", Coolant::kOff}, {"mist", Coolant::kMist}, {"flood", Coolant::kFlood}};
  const std::map<std::string, CutDirection> directions = {
      {"climb", CutDirection::kClimb}, {"conventional", CutDirection::kConventional}};
  const std::map<std::string, MillDialect> dialects = {{"linuxcnc", MillDialect::kLinuxCnc},
                                                       {"grbl", MillDialect::kGrbl}};
  command.add_option("--direction", machining.direction, "climb or conventional")
      ->transform(CLI::CheckedTransformer(directions));
  command.add_option("--entry", machining.entry, "helix, ramp or plunge")
      ->transform(CLI::CheckedTransformer(entries));
  command.add_option("--coolant", machining.coolant, "off, mist or flood")
      ->transform(CLI::CheckedTransformer(coolants));
  command.add_option("--dialect", options.dialect, "linuxcnc or grbl")
      ->transform(CLI::CheckedTransformer(dialects));
  AddNumber(command, "--ramp-angle", machining.ramp_angle_deg, "Of ramps and helices");
  AddNumber(command, "--helix-radius", machining.helix_radius_mm, "0: half the cutter's radius");
  AddNumber(command, "--lead-in", machining.lead_in_radius_mm, "Radius of arcs; 0: none");
  AddNumber(command, "--safe-height", machining.safe_height_mm, "Above the stock");
  AddNumber(command, "--clearance", machining.clearance_mm, "Of rapid moves over what stands");
  AddNumber(command, "--feed", machining.feed_mm_min, "mm/min");
  AddNumber(command, "--plunge-feed", machining.plunge_feed_mm_min, "mm/min, downwards");
  AddNumber(command, "--rapid", machining.rapid_mm_min, "mm/min of the machine, for times");
  command.add_option("--spindle", machining.spindle_rpm, "Turns a minute")->capture_default_str();
  command.add_option("--tool", machining.tool_number, "Its number")->capture_default_str();
  AddNumber(command, "--tool-length", machining.tool_length_mm, "Below its holder; 0: not known");
}

}  // namespace

void AddMillProgram(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("mill-program", "A program of a milling machine for a model");
  const auto options = std::make_shared<MillCommandOptions>();
  command->add_option("MODEL", options->model, "STL, OBJ or PLY, in mm")->required();
  command->add_option("-o,--output", options->output, "The G-code")->required()->type_name("FILE");
  command->add_option("--cutter", options->cutter, "As of `waterline`")
      ->capture_default_str()
      ->type_name("CUTTER");
  AddStrategy(*command, *options);
  AddMachining(*command, *options);
  command->add_option("--svg", options->svg, "A picture of one step")->type_name("FILE");
  command->add_option("--svg-step", options->svg_step, "Which")->capture_default_str();
  command->add_option("--threads", options->threads, "Threads")
      ->check(InRange(1, 1024))
      ->capture_default_str()
      ->type_name("N");
  command->footer(
      "Roughing by levels, finishing by waterlines, what is flat by parallel ways. X0 Y0 Z0 of "
      "the\n"
      "program are those of the file. Prints lengths, time, volume and places that gouge.\n"
      "Example:\n"
      "  slicefarm mill-program part.stl --cutter ball:4 --stepdown 1 -o part.nc");
  command->callback([options, &context] {
    context.run = [options] {
      const absl::Status status = Mill(*options);
      return status.ok() ? ExitCode::kOk : Fail(status);
    };
  });
}

}  // namespace slicefarm::cli
