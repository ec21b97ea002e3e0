#include "processes/fdm/settings/support_rows.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "common/config/resolve.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::fdm::support_rows_test {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;
/// Spacing of lines 0.4 mm wide that fill a layer of 0.3 mm.
constexpr double kSpacing = 0.4 - 0.3 * (1 - std::numbers::pi / 4);

JobRows Resolved(const std::vector<std::pair<std::string, std::string>>& given) {
  std::vector<Setting> settings = {{"support_material", "1", Source::kRequest}};
  for (const auto& [key, value] : given) settings.push_back({key, value, Source::kRequest});
  const auto resolved = Resolve(settings, Process::kFdm);
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  return resolved.ok() ? resolved->settings : JobRows{};
}

struct Case {
  std::string name;
  SupportRow row;
  int32_t walls = 0;
  double density = 0, turn = 0;
};

class SupportRegionRowTest : public testing::TestWithParam<Case> {};

TEST_P(SupportRegionRowTest, HasItsLines) {
  const Case& c = GetParam();
  const JobRows row = SupportRegionRow(Resolved({{"support_material_extrusion_width", "0.4"},
                                                 {"support_material_spacing", "2.1"},
                                                 {"layer_height", "0.3"},
                                                 {"support_material_interface_spacing", "0.1"},
                                                 {"support_material_angle", "30"},
                                                 {"perimeters", "4"},
                                                 {"top_solid_layers", "5"}}),
                                       c.row);
  EXPECT_EQ(FdmOf(row).region.walls.perimeters, c.walls);
  EXPECT_EQ(FdmOf(row).region.walls.external_width_nm, 400'000);
  EXPECT_NEAR(FdmOf(row).region.infill.density, c.density, 1e-6);
  EXPECT_DOUBLE_EQ(FdmOf(row).region.infill.angle_rad, std::numbers::pi / 6 + kQuarter * c.turn);
  EXPECT_EQ(FdmOf(row).region.infill.top_solid_layers, 0);
}

TEST(SupportRegionRow, InterfacesBelowTheObjectMayHaveASecondLoop) {
  for (const auto& [value, loops] : {std::pair("0", 1), std::pair("1", 2)}) {
    const JobRows given = Resolved({{"support_material_interface_contact_loops", value}});
    const auto walls = [&](SupportRow row) {
      return FdmOf(SupportRegionRow(given, row)).region.walls.perimeters;
    };
    EXPECT_EQ(walls(SupportRow::kInterface), loops);
    EXPECT_EQ(walls(SupportRow::kBottomInterface), 1);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rows, SupportRegionRowTest,
    testing::Values(Case{"FirstLayer", SupportRow::kFirstLayer, 1, 0.9, 0},
                    Case{"Base", SupportRow::kBase, 1, kSpacing / (kSpacing + 2.1), 0},
                    Case{"Branch", SupportRow::kBranch, 1, 0, 0},
                    Case{"ThickBranch", SupportRow::kThickBranch, 2, 0, 0},
                    Case{"Interface", SupportRow::kInterface, 1, kSpacing / (kSpacing + 0.1), 1},
                    Case{"Bottom", SupportRow::kBottomInterface, 1, kSpacing / (kSpacing + 0.1),
                         1}),
    [](const auto& info) { return info.param.name; });

TEST(SupportRegionRow, TheBottomHasItsOwnSpacing) {
  const JobRows dense = Resolved({{"support_material_interface_spacing", "0.5"},
                                  {"support_material_bottom_interface_spacing", "0"}});
  const auto density = [&](SupportRow row) {
    return FdmOf(SupportRegionRow(dense, row)).region.infill.density;
  };
  EXPECT_LT(density(SupportRow::kInterface), 0.6);
  EXPECT_EQ(density(SupportRow::kBottomInterface), 1);
}

TEST(SupportRegionRow, TheSheathMayBeLeftOut) {
  const JobRows bare = Resolved({{"support_material_with_sheath", "0"}});
  EXPECT_EQ(FdmOf(SupportRegionRow(bare, SupportRow::kBase)).region.walls.perimeters, 0);
  EXPECT_EQ(FdmOf(SupportRegionRow(bare, SupportRow::kBranch)).region.walls.perimeters, 1);
}

TEST(SupportRegionRow, IroningMakesTopInterfacesSolid) {
  const JobRows job = Resolved({{"support_material_interface_spacing", "0.3"},
                                {"support_ironing", "1"},
                                {"support_ironing_flow", "20%"},
                                {"support_ironing_spacing", "0.2"},
                                {"support_ironing_pattern", "concentric"},
                                {"top_solid_infill_flow_ratio", "0.9"}});
  for (int row = 0; row < kSupportRowCount; ++row) {
    const auto kind = static_cast<SupportRow>(row);
    const InfillOptions infill = FdmOf(SupportRegionRow(job, kind)).region.infill;
    const bool ironed = kind == SupportRow::kInterface;
    EXPECT_EQ(infill.ironing.enabled, ironed) << row;
    EXPECT_EQ(infill.top_solid_layers, ironed ? 1 : 0) << row;
    if (!ironed) continue;
    EXPECT_EQ(infill.density, 1);
    EXPECT_EQ(infill.top_flow, 1);
    EXPECT_DOUBLE_EQ(infill.ironing.flow, 0.2);
    EXPECT_EQ(infill.ironing.spacing_nm, 200'000);
    EXPECT_TRUE(infill.ironing.concentric);
  }
}

TEST(SupportRegionRow, PatternsAreTheSettings) {
  const auto base = [](const std::string& pattern) {
    const JobRows row =
        SupportRegionRow(Resolved({{"support_material_pattern", pattern}}), SupportRow::kBase);
    return FdmOf(row).region.infill.pattern;
  };
  EXPECT_EQ(base("rectilinear"), FillPattern::kAlignedRectilinear);
  EXPECT_EQ(base("rectilinear-grid"), FillPattern::kRectilinear);
  EXPECT_EQ(base("honeycomb"), FillPattern::kHoneycomb);
  const JobRows row = SupportRegionRow(
      Resolved({{"support_material_interface_pattern", "concentric"}}), SupportRow::kInterface);
  EXPECT_EQ(FdmOf(row).region.infill.solid_pattern, FillPattern::kConcentric);
}

TEST(SupportSettings, SayAsMuchAsPrusaSlicers) {
  const SupportOptions usual = FdmOf(Resolved({})).object.support;
  EXPECT_TRUE(usual.on);
  EXPECT_EQ(usual.bottom_gap_nm, usual.top_gap_nm) << "0: as at the top";
  EXPECT_EQ(usual.bottom_interface_layers, usual.top_interface_layers) << "-1: as at the top";
  EXPECT_EQ(usual.xy_gap_nm, usual.wall_width_nm / 2);
  const SupportOptions given = FdmOf(Resolved({{"support_material_style", "organic"},
                                               {"support_material_xy_spacing", "0.3"},
                                               {"support_material_threshold", "45"},
                                               {"layer_height", "0.15"},
                                               {"first_layer_height", "0.25"}}))
                                   .object.support;
  EXPECT_EQ(given.style, SupportStyle::kTree);
  EXPECT_EQ(given.xy_gap_nm, 300'000);
  EXPECT_DOUBLE_EQ(given.threshold_rad, std::numbers::pi / 4);
  EXPECT_EQ(given.layer_height_nm, 150'000);
  EXPECT_EQ(given.first_layer_height_nm, 250'000);
}

}  // namespace
}  // namespace slicefarm::config::fdm::support_rows_test
