#include "processes/fdm/settings/adhesion_rows.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "common/config/resolve.h"
#include "common/model/options/infill_options.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::fdm::adhesion_rows_test {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;
/// Spacing of lines 0.4 mm wide that fill a layer of 0.3 mm, which is three quarters of the nozzle.
constexpr double kSpacing = 0.4 - 0.3 * (1 - std::numbers::pi / 4);

JobRows Resolved(const std::vector<std::pair<std::string, std::string>>& given) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : given) settings.push_back({key, value, Source::kRequest});
  const auto resolved = Resolve(settings, Process::kFdm);
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  return resolved.ok() ? resolved->settings : JobRows{};
}

TEST(BrimRow, IsAllLinesOfTheFirstLayersWidth) {
  const JobRows job = Resolved({{"first_layer_extrusion_width", "0.6"},
                                {"perimeters", "2"},
                                {"only_one_perimeter_first_layer", "1"},
                                {"top_one_perimeter_type", "topmost"},
                                {"extra_perimeters", "1"},
                                {"fuzzy_skin", "all"},
                                {"perimeter_generator", "classic"},
                                {"fill_density", "15%"}});
  const JobRows row = BrimRow(job);
  EXPECT_EQ(FdmOf(row).region.walls.external_width_nm, 600'000);
  EXPECT_EQ(FdmOf(row).region.walls.inner_width_nm, 600'000);
  EXPECT_GT(FdmOf(row).region.walls.perimeters, 200 / 0.6 / 2) << "the widest brim there may be";
  EXPECT_FALSE(FdmOf(row).region.walls.one_on_bed);
  EXPECT_EQ(FdmOf(row).region.walls.one_on_top, OneWallOnTop::kNowhere);
  EXPECT_FALSE(FdmOf(row).region.walls.extra_perimeters);
  EXPECT_EQ(FdmOf(row).region.walls.fuzzy, FuzzySkin::kNone);
  EXPECT_EQ(FdmOf(row).region.walls.generator, WallGenerator::kArachne);
  EXPECT_EQ(FdmOf(row).region.infill.density, 1);
  EXPECT_TRUE(FdmOf(row).region.order.towards_holes);
}

TEST(BrimRow, HasItsOwnFlow) {
  const JobRows job = Resolved({{"brim_flow_ratio", "0.8"}, {"skirts", "1"}});
  constexpr auto kLine = static_cast<size_t>(Feature::kSkirt);
  EXPECT_EQ(FdmOf(BrimRow(job)).region.motion.flow[kLine], 0.8);
  EXPECT_EQ(FdmOf(SkirtRow(job)).region.motion.flow[kLine], 1);
}

TEST(SkirtRow, HasItsOwnSpeed) {
  const JobRows job = Resolved({{"skirt_speed", "45"}, {"skirts", "1"}});
  EXPECT_EQ(FdmOf(SkirtRow(job)).region.motion.skirt_speed_mm_s, 45);
  EXPECT_EQ(FdmOf(BrimRow(job)).region.motion.skirt_speed_mm_s, 0);
}

struct Layer {
  double density, turn;
  int32_t walls;
};

// The expected values were measured in PrusaSlicer 2.5.0.
TEST(RaftRow, DensityAndAngleOfEachLayer) {
  const double base = kSpacing / (kSpacing + 2.5);
  const std::vector<std::vector<Layer>> rafts = {
      {{1, 1, 0}},
      {{0.9, 0, 1}, {1, 1, 0}},
      {{0.9, 0, 1}, {1, 1, 0}, {1, 1, 0}},
      {{0.9, 1, 1}, {base, 0, 1}, {1, 1, 0}, {1, 1, 0}},
      {{0.9, 1, 1}, {base, 0, 1}, {base, 0, 1}, {1, 1, 0}, {1, 1, 0}, {1, 1, 0}},
  };
  for (const std::vector<Layer>& raft : rafts) {
    const JobRows job = Resolved({{"raft_layers", std::to_string(raft.size())},
                                  {"support_material_angle", "30"},
                                  {"support_material_extrusion_width", "0.4"}});
    for (size_t i = 0; i < raft.size(); ++i) {
      const JobRows row = RaftRow(job, static_cast<int32_t>(i));
      const InfillOptions& infill = FdmOf(row).region.infill;
      EXPECT_NEAR(infill.density, raft[i].density, 1e-6) << raft.size() << " " << i;
      EXPECT_DOUBLE_EQ(infill.angle_rad, std::numbers::pi / 6 + kQuarter * raft[i].turn);
      EXPECT_EQ(infill.pattern, FillPattern::kAlignedRectilinear);
      EXPECT_EQ(infill.top_solid_layers, 0);
      EXPECT_EQ(infill.sparse_width_nm, 400'000);
      EXPECT_EQ(infill.solid_width_nm, 400'000);
      EXPECT_EQ(infill.first_layer_width_nm, FdmOf(job).region.infill.first_layer_width_nm);
      EXPECT_EQ(FdmOf(row).region.walls.perimeters, raft[i].walls);
    }
  }
}

TEST(RaftRow, InterfacesHaveTheSupportsGaps) {
  const JobRows job = Resolved({{"raft_layers", "3"},
                                {"support_material_interface_spacing", "1"},
                                {"support_material_extrusion_width", "0.4"}});
  EXPECT_DOUBLE_EQ(FdmOf(RaftRow(job, 0)).region.infill.density, 0.9);
  for (const int32_t layer : {1, 2})
    EXPECT_NEAR(FdmOf(RaftRow(job, layer)).region.infill.density, kSpacing / (kSpacing + 1), 1e-6)
        << layer;
}

}  // namespace
}  // namespace slicefarm::config::fdm::adhesion_rows_test
