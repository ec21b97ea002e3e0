#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/console/files.h"
#include "services/lab/bead_files.h"
#include "services/lab/bead_maker.h"
#include "services/lab/commands.h"

namespace slicefarm::lab {
namespace {

namespace fs = std::filesystem;

struct BeadsOptions {
  std::string outlines;
  std::string output;
  BeadMakerOptions beads;
  int threads = 1;
};

absl::Status MakeFile(const BeadMaker& maker, const fs::path& from, const fs::path& to,
                      BeadTotals& totals) {
  const auto islands = ReadOutlines(from);
  if (!islands.ok()) return islands.status();
  return cli::WriteFile(to.string(), PrintBeads(maker.Make(*islands, totals)));
}

cli::ExitCode Beads(const BeadsOptions& options) {
  const auto files = OutlineFiles(options.outlines);
  if (!files.ok()) return cli::Fail(files.status());
  std::error_code error;
  fs::create_directories(options.output, error);
  const BeadMaker maker(options.beads);
  std::atomic<size_t> next = 0;
  std::mutex mutex;
  BeadTotals all;
  absl::Status status;
  const auto work = [&] {
    BeadTotals own;
    absl::Status failed;
    for (size_t i = next++; i < files->size() && failed.ok(); i = next++)
      failed = MakeFile(maker, (*files)[i], fs::path(options.output) / (*files)[i].filename(), own);
    const std::lock_guard lock(mutex);
    status.Update(failed);
    all.outlines += own.outlines;
    all.fallbacks += own.fallbacks;
    all.seconds += own.seconds;
    all.diagram_s += own.diagram_s;
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < options.threads; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (!status.ok()) return cli::Fail(status);
  cli::Print(fmt::format("outlines {}\nseconds {:.3f}\nvoronoi_seconds {:.3f}\nfallbacks {}\n",
                         all.outlines, all.seconds, all.diagram_s, all.fallbacks));
  return cli::ExitCode::kOk;
}

}  // namespace

void AddBeads(CLI::App& app, cli::CommandContext& context) {
  CLI::App* command = app.add_subcommand("beads", "Make walls of variable width for outlines");
  const auto options = std::make_shared<BeadsOptions>();
  command
      ->add_option("DIR_OF_OUTLINES", options->outlines,
                   "Directory of .txt files with outlines, in mm")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "Directory for the beads, in files of the same names")
      ->required()
      ->type_name("DIR");
  command->add_option("--width", options->beads.width_mm, "Extrusion width of the walls, in mm")
      ->check(cli::InRange(0.01, 10.0))
      ->capture_default_str()
      ->type_name("MM");
  command
      ->add_option("--min-feature", options->beads.min_feature_mm,
                   "Thickness below which parts of an outline get no wall, in mm")
      ->check(cli::InRange(0.001, 10.0))
      ->capture_default_str()
      ->type_name("MM");
  command
      ->add_option("--transition-angle", options->beads.transition_angle,
                   "Angle between opposite sides below which walls of variable width fill the "
                   "wedge, in degrees")
      ->check(cli::InRange(1.0, 89.0))
      ->capture_default_str()
      ->type_name("DEGREES");
  command
      ->add_option("--walls", options->beads.walls,
                   "Number of walls on either side; 0: as many as fill the part")
      ->check(cli::InRange(0, 1000))
      ->capture_default_str()
      ->type_name("N");
  command
      ->add_option("--threads", options->threads, "Number of outlines processed at the same time")
      ->check(cli::InRange(1, 256))
      ->capture_default_str()
      ->type_name("N");
  command->footer(
      "Format of an outline: two unused numbers, then rings: number of points, x and y of "
      "each.\nFormat of a bead: inset, 1 along the middle, 1 closed, number of points, x, y and "
      "width of each.\nPrints times: `seconds` is the sum over all threads without file access, "
      "`voronoi_seconds` the part\nspent in Voronoi diagrams; `fallbacks` counts islands with "
      "walls of constant width instead.\nExample:\n  slicefarm-lab beads outlines -o beads --width "
      "0.5 --min-feature 0.3 --transition-angle 45");
  command->callback([options, &context] { context.run = [options] { return Beads(*options); }; });
}

}  // namespace slicefarm::lab
