#include <fmt/core.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "services/cli/console/console.h"
#include "services/cli/console/files.h"
#include "services/lab/commands.h"
#include "services/lab/surface_mesh.h"
#include "services/texture/algo/map/distortion.h"
#include "services/texture/algo/map/flatten.h"
#include "services/texture/algo/surface/cut_open.h"
#include "services/texture/algo/surface/disk.h"
#include "services/texture/algo/surface/seam.h"

namespace slicefarm::lab {
namespace {

struct FlattenCommandOptions {
  std::string model;
  std::string output;
  bool no_seam = false;
};

/// Returns the original surface as OBJ, with a `vt` for each vertex of the opened surface.
std::string MapText(const texture::SurfaceMesh& mesh, const texture::OpenedSurface& opened,
                    const texture::FlatMap& map) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (const Eigen::Vector3d& p : mesh.points_mm)
    fmt::format_to(out, "v {} {} {}\n", p.x(), p.y(), p.z());
  for (const Eigen::Vector2d& p : map.points_mm) fmt::format_to(out, "vt {} {}\n", p.x(), p.y());
  for (const auto& triangle : opened.mesh.triangles) {
    text.push_back('f');
    for (const int32_t vertex : triangle)
      fmt::format_to(out, " {}/{}", opened.vertex_of[vertex] + 1, vertex + 1);
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

/// Returns the greatest distortion energy of a triangle, divided by 4.
double GreatestEnergy(const texture::SurfaceMesh& mesh, const texture::FlatMap& map) {
  double greatest = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto rest = texture::RestOf(mesh.points_mm[a], mesh.points_mm[b], mesh.points_mm[c]);
    const auto jacobian =
        texture::JacobianOf(rest, map.points_mm[a], map.points_mm[b], map.points_mm[c]);
    greatest = std::max(greatest, texture::SymmetricDirichlet(jacobian));
  }
  return greatest / 4;
}

cli::ExitCode FlattenSurface(const FlattenCommandOptions& options) {
  const auto mesh = ReadSurface(options.model);
  if (!mesh.ok()) return cli::Fail(mesh.status());
  const auto start = std::chrono::steady_clock::now();
  const auto topology = texture::TopologyOf(*mesh);
  if (!topology.ok()) return cli::Fail(cli::InFile(options.model, topology.status()));
  const std::vector<texture::SeamEdge> seam =
      options.no_seam ? std::vector<texture::SeamEdge>() : texture::SeamOf(*mesh, *topology);
  const texture::OpenedSurface opened = texture::CutOpen(*mesh, seam);
  const auto map = texture::Flatten(opened.mesh);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!map.ok()) return cli::Fail(cli::InFile(options.model, map.status()));
  const absl::Status written = cli::WriteFile(options.output, MapText(*mesh, opened, *map));
  if (!written.ok()) return cli::Fail(written);
  // Flatten proves that a map has no flips and no crossings, or fails.
  cli::Print(
      fmt::format("faces {}\nseam_edges {}\nflips 0\ncrossings 0\nenergy_mean_over_4 {:.6f}\n"
                  "energy_max {:.6f}\nseconds {:.6f}\n",
                  mesh->triangles.size(), seam.size(), map->mean_energy,
                  GreatestEnergy(opened.mesh, *map), seconds));
  return cli::ExitCode::kOk;
}

}  // namespace

void AddFlatten(CLI::App& app, cli::CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("flatten", "Lay a curved surface flat, one to one and little distorted");
  const auto options = std::make_shared<FlattenCommandOptions>();
  command->add_option("MESH", options->model, "OBJ, PLY or STL, in mm: one part, closed or not")
      ->required();
  command->add_option("-o,--output", options->output, "The same surface as OBJ, with its map as vt")
      ->required()
      ->type_name("UV.obj");
  command->add_flag("--no-seam", options->no_seam,
                    "Refuse a surface that has to be cut: a closed one, or one with handles");
  command->footer(
      "No part of the map lies upon another. Distortion is the symmetric Dirichlet energy over 4,\n"
      "by area: 1 of a surface that can be laid flat as it is. A closed surface is cut along a "
      "short\n"
      "seam, where a vertex has several vt.\n"
      "Example:\n"
      "  slicefarm-lab flatten mask.obj -o mask_uv.obj");
  command->callback(
      [options, &context] { context.run = [options] { return FlattenSurface(*options); }; });
}

}  // namespace slicefarm::lab
