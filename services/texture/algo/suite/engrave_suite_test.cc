#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>

#include "services/texture/algo/map/exact_turn.h"
#include "services/texture/algo/output/csv_text.h"
#include "services/texture/algo/paths/layer_paths.h"
#include "services/texture/algo/paths/sample_maps_test.h"
#include "services/texture/algo/pattern/computed_heights.h"
#include "services/texture/algo/suite/csv_oracle_test.h"
#include "services/texture/algo/suite/suite_surfaces_test.h"

// The suite has 48 textures on 20 surfaces: 960 runs, each judged by its table of points and the
// mesh. By default 60 of them are made, which include each surface and each texture.
// SLICEFARM_ENGRAVE_RUNS=960 makes all.

namespace slicefarm::texture::engrave_suite_test {
namespace {

/// Returns n if every n-th run is made.
size_t Every() {
  const char* const runs = std::getenv("SLICEFARM_ENGRAVE_RUNS");
  return runs != nullptr && std::string(runs) == "960" ? 1 : 16;
}

constexpr double kSpacingMm = 0.33;

/// Returns twelve kinds, each with four pairs of height and pitch.
std::vector<std::string> SuiteTextures() {
  std::vector<std::string> textures;
  for (const TextureKindInfo& info : kTextureKinds) {
    for (const char* measures :
         {"height=0.3,pitch=3", "height=0.8,pitch=3", "height=0.3,pitch=7", "height=0.8,pitch=7"})
      textures.push_back(
          std::string(info.name) + ":detail=24," + measures +
          (info.kind == TextureKind::kNoise || info.kind == TextureKind::kCells ? ",count=3" : "") +
          (info.kind == TextureKind::kLetters ? ",text=AB" : ""));
  }
  return textures;
}

/// Check 1: the map is one-to-one. It has no flips, and the total area of its triangles equals the
/// area of its loops.
void ExpectOneToOne(const SurfaceMap& map) {
  double triangles = 0, loops = 0;
  for (const auto& [a, b, c] : map.mesh().triangles) {
    const auto& m = map.map_mm();
    ASSERT_EQ(ExactTurn(m[a], m[b], m[c]), 1);
    triangles += (m[b] - m[a]).x() * (m[c] - m[a]).y() - (m[b] - m[a]).y() * (m[c] - m[a]).x();
  }
  for (const auto& loop : map.loops())
    for (size_t i = 0; i < loop.size(); ++i) {
      const Eigen::Vector2d &a = map.map_mm()[loop[i]],
                            &b = map.map_mm()[loop[(i + 1) % loop.size()]];
      loops += a.x() * b.y() - a.y() * b.x();
    }
  EXPECT_NEAR(triangles, loops, 1e-9 * triangles);
}

/// Returns the position of a point's foot in the map.
Eigen::Vector2d MapPlaceOf(const EngravePlan& plan, int32_t triangle, const Eigen::Vector3d& foot) {
  const auto& [a, b, c] = plan.map.mesh().triangles[triangle];
  const auto& p = plan.map.mesh().points_mm;
  Eigen::Matrix<double, 3, 2> edges;
  edges << p[b] - p[a], p[c] - p[a];
  const Eigen::Vector2d w =
      (edges.transpose() * edges).inverse() * (edges.transpose() * (foot - p[a]));
  const auto& m = plan.map.map_mm();
  return m[a] + w[0] * (m[b] - m[a]) + w[1] * (m[c] - m[a]);
}

/// Results from the rows: the largest height error of a worked position, and the length of lines in
/// the map per layer.
struct Worked {
  double worst_mm = 0;
  std::vector<double> map_mm;
};

Worked MeasureWorked(const EngravePlan& plan, const CsvOracle& oracle,
                     const std::vector<CsvPoint>& points) {
  Worked worked{0, std::vector<double>(plan.layer_count())};
  for (size_t i = 1; i < points.size(); ++i) {
    const CsvPoint &from = points[i - 1], &to = points[i];
    if (!to.on || from.layer != to.layer) continue;
    const double offset = plan.heights_mm[to.layer];
    const Eigen::Vector3d a = from.place - offset * from.normal, b = to.place - offset * to.normal;
    const auto at_a = oracle.TrianglesAt(a), at_b = oracle.TrianglesAt(b);
    for (const int32_t t : at_a) {
      if (std::find(at_b.begin(), at_b.end(), t) == at_b.end()) continue;
      const Eigen::Vector2d p = MapPlaceOf(plan, t, a), q = MapPlaceOf(plan, t, b);
      worked.map_mm[to.layer] += (q - p).norm();
      if ((q - p).norm() > 1e-6)
        worked.worst_mm = std::max(
            worked.worst_mm, plan.heights_mm[to.layer] -
                                 plan.texture.heights.At(plan.placement.ToTexture((p + q) / 2)));
      break;
    }
  }
  return worked;
}

/// Returns the area of the map where the texture is at least this high, by sampling.
double AreaAbove(const EngravePlan& plan, double height_mm) {
  constexpr int kSide = 12;
  double area = 0;
  for (const auto& [a, b, c] : plan.map.mesh().triangles) {
    const auto& m = plan.map.map_mm();
    const double doubled =
        (m[b] - m[a]).x() * (m[c] - m[a]).y() - (m[b] - m[a]).y() * (m[c] - m[a]).x();
    const int side = std::clamp(static_cast<int>(8 * std::sqrt(doubled)), 3, 40 * kSide);
    int above = 0, all = 0;
    for (int i = 0; i < side; ++i) {
      for (int k = 0; k < side - i; ++k) {
        const double u = (i + 1.0 / 3) / side, v = (k + 1.0 / 3) / side;
        const Eigen::Vector2d p = m[a] + u * (m[b] - m[a]) + v * (m[c] - m[a]);
        above += plan.texture.heights.At(plan.placement.ToTexture(p)) >= height_mm;
        ++all;
      }
    }
    area += doubled / 2 * above / all;
  }
  return area;
}

class EngraveSuite : public testing::TestWithParam<size_t> {};

TEST_P(EngraveSuite, PathsLieWhereTheyShould) {
  const NamedSurface surface = SuiteSurfaces()[GetParam()];
  const SurfaceMap map = FlatMapOf(surface.mesh);
  ExpectOneToOne(map);
  const CsvOracle oracle(surface.mesh);
  const auto textures = SuiteTextures();
  int runs = 0;
  for (size_t i = 0; i < textures.size(); ++i) {
    if ((GetParam() * textures.size() + 7 * i + 5 * GetParam()) % Every() != 0) continue;
    SCOPED_TRACE(surface.name + ", " + textures[i]);
    ++runs;
    const bool joined = i % 2 == 0;
    const auto plan = PlanEngraving(
        map, *TextureOf(*ComputedHeights(*ParseTextureSpec(textures[i]))), std::nullopt,
        {.placement = {.turn_deg = 10.0 * static_cast<double>(i)},
         .layer_height_mm = 0.15,
         .lines = {{kSpacingMm, 0}, {kSpacingMm, 67}},
         .connect = joined});
    ASSERT_TRUE(plan.ok()) << plan.status();
    const auto paths = LayerPaths(*plan, 0, plan->layer_count());
    ASSERT_TRUE(paths.ok()) << paths.status();
    std::string text = kCsvHeader;
    for (const LayerPath& path : *paths) text += CsvRows(path);
    const auto points = CsvOracle::Read(text);
    ASSERT_GT(points.size(), 10u);
    ASSERT_EQ(oracle.Judge(points, plan->heights_mm), "");
    const Worked worked = MeasureWorked(*plan, oracle, points);
    EXPECT_LT(worked.worst_mm, 1e-6);
    // Lines with the requested distance cover the texture. The sum is over all layers, because the
    // area of one layer may be between its lines.
    double covered = 0, area = 0;
    for (int32_t layer = 0; layer < plan->layer_count(); ++layer) {
      covered += worked.map_mm[layer] * kSpacingMm;
      area += AreaAbove(*plan, plan->heights_mm[layer]);
    }
    EXPECT_GT(covered, 0.97 * area - 6);
    EXPECT_LT(covered, (joined ? 1.1 : 1.03) * area + 6)
        << "ways between lines count if they are joined";
  }
  EXPECT_GE(runs, Every() == 1 ? 48 : 3);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, EngraveSuite, testing::Range(size_t{0}, size_t{20}));

/// The oracle must find faults in a table.
TEST(CsvOracle, FindsFaults) {
  const SurfaceMesh mesh = Scaled(Cap(8, 0.3), 20);
  const auto plan = PlanEngraving(
      FlatMapOf(mesh), *TextureOf(*ComputedHeights(*ParseTextureSpec("bumps:detail=12"))),
      std::nullopt, {.layer_height_mm = 0.25, .lines = {{1, 0}}});
  const auto paths = LayerPaths(*plan, 0, 2);
  const CsvOracle oracle(mesh);
  std::string text = kCsvHeader;
  for (const LayerPath& path : *paths) text += CsvRows(path);
  const auto good = CsvOracle::Read(text);
  ASSERT_EQ(oracle.Judge(good, plan->heights_mm), "");
  const auto judge = [&](const std::function<void(std::vector<CsvPoint>&)>& spoil) {
    auto points = good;
    spoil(points);
    return oracle.Judge(points, plan->heights_mm);
  };
  EXPECT_NE(judge([](auto& p) { p[20].place += 1e-6 * p[20].normal; }), "") << "height";
  EXPECT_NE(judge([](auto& p) { p[20].normal = -p[20].normal; }), "") << "side";
  EXPECT_NE(judge([](auto& p) { p[20].normal = Eigen::Vector3d(0, 0, 1); }), "") << "normal";
  EXPECT_NE(judge([](auto& p) { p.erase(p.begin() + 10, p.begin() + 40); }), "") << "a gap";
  EXPECT_NE(judge([](auto& p) { std::swap(p.front(), p.back()); }), "") << "layers";
  EXPECT_TRUE(CsvOracle::Read("x,y\n1,2\n").empty());
}

}  // namespace
}  // namespace slicefarm::texture::engrave_suite_test
