#include "services/planning/algo/supports/generator/interfaces.h"

#include <gtest/gtest.h>

#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::interfaces_test {
namespace {

constexpr size_t kLayers = 20;

SupportHeights Even() {
  SupportHeights heights;
  for (Coord i = 0; i < static_cast<Coord>(kLayers); ++i)
    heights.layers.push_back({i * 200'000, (i + 1) * 200'000});
  return heights;
}

double AreaOf(const std::vector<SupportLayer>& layers, size_t layer, SupportRole role) {
  double area = 0;
  for (const SupportRegion& region : layers[layer].regions)
    if (region.role == role) area += AreaMm2(region.outlines);
  return area;
}

/// A plate, 1 mm high, under the left half of a column of 10 x 10 mm.
class InterfacesTest : public testing::Test {
 protected:
  InterfacesTest() : bodies_(kLayers), contacts_(kLayers) {
    for (size_t i = 0; i < kLayers; ++i)
      bodies_[i] = i < 6 ? BoxOf(5.3, 0, 10, 10) : BoxOf(0, 0, 10, 10);
    contacts_.back() = BoxOf(0, 0, 10, 10);
  }

  const TestStack plate_{5, [](double) { return BoxOf(-5, -5, 5, 15); }};
  std::vector<MultiPolygon> bodies_;
  Contacts contacts_;
};

TEST_F(InterfacesTest, OfColumns) {
  SupportOptions options;
  options.bottom_interface_layers = 2;
  const SupportProblem problem = plate_.Problem();
  const auto layers = ColumnLayers(problem, Even(), bodies_, contacts_, options, 2);
  ASSERT_EQ(layers.size(), kLayers);
  for (size_t i = 0; i < kLayers; ++i) {
    EXPECT_NEAR(AreaOf(layers, i, SupportRole::kTopInterface), i >= 17 ? 100 : 0, 1e-6) << i;
    EXPECT_NEAR(AreaOf(layers, i, SupportRole::kBottomInterface), i == 6 || i == 7 ? 50 : 0, 1e-6)
        << i;
    double all = 0;
    for (const SupportRegion& region : layers[i].regions) all += AreaMm2(region.outlines);
    EXPECT_NEAR(all, AreaMm2(bodies_[i]), 1e-6);
    EXPECT_EQ(layers[i].first, i == 0);
  }
}

/// Between a part's walls a column may be a slit. Beads in it would be loose crumbs.
TEST_F(InterfacesTest, SlitsHaveNeitherBaseNorSheet) {
  SupportOptions options;
  for (MultiPolygon& body : bodies_) body = Union(BoxOf(0, 0, 4, 10), BoxOf(6, 0, 6.12, 10));
  contacts_.back() = BoxOf(0, 0, 10, 10);
  const auto layers = ColumnLayers({}, Even(), bodies_, contacts_, options, 2);
  ASSERT_EQ(layers.size(), kLayers);
  for (const SupportLayer& layer : layers) {
    double all = 0;
    for (const SupportRegion& region : layer.regions) {
      all += AreaMm2(region.outlines);
      EXPECT_LT(Bounds(region.outlines).max.x, FromMm(5)) << layer.top_nm;
    }
    EXPECT_NEAR(all, 40, 1e-3);
  }
}

/// A sheet of less than a millimetre may be between two lines of the base. Its first layer extends
/// over one of them.
TEST_F(InterfacesTest, TheFirstLayerOfASmallSheetReachesOverALine) {
  SupportOptions options;
  for (MultiPolygon& body : bodies_) body = BoxOf(0, 0, 10, 10);
  contacts_.back() = BoxOf(4.6, 4.6, 5.4, 5.4);
  const auto layers = ColumnLayers({}, Even(), bodies_, contacts_, options, 2);
  ASSERT_EQ(layers.size(), kLayers);
  const double cell_mm = ToMm(static_cast<double>(options.spacing_nm + options.width_nm));
  const size_t first = kLayers - static_cast<size_t>(options.top_interface_layers);
  EXPECT_GT(AreaOf(layers, first, SupportRole::kTopInterface), cell_mm * cell_mm);
  EXPECT_EQ(AreaOf(layers, first - 1, SupportRole::kTopInterface), 0);
  EXPECT_LT(AreaOf(layers, kLayers - 1, SupportRole::kTopInterface), 2) << "what the part lies on";
}

// The rest of a column beside its contact supports nothing any more.
TEST_F(InterfacesTest, ColumnsEndWithTheirSheets) {
  SupportOptions options;
  options.top_interface_layers = 2;
  options.bottom_interface_layers = 0;
  for (MultiPolygon& body : bodies_) body = BoxOf(0, 0, 10, 10);
  bodies_.back().push_back(BoxOf(20, 0, 30, 10).front());  // no contact above it
  contacts_.back() = BoxOf(0, 0, 6, 10);
  contacts_[10] = BoxOf(0, 0, 4, 10);  // the rest of the column continues above it
  const SupportProblem problem = plate_.Problem();
  const auto layers = ColumnLayers(problem, Even(), bodies_, contacts_, options, 1);
  for (size_t i = 0; i < kLayers; ++i) {
    const double sheet = i >= 18 ? 6 : (i == 9 || i == 10 ? 4 : 0);
    const double beyond = sheet > 0 ? ToMm(options.width_nm) / 2 : 0;
    EXPECT_NEAR(AreaOf(layers, i, SupportRole::kBase), i >= 18 ? 0 : 100 - 10 * (sheet + beyond),
                0.1)
        << i;
  }
}

// The part has cut these columns off from the contacts above them.
TEST(DropUseless, TakesNarrowColumnsThatCarryNothing) {
  const PolygonWithHoles supports = BoxOf(0, 0, 1, 4).front(), cut = BoxOf(5, 0, 6, 4).front(),
                         wide = BoxOf(10, 0, 20, 10).front();
  std::vector<MultiPolygon> columns = {{supports, cut, wide}, {supports, cut}, {supports}};
  const Contacts contacts = {{}, {}, BoxOf(0, 0, 1, 4)};
  DropUseless(contacts, 3'000'000, columns);
  EXPECT_EQ(columns[2], MultiPolygon{supports});
  EXPECT_EQ(columns[1], MultiPolygon{supports});
  EXPECT_EQ(columns[0], (MultiPolygon{supports, wide})) << "wide ones are not looked at";
}

// The lines of a base may miss a narrow island, and the interface would have nothing below it.
TEST_F(InterfacesTest, NarrowIslandsUnderContactsAreInterface) {
  SupportOptions options;
  options.top_interface_layers = 2;
  for (MultiPolygon& body : bodies_) body = BoxOf(0, 0, 1, 4);
  contacts_.back() = BoxOf(0, 0, 1, 4);
  const SupportProblem problem = plate_.Problem();
  const auto layers = ColumnLayers(problem, Even(), bodies_, contacts_, options, 1);
  for (size_t i = 0; i < kLayers; ++i)
    EXPECT_NEAR(AreaOf(layers, i, SupportRole::kTopInterface), i + 4 >= kLayers ? 4 : 0, 1e-6) << i;
}

TEST_F(InterfacesTest, NoneIfNoneAreWanted) {
  SupportOptions options;
  options.top_interface_layers = options.bottom_interface_layers = 0;
  const SupportProblem problem = plate_.Problem();
  size_t regions = 0;
  for (const SupportLayer& layer : ColumnLayers(problem, Even(), bodies_, contacts_, options, 1)) {
    regions += layer.regions.size();
    for (const SupportRegion& region : layer.regions) EXPECT_EQ(region.role, SupportRole::kBase);
  }
  EXPECT_GT(regions, 0u);
}

TEST_F(InterfacesTest, OfBranches) {
  SupportOptions options;
  options.top_interface_layers = 2;
  const SupportProblem problem = plate_.Problem();
  const Clearance clearance(problem, options, 100'000'000, 1);
  const auto sheets = Sheets(Even(), contacts_, clearance, options, 1);
  EXPECT_NEAR(AreaMm2(sheets[18]), 100.64, 0.01);  // slightly more than the contact above
  EXPECT_TRUE(sheets[17].empty());
  std::vector<BranchSections> branches(kLayers);
  for (size_t i = 0; i < kLayers; ++i) {
    if (i >= 6) branches[i].thin = BoxOf(2, 2, 3, 3);
    branches[i].thick = BoxOf(6, 6, 9, 9);
  }
  const std::vector<MultiPolygon> no_plinths(kLayers);
  const auto layers = BranchLayers(problem, Even(), branches, sheets, no_plinths, options, 1);
  EXPECT_EQ(AreaOf(layers, 19, SupportRole::kBranch), 0);
  EXPECT_NEAR(AreaOf(layers, 17, SupportRole::kBranch), 1, 1e-6);
  EXPECT_NEAR(AreaOf(layers, 17, SupportRole::kThickBranch), 9, 1e-6);
  EXPECT_NEAR(AreaOf(layers, 6, SupportRole::kBottomInterface), 1, 1e-6);
  EXPECT_NEAR(AreaOf(layers, 19, SupportRole::kTopInterface), 100, 1e-6);
}

TEST_F(InterfacesTest, NearTheBedPlinthsCarryContacts) {
  const SupportProblem problem = plate_.Problem();
  const SupportOptions options;
  const Clearance clearance(problem, options, 100'000'000, 1);
  Contacts contacts(kLayers);
  contacts[6] = BoxOf(40, 40, 50, 50);
  contacts[15] = BoxOf(60, 40, 70, 50);
  const auto plinths = Plinths(Even(), contacts, clearance, 1);
  for (size_t i = 0; i < kLayers; ++i)
    EXPECT_NEAR(AreaMm2(plinths[i]), i <= 6 ? 100 : 0, 1e-6)
        << i << ": the higher one has branches";
}

}  // namespace
}  // namespace slicefarm::planning::interfaces_test
