#include "common/config/projects/orca_mesh.h"

#include <gtest/gtest.h>

#include "common/macro/template_run.h"

namespace slicefarm::config::orca_mesh_test {
namespace {

/// Expands G-code for a first layer from 20, 30 to 120, 95 mm.
std::string Expanded(const std::string& gcode, const BedMesh& mesh) {
  const macro::TemplateVariables variables = {
      {"first_layer_print_min", macro::TemplateVariable::List({20.0, 30.0})},
      {"first_layer_print_max", macro::TemplateVariable::List({120.0, 95.0})}};
  const auto text = macro::ExpandTemplate("start_gcode", WithBedMesh(gcode, mesh), variables);
  return text.ok() ? *text : std::string(text.status().message());
}

TEST(WithBedMesh, LeavesOtherGcodeAlone) { EXPECT_EQ(WithBedMesh("G28 ; bed", {}), "G28 ; bed"); }

TEST(WithBedMesh, FollowsTheFirstLayer) {
  const std::string gcode =
      "MESH {adaptive_bed_mesh_min[0]},{adaptive_bed_mesh_min[1]} "
      "{adaptive_bed_mesh_max[0]},{adaptive_bed_mesh_max[1]} "
      "{bed_mesh_probe_count[0]},{bed_mesh_probe_count[1]} [bed_mesh_algo]";
  EXPECT_EQ(Expanded(gcode, {}), "MESH 20,30 120,95 3,3 bicubic");
  EXPECT_EQ(
      Expanded(gcode, {.min = {18, 5}, .max = {200, 97}, .probe_distance = {20, 13}, .margin = 5}),
      "MESH 18,25 125,97 6,6 bicubic");
  EXPECT_EQ(Expanded(gcode, {.klipper = true}), "MESH 20,30 120,95 4,4 bicubic");
}

}  // namespace
}  // namespace slicefarm::config::orca_mesh_test
