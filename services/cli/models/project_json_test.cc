#include "services/cli/models/project_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "services/slicing/algo/mesh_io/threemf/package/archive_files_test.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"

namespace slicefarm::cli::project_json_test {
namespace {

namespace threemf = slicing::threemf;

nlohmann::json JsonOf(const threemf::Files& files) {
  const auto read = slicing::ReadMeshFile(threemf::Zipped(files), MeshFormat::k3mf, 1e4,
                                          slicing::ReadDepth::kStructure, {});
  EXPECT_TRUE(read.ok()) << read.status();
  return nlohmann::json::parse(ProjectJson(read->project));
}

TEST(ProjectJson, TellsObjectsPartsPlacesAndSettings) {
  const nlohmann::json json = JsonOf(threemf::PrusaFiles());
  EXPECT_EQ(json["application"], "PrusaSlicer-2.9.2");
  EXPECT_EQ(json["settings"]["layer_height"], "0.2");
  ASSERT_EQ(json["objects"].size(), 2);
  const nlohmann::json& bracket = json["objects"][0];
  EXPECT_EQ(bracket["name"], "Bracket");
  EXPECT_EQ(bracket["settings"]["perimeters"], "4");
  EXPECT_EQ(bracket["parts"][1]["role"], "modifier");
  EXPECT_EQ(bracket["parts"][1]["settings"]["fill_density"], "80%");
  EXPECT_EQ(json["objects"][1]["height_ranges"][0]["to_mm"], 5);
  EXPECT_EQ(bracket["copies"][0]["to_plate"][3], 50);
  EXPECT_EQ(bracket["copies"][1]["printable"], false);
  ASSERT_EQ(json["plates"].size(), 1);
  EXPECT_EQ(json["plates"][0]["objects"].size(), 3);
}

TEST(ProjectJson, SettingsHavePrusaSlicersNames) {
  const nlohmann::json json = JsonOf(threemf::BambuFiles());
  EXPECT_EQ(json["settings"]["perimeters"], "3");
  EXPECT_EQ(json["settings"]["temperature"], "220,230");
  EXPECT_EQ(json["objects"][0]["parts"][1]["settings"]["perimeters"], "5");
  ASSERT_EQ(json["plates"].size(), 2);
  EXPECT_EQ(json["plates"][0]["name"], "left");
  EXPECT_EQ(json["plates"][1]["objects"][0]["copy"], 1);
}

}  // namespace
}  // namespace slicefarm::cli::project_json_test
