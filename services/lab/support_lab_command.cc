#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>
#include <system_error>
#include <vector>

#include "common/geometry/measure.h"
#include "common/model/options/support_options.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/console/files.h"
#include "services/lab/commands.h"
#include "services/lab/support/lab_pictures.h"
#include "services/lab/support/lab_program.h"
#include "services/lab/support/sliced_model.h"
#include "services/planning/algo/supports/generator/support_planner.h"

namespace slicefarm::lab {
namespace {

struct SupportLabOptions {
  std::string model;
  std::string folder;
  std::string style = "organic";
  SupportOptions how;
  double layer_height_mm = 0.2;
  double gap_mm = 0.2;
  double threshold_degrees = 0;
  int every = 0;
  int threads = 1;
};

double CpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Returns the support problem of the job's only object. `job` must outlive it.
planning::SupportProblem ProblemOf(const SlicedJob& job) {
  planning::SupportProblem problem;
  static const MultiPolygon kNothing;
  for (const SlicedLayer& layer : job.layers) {
    planning::PartLayer part;
    part.top_nm = layer.frame.print_z_nm;
    part.height_nm = layer.frame.height_nm;
    part.outlines = layer.sections.empty() ? &kNothing : &OutlineOf(layer.sections[0]);
    problem.part.push_back(part);
  }
  return problem;
}

std::string Figures(const planning::SupportPlan& plan, double seconds) {
  double volume[planning::kSupportRoleCount] = {};
  for (const planning::SupportLayer& layer : plan.layers)
    for (const planning::SupportRegion& region : layer.regions)
      volume[static_cast<size_t>(region.role)] +=
          Area(region.outlines) * 1e-12 * ToMm(static_cast<double>(layer.height_nm));
  double unsupported = 0;
  int in_air = 0;
  for (const planning::SupportFinding& finding : plan.findings) {
    if (finding.kind == planning::SupportFinding::Kind::kUnsupported)
      unsupported += finding.area_mm2;
    else
      ++in_air;
  }
  return fmt::format(
      "layers {}\nbase_mm3 {:.1f}\nbranch_mm3 {:.1f}\nthick_branch_mm3 {:.1f}\n"
      "top_interface_mm3 {:.1f}\nbottom_interface_mm3 {:.1f}\nnot_carried_mm2 {:.2f}\n"
      "starts_in_air {}\ncpu_s {:.3f}\n",
      plan.layers.size(), volume[0], volume[1], volume[2], volume[3], volume[4], unsupported,
      in_air, seconds);
}

absl::Status WritePictures(const planning::SupportProblem& problem,
                           const planning::SupportPlan& plan, const SupportLabOptions& options) {
  for (const bool from_right : {false, true}) {
    const auto picture = DrawSupportView(problem, plan, from_right);
    if (!picture.ok()) return picture.status();
    const absl::Status written =
        cli::WriteFile(options.folder + (from_right ? "/right.png" : "/front.png"), *picture);
    if (!written.ok()) return written;
  }
  for (size_t i = 0; options.every > 0 && i < plan.layers.size();
       i += static_cast<size_t>(options.every)) {
    const auto picture = DrawSupportLayer(problem, plan, i);
    if (!picture.ok()) return picture.status();
    const absl::Status written =
        cli::WriteFile(fmt::format("{}/layer{:04}.png", options.folder, i), *picture);
    if (!written.ok()) return written;
  }
  return absl::OkStatus();
}

cli::ExitCode SupportLab(SupportLabOptions options) {
  SupportOptions& how = options.how;
  how.style = options.style == "grid"   ? SupportStyle::kGrid
              : options.style == "snug" ? SupportStyle::kSnug
                                        : SupportStyle::kTree;
  how.layer_height_nm = how.first_layer_height_nm = FromMm(options.layer_height_mm);
  how.top_gap_nm = how.bottom_gap_nm = FromMm(options.gap_mm);
  how.threshold_rad = options.threshold_degrees * std::numbers::pi / 180;
  const auto job = SliceModel(options.model, how.layer_height_nm, options.threads);
  if (!job.ok()) return cli::Fail(job.status());
  const planning::SupportProblem problem = ProblemOf(*job);
  const double start = CpuSeconds();
  const auto plan = planning::PlanSupports(problem, how, options.threads, CancelToken());
  const double seconds = CpuSeconds() - start;
  if (!plan.ok()) return cli::Fail(plan.status());
  if (!options.folder.empty()) {
    std::error_code ignored;
    std::filesystem::create_directories(options.folder, ignored);
    absl::Status written = cli::WriteFile(
        options.folder + "/lab.gcode",
        LabProgram(problem, *plan,
                   {.support_width_nm = how.width_nm, .spacing_nm = how.spacing_nm}));
    if (written.ok()) written = WritePictures(problem, *plan, options);
    if (!written.ok()) return cli::Fail(written);
  }
  cli::Print(Figures(*plan, seconds));
  return cli::ExitCode::kOk;
}

}  // namespace

void AddSupportLab(CLI::App& app, cli::CommandContext& context) {
  CLI::App* command = app.add_subcommand(
      "support-lab", "Plan the supports of a model only, with pictures and figures");
  const auto options = std::make_shared<SupportLabOptions>();
  command
      ->add_option("MODEL", options->model,
                   "Model: STL, OBJ or PLY, in mm; its orientation is kept")
      ->required();
  command
      ->add_option("-o,--output", options->folder,
                   "Directory for pictures and lab.gcode, which contains walls and supports")
      ->type_name("FOLDER");
  command->add_option("--style", options->style, "Style of supports")
      ->check(cli::OneOf(std::vector<std::string>{"grid", "snug", "organic"}))
      ->capture_default_str();
  command->add_option("--layer-height", options->layer_height_mm, "Height of all layers, in mm")
      ->check(cli::InRange(0.05, 1.0))
      ->capture_default_str()
      ->type_name("MM");
  command->add_option("--gap", options->gap_mm, "Contact distance above and below supports, in mm")
      ->check(cli::InRange(0.0, 5.0))
      ->capture_default_str()
      ->type_name("MM");
  command
      ->add_option("--threshold", options->threshold_degrees,
                   "Undersides less steep than this angle from horizontal are supported; 0: layers "
                   "that overhang by more than half a wall's width (organic: two thirds)")
      ->check(cli::InRange(0.0, 89.0))
      ->type_name("DEGREES");
  command
      ->add_option("--interface-layers", options->how.top_interface_layers,
                   "Number of dense layers on top")
      ->check(cli::InRange(0, 100))
      ->capture_default_str();
  command->add_flag("--build-plate-only", options->how.bed_only,
                    "Generate only supports that stand on the bed");
  command->add_option("--every", options->every, "Draw every Nth layer; 0: no layer")
      ->type_name("N");
  command->add_option("--threads", options->threads, "Number of threads")
      ->check(cli::InRange(1, 1024))
      ->capture_default_str()
      ->type_name("N");
  command->footer(
      "Prints rows: the volumes of the regions (not of the lines in them), the unsupported area, "
      "and\nthe CPU time of planning.\nExample:\n  slicefarm-lab support-lab part.stl --style "
      "organic -o lab --every 20");
  command->callback(
      [options, &context] { context.run = [options] { return SupportLab(*options); }; });
}

}  // namespace slicefarm::lab
