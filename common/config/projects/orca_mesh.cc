#include "common/config/projects/orca_mesh.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/config/table/value.h"

namespace slicefarm::config {
namespace {

std::string Number(double mm) { return PrintNumber(Quantise(mm)); }

/// Returns `{local name = (x, y)}`.
template <typename OfAxis>
std::string Define(std::string_view name, const OfAxis& of_axis) {
  return fmt::format("{{local {} = ({}, {})}}", name, of_axis(0), of_axis(1));
}

std::string Bounds(const BedMesh& mesh) {
  const std::string margin = Number(mesh.margin);
  return Define("adaptive_bed_mesh_min",
                [&](size_t axis) {
                  return fmt::format("max(first_layer_print_min[{}] - {}, {})", axis, margin,
                                     Number(mesh.min[axis]));
                }) +
         Define("adaptive_bed_mesh_max", [&](size_t axis) {
           return fmt::format("min(first_layer_print_max[{}] + {}, {})", axis, margin,
                              Number(mesh.max[axis]));
         });
}

/// Returns an expression for the number of points, so that neighbours are at most probe_distance
/// apart. The number is at least 3.
std::string Count(const BedMesh& mesh) {
  return Define("bed_mesh_probe_count", [&](size_t axis) {
    const std::string steps =
        fmt::format("(adaptive_bed_mesh_max[{0}] - adaptive_bed_mesh_min[{0}]) / {1}", axis,
                    Number(std::max(1.0, mesh.probe_distance[axis])));
    return fmt::format("max({0}, int({1}) + ({1} > int({1}) ? 1 : 0))", mesh.klipper ? 4 : 3,
                       steps);
  });
}

}  // namespace

std::string WithBedMesh(std::string gcode, const BedMesh& mesh) {
  const auto names = [&](std::string_view name) { return gcode.find(name) != std::string::npos; };
  const bool count = names("bed_mesh_probe_count");
  std::string definitions;
  if (count || names("adaptive_bed_mesh_min") || names("adaptive_bed_mesh_max"))
    definitions += Bounds(mesh);
  if (count) definitions += Count(mesh);
  if (names("bed_mesh_algo")) definitions += "{local bed_mesh_algo = \"bicubic\"}";
  return definitions + gcode;
}

}  // namespace slicefarm::config
