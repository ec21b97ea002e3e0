#include "services/planning/algo/supports/generator/columns.h"

#include <gtest/gtest.h>

#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::columns_test {
namespace {

constexpr int kLayers = 20;

absl::StatusOr<std::vector<MultiPolygon>> ColumnsUnder(const SupportProblem& problem,
                                                       const MultiPolygon& contact,
                                                       const SupportOptions& options) {
  SupportHeights heights;
  for (Coord i = 0; i < kLayers; ++i) heights.layers.push_back({i * 200'000, (i + 1) * 200'000});
  Contacts contacts(kLayers);
  contacts.back() = contact;
  const Clearance clearance(problem, options, 100'000'000, 1);
  return Columns(problem, heights, contacts, clearance, options, 2, CancelToken());
}

SupportOptions Style(SupportStyle style) {
  SupportOptions options;
  options.style = style;
  return options;
}

const TestStack kNothing(kLayers, [](double) { return MultiPolygon(); });

TEST(Columns, SnugAreALineWiderThanTheirContact) {
  const auto columns =
      ColumnsUnder(kNothing.Problem(), BoxOf(0, 0, 5, 5), Style(SupportStyle::kSnug));
  ASSERT_TRUE(columns.ok());
  for (const MultiPolygon& column : *columns) EXPECT_NEAR(AreaMm2(column), 5.7 * 5.7, 1.2);
}

TEST(Columns, SnugCloseGapsOfTwiceTheRadius) {
  const MultiPolygon pair = Union(BoxOf(0, 0, 3, 5), BoxOf(6, 0, 9, 5));
  SupportOptions options = Style(SupportStyle::kSnug);
  EXPECT_EQ(ColumnsUnder(kNothing.Problem(), pair, options)->front().size(), 1u);
  options.closing_radius_nm = 500'000;
  EXPECT_EQ(ColumnsUnder(kNothing.Problem(), pair, options)->front().size(), 2u);
}

TEST(Columns, GridAreWholeCells) {
  const auto columns =
      ColumnsUnder(kNothing.Problem(), BoxOf(0.1, 0.1, 4.9, 2.4), Style(SupportStyle::kGrid));
  ASSERT_TRUE(columns.ok());
  EXPECT_NEAR(AreaMm2(columns->front()), 5 * 2.5, 0.01);
  SupportOptions turned = Style(SupportStyle::kGrid);
  turned.angle_rad = 0.3;
  const MultiPolygon column = ColumnsUnder(kNothing.Problem(), BoxOf(0, 0, 6, 6), turned)->front();
  EXPECT_NEAR(AreaMm2(Difference(BoxOf(0.2, 0.2, 5.8, 5.8), column)), 0, 1e-6);
  EXPECT_LT(AreaMm2(column), 80);
}

TEST(Columns, StandOnThePartIfTheyMay) {
  const TestStack plate(kLayers,
                        [](double z) { return z < 1 ? BoxOf(-5, -5, 2.5, 10) : MultiPolygon(); });
  SupportOptions options = Style(SupportStyle::kSnug);
  auto columns = ColumnsUnder(plate.Problem(), BoxOf(0, 0, 5, 5), options);
  EXPECT_NEAR(AreaMm2((*columns)[19]), 5.7 * 5.7, 1.2);
  EXPECT_NEAR(AreaMm2((*columns)[6]), 5.7 * 5.7, 1.2);
  EXPECT_NEAR(AreaMm2((*columns)[2]), 5.7 * (5.35 - 2.725), 1.7);
  options.bed_only = true;
  columns = ColumnsUnder(plate.Problem(), BoxOf(0, 0, 5, 5), options);
  EXPECT_NEAR(AreaMm2((*columns)[19]), 5.7 * (5.35 - 2.725), 1.7);
}

TEST(Columns, DoNotStandOnOthers) {
  const TestStack plate(5, [](double) { return BoxOf(-5, -5, 2.5, 10); });
  SupportProblem problem = kNothing.Problem();
  problem.others.push_back(plate.Layers());
  const auto columns = ColumnsUnder(problem, BoxOf(0, 0, 5, 5), Style(SupportStyle::kSnug));
  ASSERT_TRUE(columns.ok());
  ASSERT_FALSE(columns->empty());
  for (const MultiPolygon& column : *columns)
    EXPECT_NEAR(AreaMm2(column), 5.7 * (5.35 - 2.725), 1.7);
}

TEST(Columns, CanBeCancelled) {
  const SupportProblem problem = kNothing.Problem();
  const SupportOptions options;
  const Clearance clearance(problem, options, 100'000'000, 1);
  SupportHeights heights;
  heights.layers.push_back({0, 200'000});
  EXPECT_EQ(Columns(problem, heights, {{}}, clearance, options, 1, CancelToken([] { return true; }))
                .status()
                .code(),
            absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace slicefarm::planning::columns_test
