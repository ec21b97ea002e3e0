#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/base/text.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/options/fill_patterns.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/console/files.h"
#include "services/infill/algo/quality/fill_quality.h"
#include "services/infill/algo/solid.h"
#include "services/infill/algo/sparse.h"
#include "services/lab/bead_files.h"
#include "services/lab/commands.h"
#include "services/lab/fill_files.h"

namespace slicefarm::lab {
namespace {

namespace fs = std::filesystem;

/// Layer height at which beads have square sides, so that the width of a bead equals the width that
/// it fills.
constexpr Coord kFlatHeightNm = 1;
/// Conductivities of PLA and air, with which the conductivity of the infill is calculated.
constexpr double kPlasticWmK = 0.2;
constexpr double kAirWmK = 0.026;

struct FillOptions {
  std::string outlines;
  std::string output;
  std::string pattern = "grid";
  std::string density = "20%";
  double width_mm = 0.45;
  double angle_degrees = 45;
  double z_mm = 0.1;
  int layer = 0;
  bool quality = false;
};

/// Figures in the printed rows, summed over all outlines.
struct FillTotals {
  int64_t outlines = 0;
  int64_t components = 0;
  int64_t paths = 0;
  double length_mm = 0;
  double longest_mm = 0;
  double area_mm2 = 0;
  double seconds = 0;
  infill::FillQuality quality;  ///< shares weighted by area, isotropy by length
};

/// Reads `20%` or `0.2` as a fraction of 1.
std::optional<double> ReadDensity(std::string_view text) {
  const bool percent = text.ends_with('%');
  if (percent) text.remove_suffix(1);
  const std::optional<double> number = ToNumber(text);
  if (!number) return std::nullopt;
  const double share = percent ? *number / 100 : *number;
  return share > 0 && share <= 1 ? std::optional(share) : std::nullopt;
}

const FillPatternInfo* FindPattern(const std::string& name) {
  for (const FillPatternInfo& info : kFillPatterns)
    if (info.name == name) return &info;
  return nullptr;
}

std::string PatternNames() {
  std::string names;
  for (const FillPatternInfo& info : kFillPatterns)
    if (!info.planned) names += (names.empty() ? "" : ", ") + std::string(info.name);
  return names;
}

absl::StatusOr<std::vector<Path>> SolidPaths(const MultiPolygon& islands,
                                             const infill::SolidFill& fill) {
  std::vector<Path> paths;
  for (const PolygonWithHoles& island : islands) {
    auto group = infill::FillSolid(island, fill);
    if (!group.ok()) return group.status();
    std::move(group->paths.begin(), group->paths.end(), std::back_inserter(paths));
  }
  return paths;
}

absl::StatusOr<std::vector<Path>> PathsIn(const MultiPolygon& islands, FillPattern pattern,
                                          double density, const FillOptions& options) {
  const double angle = options.angle_degrees * std::numbers::pi / 180;
  const Coord width = FromMm(options.width_mm);
  if (density >= 1 && InfoOf(pattern).solid != SolidFillStyle::kNone) {
    return SolidPaths(islands, {.pattern = pattern,
                                .angle_rad = angle,
                                .width_nm = width,
                                .height_nm = kFlatHeightNm,
                                .layer = options.layer});
  }
  return infill::FillSparse(islands, {.pattern = pattern,
                                      .density = density,
                                      .angle_rad = angle,
                                      .layer = options.layer,
                                      .z_nm = FromMm(options.z_mm),
                                      .width_nm = width,
                                      .height_nm = kFlatHeightNm,
                                      .anchor_nm = 6 * width,
                                      .anchor_max_nm = 50 * kNmPerMm});
}

void AddQuality(const MultiPolygon& islands, const std::vector<Path>& paths,
                const FillOptions& options, infill::FillQuality& all) {
  const auto one = infill::QualityOf(islands, paths, kFlatHeightNm, FromMm(options.width_mm));
  const double area = Area(islands) / kNmPerMm / kNmPerMm;
  all.got += one.got * area;
  all.covered += one.covered * area;
  all.travel_mm += one.travel_mm;
  all.isotropy += one.isotropy * one.length_mm;
  all.locality = std::max(all.locality, one.locality);
}

absl::Status FillFile(const fs::path& from, const fs::path& to, FillPattern pattern, double density,
                      const FillOptions& options, FillTotals& totals) {
  const auto islands = ReadOutlines(from);
  if (!islands.ok()) return islands.status();
  const auto start = std::chrono::steady_clock::now();
  const auto paths = PathsIn(*islands, pattern, density, options);
  totals.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!paths.ok()) return paths.status();
  ++totals.outlines;
  totals.components += std::ssize(FastOffset(*islands, -FromMm(options.width_mm / 2)));
  totals.paths += std::ssize(*paths);
  totals.area_mm2 += Area(*islands) / kNmPerMm / kNmPerMm;
  for (const Path& path : *paths) {
    const double length = ToMm(PathLength(path));
    totals.length_mm += length;
    totals.longest_mm = std::max(totals.longest_mm, length);
  }
  if (options.quality) AddQuality(*islands, *paths, options, totals.quality);
  return cli::WriteFile(to.string(), PrintFill(*paths));
}

/// Returns part / whole; 0 if `whole` is 0.
double Ratio(double part, double whole) { return whole > 0 ? part / whole : 0; }

std::string QualityRows(const FillTotals& all, double asked) {
  const infill::FillQuality& quality = all.quality;
  const double got = Ratio(quality.got, all.area_mm2);
  const infill::PropertyBounds stiffness = infill::StiffnessBounds(std::min(1.0, got));
  const infill::PropertyBounds heat =
      infill::ConductivityBounds(std::min(1.0, got), kPlasticWmK, kAirWmK);
  return fmt::format(
      "density_asked {:.5f}\ndensity_got {:.5f}\ncovered {:.5f}\ntravel_mm {:.1f}\n"
      "isotropy {:.4f}\nlocality {:.3f}\nstiffness_least {:.5f}\nstiffness_most {:.5f}\n"
      "conductivity_least_w_mk {:.5f}\nconductivity_most_w_mk {:.5f}\n",
      asked, got, Ratio(quality.covered, all.area_mm2), quality.travel_mm,
      Ratio(quality.isotropy, all.length_mm), quality.locality, stiffness.least, stiffness.most,
      heat.least, heat.most);
}

cli::ExitCode Fill(const FillOptions& options) {
  const FillPatternInfo* info = FindPattern(options.pattern);
  if (info == nullptr) {
    return cli::Fail(MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
        fmt::format("no pattern is named {}; there are: {}", options.pattern, PatternNames())));
  }
  if (info->planned) {
    return cli::Fail(MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
        fmt::format("{} is planned over all layers of a part: use slicefarm slice", info->name)));
  }
  const std::optional<double> density = ReadDensity(options.density);
  if (!density) {
    return cli::Fail(
        MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                  fmt::format("--density {}: must be above 0 and at most 100%", options.density)));
  }
  const auto files = OutlineFiles(options.outlines);
  if (!files.ok()) return cli::Fail(files.status());
  std::error_code error;
  fs::create_directories(options.output, error);
  FillTotals all;
  for (const fs::path& file : *files) {
    const absl::Status status = FillFile(file, fs::path(options.output) / file.filename(),
                                         info->pattern, *density, options, all);
    if (!status.ok()) return cli::Fail(status);
  }
  cli::Print(
      fmt::format("outlines {}\ncomponents {}\npaths {}\npaths_per_component {:.3f}\n"
                  "length_mm {:.1f}\nlongest_path_mm {:.1f}\narea_mm2 {:.1f}\n"
                  "density_by_length {:.5f}\nseconds {:.3f}\n",
                  all.outlines, all.components, all.paths,
                  Ratio(static_cast<double>(all.paths), static_cast<double>(all.components)),
                  all.length_mm, all.longest_mm, all.area_mm2,
                  Ratio(all.length_mm * options.width_mm, all.area_mm2), all.seconds));
  if (options.quality) cli::Print(QualityRows(all, *density));
  return cli::ExitCode::kOk;
}

}  // namespace

