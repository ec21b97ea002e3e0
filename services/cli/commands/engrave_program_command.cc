#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/base/parallel.h"
#include "common/model/engraving/engrave_report.h"
#include "services/cli/choice_option.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console.h"
#include "services/cli/files.h"
#include "services/cli/models/surface_mesh.h"
#include "services/cli/render/surface_picture.h"
#include "services/texture/algo/map/distortion.h"
#include "services/texture/algo/map/flatten.h"
#include "services/texture/algo/output/csv_text.h"
#include "services/texture/algo/output/displaced_mesh.h"
#include "services/texture/algo/output/engrave_program.h"
#include "services/texture/algo/output/engrave_report.h"
#include "services/texture/algo/pattern/computed_heights.h"
#include "services/texture/algo/pattern/texture_file.h"
#include "services/texture/algo/surface/seam.h"

namespace slicefarm::cli {
namespace {

constexpr int64_t kMaxTextureBytes = 512 << 20;
using Clock = std::chrono::steady_clock;

struct EngraveCommandOptions {
  std::string surface;
  std::string texture = "bumps";
  std::string mask;
  std::string output;
  std::string displaced;
  std::string picture;
  std::string map_picture;
  std::string report;
  std::vector<double> anchor, direction, pitch, centre;
  std::vector<double> spacings = {0.1}, angles = {0};
  double displaced_edge_mm = 0.2;
  int threads = 1;
  bool no_seam = false, interpolated = false, separate = false, once = false;
  texture::TextureFileOptions file;
  texture::EngraveOptions how;
  texture::ProgramOptions program;
};

std::optional<Eigen::Vector3d> VectorOf(const std::vector<double>& xyz) {
  if (xyz.empty()) return std::nullopt;
  return Eigen::Vector3d(xyz[0], xyz[1], xyz[2]);
}

texture::EngraveOptions EngraveOptionsOf(const EngraveCommandOptions& options) {
  texture::EngraveOptions how = options.how;
  how.placement.anchor_mm = VectorOf(options.anchor);
  how.placement.direction = VectorOf(options.direction);
  how.placement.repeat = !options.once;
  how.placement.middle = options.once;
  how.connect = !options.separate;
  if (options.interpolated) how.normals = NormalKind::kInterpolated;
  how.lines.clear();
  for (size_t i = 0; i < std::max(options.spacings.size(), options.angles.size()); ++i)
    how.lines.push_back(
        {options.spacings[i % options.spacings.size()], options.angles[i % options.angles.size()]});
  return how;
}

absl::StatusOr<texture::Texture> ReadTexture(const EngraveCommandOptions& options) {
  if (texture::LooksLikeTextureSpec(options.texture)) {
    const auto spec = texture::ParseTextureSpec(options.texture);
    if (!spec.ok()) return spec.status();
    auto heights = texture::ComputedHeights(*spec);
    if (!heights.ok()) return heights.status();
    return texture::TextureOf(*std::move(heights));
  }
  texture::TextureFileOptions how = options.file;
  for (size_t i = 0; i < options.pitch.size() && i < 2; ++i) how.pitch_mm[i] = options.pitch[i];
  if (options.texture.find(':') != std::string::npos)
    return texture::ParseTextureSpec(options.texture).status();
  const auto is_mesh = [&](std::string_view end) { return options.texture.ends_with(end); };
  if (is_mesh(".stl") || is_mesh(".STL") || is_mesh(".obj") || is_mesh(".ply")) {
    auto solid = ReadSurface(options.texture);
    if (!solid.ok()) return solid.status();
    return texture::TextureOf(*std::move(solid), how.pitch_mm);
  }
  const auto bytes = ReadFile(options.texture, kMaxTextureBytes);
  if (!bytes.ok()) return bytes.status();
  auto made = texture::TextureOfFile(*bytes, how);
  return made.ok() ? std::move(made) : InFile(options.texture, made.status());
}

absl::StatusOr<texture::SurfaceMap> MapOf(const EngraveCommandOptions& options) {
  const auto mesh = ReadSurface(options.surface);
  if (!mesh.ok()) return mesh.status();
  const auto topology = texture::TopologyOf(*mesh);
  if (!topology.ok()) return InFile(options.surface, topology.status());
  const auto seam =
      options.no_seam ? std::vector<texture::SeamEdge>() : texture::SeamOf(*mesh, *topology);
  texture::OpenedSurface opened = texture::CutOpen(*mesh, seam);
  auto map = texture::Flatten(opened.mesh);
  if (!map.ok()) return InFile(options.surface, map.status());
  return texture::SurfaceMap(std::move(opened), std::move(map->points_mm));
}

absl::StatusOr<texture::EngravePlan> PlanOf(const EngraveCommandOptions& options) {
  auto texture = ReadTexture(options);
  if (!texture.ok()) return texture.status();
  std::optional<texture::HeightGrid> mask;
  if (!options.mask.empty()) {
    const auto bytes = ReadFile(options.mask, kMaxTextureBytes);
    if (!bytes.ok()) return bytes.status();
    auto read = texture::ImageHeights(*bytes, {.height_mm = 1});
    if (!read.ok()) return InFile(options.mask, read.status());
    mask = *std::move(read);
  }
  auto map = MapOf(options);
  if (!map.ok()) return map.status();
  return texture::PlanEngraving(*std::move(map), *std::move(texture), std::move(mask),
                                EngraveOptionsOf(options));
}

std::string CsvOf(const std::vector<texture::LayerPath>& paths) {
  std::string text = texture::kCsvHeader;
  for (const texture::LayerPath& path : paths) text += texture::CsvRows(path);
  return text;
}

absl::StatusOr<std::string> ProgramOf(const EngraveCommandOptions& options,
                                      const texture::EngravePlan& plan,
                                      const std::vector<texture::LayerPath>& paths,
                                      ProgramFacts* facts) {
  texture::ProgramOptions how = options.program;
  how.axes.centre_mm = VectorOf(options.centre).value_or(Eigen::Vector3d::Zero());
  how.layer_mm = plan.texture.height_mm / plan.layer_count();
  texture::EngraveProgram program(how, texture::SafeHeight(plan, how));
  std::string text = program.Start();
  for (const texture::LayerPath& path : paths) {
    const auto layer = program.Layer(path);
    if (!layer.ok()) return layer.status();
    text += *layer;
  }
  *facts = program.facts();
  return text + program.End();
}

/// Layer by layer on several threads; in the order of work.
absl::StatusOr<std::vector<texture::LayerPath>> PathsOf(const texture::EngravePlan& plan,
                                                        int threads) {
  // Each thread makes a stretch of layers, so that it finds the lines of a style once.
  const int32_t layers = plan.layer_count(), parts = std::min(threads, layers);
  std::vector<absl::StatusOr<std::vector<texture::LayerPath>>> made(parts);
  ForEachIndex(threads, parts, [&](size_t i, int /*worker*/) {
    const auto part = static_cast<int32_t>(i);
    made[i] = texture::LayerPaths(plan, layers * part / parts, layers * (part + 1) / parts);
  });
  std::vector<texture::LayerPath> paths;
  for (auto& part : made) {
    if (!part.ok()) return part.status();
    std::move(part->begin(), part->end(), std::back_inserter(paths));
  }
  return paths;
}

/// Every line that is worked, and the links between; of all layers.
std::vector<PictureLine> LinesToDraw(const std::vector<texture::LayerPath>& paths) {
  std::vector<PictureLine> lines;
  for (size_t k = 0; k < paths.size(); ++k) {
    const auto& points = paths[k].points;
    const double shade = (static_cast<double>(k) + 1) / static_cast<double>(paths.size());
    for (size_t i = 1; i < points.size(); ++i)
      if (points[i].on)
        lines.push_back({points[i - 1].place_mm, points[i].place_mm, points[i].normal, shade});
  }
  return lines;
}

absl::Status WritePictures(const EngraveCommandOptions& options, const texture::EngravePlan& plan,
                           const std::vector<texture::LayerPath>& paths) {
  const texture::SurfaceMesh& mesh = plan.map.mesh();
  if (!options.picture.empty()) {
    const auto png = DrawSurface(mesh, LinesToDraw(paths), {});
    if (!png.ok()) return png.status();
    if (absl::Status status = WriteFile(options.picture, *png); !status.ok()) return status;
  }
  if (options.map_picture.empty()) return absl::OkStatus();
  std::vector<double> energies;
  for (const auto& [a, b, c] : mesh.triangles)
    energies.push_back(texture::SymmetricDirichlet(texture::JacobianOf(
                           texture::RestOf(mesh.points_mm[a], mesh.points_mm[b], mesh.points_mm[c]),
                           plan.map.map_mm()[a], plan.map.map_mm()[b], plan.map.map_mm()[c])) /
                       4);
  const auto png = DrawMap(mesh, plan.map.map_mm(), energies, 3, 1200);
  if (!png.ok()) return png.status();
  return WriteFile(options.map_picture, *png);
}

absl::Status WriteDisplaced(const EngraveCommandOptions& options,
                            const texture::EngravePlan& plan) {
  if (options.displaced.empty()) return absl::OkStatus();
  const auto mesh = texture::DisplacedMesh(plan, {options.displaced_edge_mm});
  if (!mesh.ok()) return mesh.status();
  return WriteFile(options.displaced, options.displaced.ends_with(".obj")
                                          ? texture::ObjText(*mesh)
                                          : texture::StlBytes(*mesh));
}

double Since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// How long it took.
struct EngraveTimes {
  double map_s = 0;
  double path_s = 0;
};

void PrintFigures(const EngraveReport& report, const EngraveTimes& times) {
  double on = 0, off = 0;
  int64_t points = 0;
  for (const LayerNumbers& layer : report.layers) {
    on += layer.on_mm;
    off += layer.off_mm;
    points += layer.points;
  }
  const MapReport& map = report.map;
  Print(
      fmt::format("faces {}\nlayers {}\nenergy_mean_over_4 {:.6f}\nline_distance_mm {:.4f} {:.4f} "
                  "{:.4f}\nline_even {:.4f}\npoints {}\non_mm {:.1f}\noff_mm {:.1f}\n"
                  "map_seconds {:.3f}\npath_seconds {:.3f}\n",
                  map.faces, report.layers.size(), map.energy_mean, map.line_distance_mm.p1,
                  map.line_distance_mm.p50, map.line_distance_mm.p99, map.line_even, points, on,
                  off, times.map_s, times.path_s));
}

absl::Status Engrave(const EngraveCommandOptions& options) {
  const auto start = Clock::now();
  const auto plan = PlanOf(options);
  if (!plan.ok()) return plan.status();
  EngraveReport report;
  EngraveTimes times{.map_s = Since(start)};
  const auto paths = PathsOf(*plan, options.threads);
  if (!paths.ok()) return paths.status();
  times.path_s = Since(start) - times.map_s;
  const auto text = options.output.ends_with(".csv")
                        ? absl::StatusOr<std::string>(CsvOf(*paths))
                        : ProgramOf(options, *plan, *paths, &report.program);
  if (!text.ok()) return text.status();
  const auto map = texture::MapReportOf(*plan);
  if (!map.ok()) return map.status();
  report.map = *map;
  for (const texture::LayerPath& path : *paths) report.layers.push_back(texture::NumbersOf(path));
  absl::Status written = WriteFile(options.output, *text);
  written.Update(WriteDisplaced(options, *plan));
  written.Update(WritePictures(options, *plan, *paths));
  if (!options.report.empty()) written.Update(WriteFile(options.report, JsonOf(report).dump(2) + "\n"));
  if (!written.ok()) return written;
  Warn(WarningsOf(report.map, report.layers));
  PrintFigures(report, times);
  return absl::OkStatus();
}

void AddNumberTo(CLI::App& command, const std::string& name, double& value,
                 const std::string& help) {
  command.add_option(name, value, help)->capture_default_str()->type_name("N");
}

void AddNumbers(CLI::App& command, const std::string& name, std::vector<double>& values,
                const std::string& help) {
  command.add_option(name, values, help)->delimiter(',')->type_name("N,...");
}

void AddVector(CLI::App& command, const std::string& name, std::vector<double>& xyz,
               const std::string& help) {
  command.add_option(name, xyz, help)->delimiter(',')->expected(3)->type_name("X,Y,Z");
}

void AddTextureOptions(CLI::App& command, EngraveCommandOptions& options) {
  std::string kinds;
  for (const texture::TextureKindInfo& info : texture::kTextureKinds)
    kinds += (kinds.empty() ? "" : ", ") + std::string(info.name);
  command
      .add_option("--texture", options.texture,
                  "A planar solid (STL, OBJ, PLY), a height image (PNG), or one of " + kinds +
                      ", as kind:key=value,...")
      ->capture_default_str();
  AddNumberTo(command, "--texture-width", options.file.image.width_mm, "Of a height image, mm");
  AddNumberTo(command, "--texture-height", options.file.image.height_mm, "Of its white, mm");
  AddNumbers(command, "--texture-pitch", options.pitch, "Of a solid's repetitions, mm: X,Y");
  AddNumberTo(command, "--scale", options.how.placement.scale, "Of the texture's width and length");
  AddVector(command, "--anchor", options.anchor, "Where on the surface the texture's origin lies");
  AddVector(command, "--orient", options.direction, "Along which its x runs there");
  AddNumberTo(command, "--turn", options.how.placement.turn_deg, "Further, degrees");
  command.add_flag("--once", options.once, "One tile, its middle at the anchor");
  command.add_option("--mask", options.mask, "PNG over the map's box: works where it is bright");
  AddNumberTo(command, "--margin", options.how.margin_mm,
              "To the surface's boundary, mm of the map");
  command.add_flag("--engraved", options.how.engraved, "Into the surface, not onto it");
  command.add_flag("--outside", options.how.outside, "Work what is not the texture");
}

void AddLineOptions(CLI::App& command, EngraveCommandOptions& options) {
  AddNumberTo(command, "--layer-height", options.how.layer_height_mm, "mm");
  AddNumbers(command, "--spacing", options.spacings, "Of lines, mm; of layer after layer");
  AddNumbers(command, "--angle", options.angles,
             "Of lines to the texture's x; of layer after layer");
  command.add_flag("--equidistant", options.how.equidistant,
                   "Lines bend to lie as far apart on the surface as asked");
  command.add_flag("--interpolated", options.interpolated, "Normals between those of vertices");
  command.add_flag("--separate", options.separate, "Lines are not joined at their ends");
  AddNumberTo(command, "--clearance", options.how.clearance_mm, "Of links, mm; 0: at their layer");
  AddNumberTo(command, "--shortest", options.how.least_run_mm, "Lines left out, mm");
  command.add_flag("--no-seam", options.no_seam, "Refuse a surface that has to be cut");
}

void AddProgramOptions(CLI::App& command, EngraveCommandOptions& options) {
  texture::ProgramOptions& program = options.program;
  command.add_option("--axes", program.axes.layout, "What turns, besides X, Y and Z")
      ->transform(OneOf<AxisLayout>({{"none", AxisLayout::kNone},
                                              {"table-ab", AxisLayout::kTableAb},
                                              {"table-bc", AxisLayout::kTableBc},
                                              {"head-ab", AxisLayout::kHeadAb},
                                              {"head-bc", AxisLayout::kHeadBc}}));
  command.add_option("--tool", program.tool, "What works")
      ->transform(OneOf<ToolKind>({{"beam", ToolKind::kBeam},
                                            {"spindle", ToolKind::kSpindle},
                                            {"extruder", ToolKind::kExtruder}}));
  AddVector(command, "--centre", options.centre, "Where a table's axes meet; else the origin");
  AddNumberTo(command, "--pivot", program.axes.pivot_mm, "From a head's axes to the tip, mm");
  AddNumberTo(command, "--tilt", program.axes.tilt_deg, "Most of A and B, degrees either way");
  AddNumberTo(command, "--steepest", program.steepest_deg, "Of the surface, without such axes");
  AddNumberTo(command, "--power", program.power, "S: of a beam, or turns a minute");
  AddNumberTo(command, "--feed", program.feed_mm_min, "mm/min over the surface");
  AddNumberTo(command, "--link-feed", program.link_mm_min, "mm/min between lines");
  AddNumberTo(command, "--turn-feed", program.turn_deg_min, "Most degrees/min of an axis");
}

}  // namespace

void AddEngraveProgram(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("engrave-program", "Tool paths of a texture over a curved surface");
  const auto options = std::make_shared<EngraveCommandOptions>();
  command->add_option("SURFACE", options->surface, "OBJ, PLY or STL, in mm: one part")->required();
  command->add_option("-o,--output", options->output, "Points (.csv), or a program")
      ->required()
      ->type_name("OUT.csv|OUT.nc");
  AddTextureOptions(*command, *options);
  AddLineOptions(*command, *options);
  AddProgramOptions(*command, *options);
  command->add_option("--report", options->report, "JSON: distortion, spacing, lengths by layer");
  command->add_option("--threads", options->threads, "How many to use; the result is the same")
      ->check(InRange(1, 256))
      ->capture_default_str();
  command->add_option("--displaced", options->displaced, "The surface with the texture (STL, OBJ)");
  AddNumberTo(*command, "--displaced-edge", options->displaced_edge_mm, "Its longest edge, mm");
  command->add_option("--picture", options->picture, "PNG of the paths over the surface");
  command->add_option("--map-picture", options->map_picture, "PNG of the map and its distortion");
  command->footer(
      "The surface is laid flat (`flatten`), the texture is sliced in layers there, and lines over "
      "each\n"
      "layer are lifted onto the surface again.\n"
      "Example:\n"
      "  slicefarm engrave-program mask.obj --texture knurl:pitch=2,height=0.3 --spacing 0.1 -o "
      "paths.csv");
  command->callback([options, &context] {
    context.run = [options] {
      const absl::Status status = Engrave(*options);
      return status.ok() ? ExitCode::kOk : Fail(status);
    };
  });
}

}  // namespace slicefarm::cli
