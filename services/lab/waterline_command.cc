#include <fmt/core.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "common/model/options/cutter_text.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/console/files.h"
#include "services/lab/commands.h"
#include "services/lab/mill_mesh.h"
#include "services/milling/algo/waterline/waterline.h"

namespace slicefarm::lab {
namespace {

struct WaterlineCommandOptions {
  std::string model;
  std::string output;
  std::string cutter;
  std::vector<double> levels_mm;
  milling::WaterlineOptions how;
};

using WaterlineLevels = std::vector<std::vector<milling::WaterlineLoop>>;

std::string LoopsText(const WaterlineLevels& levels) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (const auto& loops : levels) {
    for (const milling::WaterlineLoop& loop : loops) {
      fmt::format_to(out, "{} {}", loop.z_mm, loop.points_mm.size());
      for (const Eigen::Vector2d& p : loop.points_mm)
        fmt::format_to(out, " {:.9f} {:.9f}", p.x(), p.y());
      text.push_back('\n');
    }
  }
  return fmt::to_string(text);
}

cli::ExitCode Waterline(const WaterlineCommandOptions& options) {
  const auto cutter = ParseCutter(options.cutter);
  if (!cutter.ok()) return cli::Fail(cutter.status());
  const auto mesh = ReadTriangles(options.model);
  if (!mesh.ok()) return cli::Fail(mesh.status());
  const auto start = std::chrono::steady_clock::now();
  const auto levels = milling::Waterlines(*mesh, *cutter, options.levels_mm, options.how);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!levels.ok()) return cli::Fail(levels.status());
  const absl::Status written = cli::WriteFile(options.output, LoopsText(*levels));
  if (!written.ok()) return cli::Fail(written);
  size_t loops = 0, outer = 0, points = 0;
  for (const auto& level : *levels) {
    for (const milling::WaterlineLoop& loop : level) {
      ++loops;
      outer += loop.outer ? 1 : 0;
      points += loop.points_mm.size();
    }
  }
  cli::Print(fmt::format("levels {}\nloops {}\nouter_loops {}\npoints {}\nseconds {:.6f}\n",
                         levels->size(), loops, outer, points, seconds));
  return cli::ExitCode::kOk;
}

}  // namespace

void AddWaterline(CLI::App& app, cli::CommandContext& context) {
  CLI::App* command = app.add_subcommand(
      "waterline", "Compute toolpaths of a milling cutter around a model, level by level");
  const auto options = std::make_shared<WaterlineCommandOptions>();
  command->add_option("MODEL", options->model, "Model: STL, OBJ or PLY, in mm")->required();
  command
      ->add_option("-o,--output", options->output,
                   "File for the loops: one `z n x y x y ...` per line, closed without repeating "
                   "the first point")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--cutter", options->cutter,
                   "Cutter: cyl:D, ball:D, bull:D:CORNER, cone:D:ANGLE, ballcone:TIP:ANGLE:D, "
                   "bullcone:TIP:CORNER:ANGLE:D or conecone:TIP:TIP_ANGLE:ANGLE:D; diameters and "
                   "corner radii in mm, half angles in degrees")
      ->required()
      ->type_name("CUTTER");
  command->add_option("--z", options->levels_mm, "Heights of the cutter's tip, in mm")
      ->required()
      ->delimiter(',')
      ->type_name("MM,...");
  command
      ->add_option("--sampling", options->how.sampling_mm,
                   "Distance between sampling lines (fibers), in mm")
      ->capture_default_str()
      ->type_name("MM");
  command
      ->add_option("--tolerance", options->how.tolerance_mm,
                   "Deviation from a chord beyond which a point is inserted into a loop, in mm; 0: "
                   "none is inserted")
      ->capture_default_str()
      ->type_name("MM");
  command
      ->add_option("--least-sampling", options->how.least_sampling_mm,
                   "Smallest distance between inserted points, in mm")
      ->capture_default_str()
      ->type_name("MM");
  command->add_option("--threads", options->how.threads, "Number of threads")
      ->check(cli::InRange(1, 1024))
      ->capture_default_str()
      ->type_name("N");
  command->footer(
      "The cutter touches the model at every point of a loop; its tip must not enter the loop. "
      "Outer\nloops run counter-clockwise, inner loops clockwise.\nExample:\n  slicefarm-lab "
      "waterline part.stl --cutter ball:4 --z 1.5,2.0 --sampling 0.2 -o loops.txt");
  command->callback(
      [options, &context] { context.run = [options] { return Waterline(*options); }; });
}

}  // namespace slicefarm::lab
