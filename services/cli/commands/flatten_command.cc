#include <fmt/core.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>
#include <string>

#include "common/model/limits.h"
#include "services/cli/commands/commands.h"
#include "services/cli/console.h"
#include "services/cli/files.h"
#include "services/cli/models/given_models.h"
#include "services/slicing/algo/mesh_io/indexed_weld.h"
#include "services/slicing/algo/mesh_io/mesh_reader.h"
#include "services/texture/algo/map/distortion.h"
#include "services/texture/algo/map/flatten.h"

namespace slicefarm::cli {
namespace {

struct FlattenCommandOptions {
  std::string model;
  std::string output;
};

/// Vertices as an OBJ or PLY file numbers them; an STL file's corners are joined where they meet.
absl::StatusOr<texture::SurfaceMesh> ReadSurface(const std::string& path) {
  const auto file = ReadModelFile(path);
  if (!file.ok()) return file.status();
  auto raw = slicing::ReadMesh(file->bytes, file->format, limits::kMaxMeshCoordinateMm, {});
  if (!raw.ok()) return InFile(path, raw.status());
  if (file->format == MeshFormat::kStl) raw = slicing::Welded(*raw);
  texture::SurfaceMesh mesh;
  for (const slicing::Position& p : raw->positions) mesh.points_mm.push_back({p.x, p.y, p.z});
  for (const auto& [a, b, c] : raw->triangles)
    mesh.triangles.push_back(
        {static_cast<int32_t>(a), static_cast<int32_t>(b), static_cast<int32_t>(c)});
  return mesh;
}

/// The surface with a `vt` for each `v`.
std::string MapText(const texture::SurfaceMesh& mesh, const texture::FlatMap& map) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (const Eigen::Vector3d& p : mesh.points_mm)
    fmt::format_to(out, "v {} {} {}\n", p.x(), p.y(), p.z());
  for (const Eigen::Vector2d& p : map.points_mm) fmt::format_to(out, "vt {} {}\n", p.x(), p.y());
  for (const auto& [a, b, c] : mesh.triangles)
    fmt::format_to(out, "f {0}/{0} {1}/{1} {2}/{2}\n", a + 1, b + 1, c + 1);
  return fmt::to_string(text);
}

/// The greatest distortion of a triangle, over 4.
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

ExitCode FlattenSurface(const FlattenCommandOptions& options) {
  const auto mesh = ReadSurface(options.model);
  if (!mesh.ok()) return Fail(mesh.status());
  const auto start = std::chrono::steady_clock::now();
  const auto map = texture::Flatten(*mesh);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!map.ok()) return Fail(InFile(options.model, map.status()));
  const absl::Status written = WriteFile(options.output, MapText(*mesh, *map));
  if (!written.ok()) return Fail(written);
  // Flatten proves that a map has neither, or fails.
  Print(
      fmt::format("faces {}\nflips 0\ncrossings 0\nenergy_mean_over_4 {:.6f}\nenergy_max {:.6f}\n"
                  "seconds {:.6f}\n",
                  mesh->triangles.size(), map->mean_energy, GreatestEnergy(*mesh, *map), seconds));
  return ExitCode::kOk;
}

}  // namespace

void AddFlatten(CLI::App& app, CommandContext& context) {
  CLI::App* command =
      app.add_subcommand("flatten", "Lay a curved surface flat, one to one and little distorted");
  const auto options = std::make_shared<FlattenCommandOptions>();
  command
      ->add_option("MESH", options->model,
                   "OBJ, PLY or STL, in mm: one part with a boundary, holes as it likes")
      ->required();
  command
      ->add_option("-o,--output", options->output, "The same surface as OBJ, with a vt for each v")
      ->required()
      ->type_name("UV.obj");
  command->footer(
      "No part of the map lies upon another. Distortion is the symmetric Dirichlet energy over 4,\n"
      "by area: 1 of a surface that can be laid flat as it is.\n"
      "Example:\n"
      "  slicefarm flatten mask.obj -o mask_uv.obj");
  command->callback(
      [options, &context] { context.run = [options] { return FlattenSurface(*options); }; });
}

}  // namespace slicefarm::cli
