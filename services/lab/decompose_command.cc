#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <limits>
#include <map>
#include <memory>
#include <string>

#include "common/base/error.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/console/files.h"
#include "services/exposure/algo/decompose/decompose.h"
#include "services/exposure/algo/decompose/piece_quality.h"
#include "services/lab/commands.h"
#include "services/lab/poly_files.h"

namespace slicefarm::lab {
namespace {

struct DecomposeCommandOptions {
  std::string file;
  std::string output;
  std::string method = "bian";
};

constexpr int64_t kMaxPolyBytes = 64 << 20;

const std::map<std::string, DecomposeMethod> kMethods = {
    {"bian", DecomposeMethod::kBian},
    {"optimal", DecomposeMethod::kOptimal},
    {"approximate", DecomposeMethod::kApproximate},
    {"ymonotone", DecomposeMethod::kYMonotone}};

int DigitsOf(Coord scale) {
  int digits = 0;
  for (; scale > 1; scale /= 10) ++digits;
  return digits;
}

std::string PiecesText(const exposure::ConvexPieces& result, int decimals) {
  std::string text;
  for (const Polygon& piece : result.pieces) {
    text += std::to_string(piece.size());
    for (const Point p : piece)
      text += " " + DecimalText(p.x, decimals) + " " + DecimalText(p.y, decimals);
    text += "\n";
  }
  return text;
}

/// Returns an error with the position of crossing rings in the file's unit, which need not be mm.
absl::Status InFileUnit(const absl::Status& status, const std::string& file, int decimals) {
  const ErrorDetail detail = DetailOf(status);
  const auto x = detail.metadata.find("x_nm"), y = detail.metadata.find("y_nm");
  if (x == detail.metadata.end() || y == detail.metadata.end()) return status;
  return MakeError(status.code(), detail.reason,
                   fmt::format("{}: rings cross or overlap near {} {}", file,
                               DecimalText(std::stoll(x->second), decimals),
                               DecimalText(std::stoll(y->second), decimals)));
}

cli::ExitCode Decompose(const DecomposeCommandOptions& options) {
  const auto text = cli::ReadFile(options.file, kMaxPolyBytes);
  if (!text.ok()) return cli::Fail(text.status());
  const auto file = ParsePoly(*text);
  if (!file.ok()) return cli::Fail(file.status());
  // The file has no unit. So no absolute distance, but only the area, decides which points count as
  // collinear.
  const exposure::DecomposeOptions how = {.method = kMethods.at(options.method),
                                          .merge_nm = std::numeric_limits<double>::infinity()};
  const auto start = std::chrono::steady_clock::now();
  const auto result = exposure::Decompose(file->islands, how);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!result.ok()) return cli::Fail(InFileUnit(result.status(), options.file, file->decimals));
  const absl::Status written =
      cli::WriteFile(options.output, PiecesText(*result, file->decimals + DigitsOf(result->scale)));
  if (!written.ok()) return cli::Fail(written);
  double worst = 0, least_angle = 180;
  for (const Polygon& piece : result->pieces) {
    worst = std::max(worst, exposure::ShapeFactor(piece));
    least_angle = std::min(least_angle, exposure::LeastAngleDeg(piece));
  }
  cli::Print(fmt::format(
      "pieces {}\nreflex {}\nmin_angle_deg {:.4f}\nworst_shape {:.4f}\nseconds {:.6f}\n"
      "extra_points {}\nsharp_cuts {}\nreplaced {}\nmin_cut_angle_deg {:.4f}\nruled_cuts {}\n"
      "min_ruled_angle_deg {:.4f}\n",
      result->counts.pieces, result->counts.reflex, least_angle, worst, seconds,
      result->counts.extra_points, result->counts.sharp_cuts, result->counts.replaced,
      result->min_cut_angle_deg, result->ruled_cuts, result->min_ruled_angle_deg));
  return cli::ExitCode::kOk;
}

}  // namespace

void AddDecompose(CLI::App& app, cli::CommandContext& context) {
  CLI::App* command = app.add_subcommand("decompose", "Divide a polygon into convex pieces");
  const auto options = std::make_shared<DecomposeCommandOptions>();
  command
      ->add_option("FILE", options->file, "Polygon: a .poly file, outlines, or one `x y` per line")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "File for the pieces: one `n x y x y ...` per line")
      ->required()
      ->type_name("FILE");
  command
      ->add_option(
          "--method", options->method,
          "Method of division. bian: well-shaped pieces, by visibility and angles. optimal: fewest "
          "pieces (slow). approximate: fast. ymonotone: fast, for parts that are monotone in y")
      ->check(cli::OneOf(cli::NamesOf(kMethods)))
      ->capture_default_str()
      ->type_name("NAME");
  command->footer(
      "Prints rows: `worst_shape` is the largest perimeter^2 / (4 pi area) of a piece, 1 for a "
      "disc;\n`extra_points` are ends of cuts that are not corners; `replaced` counts outlines "
      "that Bian's\nmethod has cut because the requested one cannot. Bian's rule of 30 degrees "
      "applies where a cut\nends in a convex corner: `ruled_cuts` counts these cuts, "
      "`min_ruled_angle_deg` is the smallest\nangle there. `sharp_cuts` have an angle below 30 "
      "degrees at the end where the rule does not\napply. Pieces have the unit of the "
      "file.\nExample:\n  slicefarm-lab decompose texas.poly -o pieces.txt");
  command->callback(
      [options, &context] { context.run = [options] { return Decompose(*options); }; });
}

}  // namespace slicefarm::lab