void AddFill(CLI::App& app, cli::CommandContext& context) {
  CLI::App* command = app.add_subcommand("fill", "Fill outlines with any infill pattern");
  const auto options = std::make_shared<FillOptions>();
  command
      ->add_option("DIR_OF_OUTLINES", options->outlines,
                   "Directory of .txt files with outlines, in mm")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "Directory for the paths, in files of the same names")
      ->required()
      ->type_name("DIR");
  command->add_option("--pattern", options->pattern, "Pattern, with the names of fill_pattern")
      ->capture_default_str()
      ->type_name("NAME");
  command
      ->add_option("--density", options->density,
                   "Density, 20% or 0.2; 100%: solid, if the pattern supports it")
      ->capture_default_str()
      ->type_name("D");
  command->add_option("--width", options->width_mm, "Extrusion width, in mm")
      ->check(cli::InRange(0.01, 10.0))
      ->capture_default_str()
      ->type_name("MM");
  command
      ->add_option("--angle", options->angle_degrees,
                   "Direction of the lines, as fill_angle, in degrees")
      ->check(cli::InRange(-360.0, 360.0))
      ->capture_default_str()
      ->type_name("DEGREES");
  command
      ->add_option("--z", options->z_mm,
                   "Height above the bed, in mm, for patterns that change with it")
      ->check(cli::InRange(0.0, 1000.0))
      ->capture_default_str()
      ->type_name("MM");
  command
      ->add_option("--layer", options->layer,
                   "Number of the layer, for patterns that turn from layer to layer")
      ->check(cli::InRange(0, 1'000'000))
      ->capture_default_str()
      ->type_name("N");
  command->add_flag("--quality", options->quality,
                    "Report material, coverage, travel, isotropy and locality too, and bounds of "
                    "stiffness and conductivity");
  command->footer(
      "Format of an outline: two unused numbers, then rings: number of points, x and y of "
      "each.\nFormat of a path: number of points, x and y of each; one path per line.\nPrints rows "
      "over all outlines: `components` are pieces of the region half a width "
      "inside,\n`density_by_length` is length times width by area, links and anchors at their full "
      "width.\n--quality: `density_got` is the material relative to a solid filling; `isotropy` is "
      "1 for equal\nlength in all directions, 0 for one direction; `locality` is the largest |p - "
      "q|^2 / path between, in widths;\nstiffness is a share of the material's, conductivity is "
      "for PLA (0.2 W/mK) in air (0.026).\nExample:\n  slicefarm-lab fill outlines -o paths "
      "--pattern gyroid --density 20%");
  command->callback([options, &context] { context.run = [options] { return Fill(*options); }; });
}

}  // namespace slicefarm::lab
