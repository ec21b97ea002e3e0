#include "services/texture/algo/output/engrave_program.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <numbers>
#include <sstream>

#include "common/base/error.h"
#include "services/texture/algo/paths/sample_maps_test.h"
#include "services/texture/algo/pattern/computed_heights.h"

namespace slicefarm::texture::engrave_program_test {
namespace {

std::vector<LayerPath> PathsOver(const SurfaceMesh& mesh) {
  const auto plan = PlanEngraving(
      FlatMapOf(mesh), *TextureOf(*ComputedHeights(*ParseTextureSpec("bumps:height=0.4,pitch=3"))),
      std::nullopt, {.layer_height_mm = 0.2, .lines = {{0.5, 20}}});
  return *LayerPaths(*plan, 0, 2);
}

/// Returns a half cylinder on its side, with its axis along y: normals from -x over z to x.
SurfaceMesh Barrel() { return HalfCylinder(12, 10, 12); }

/// Reader of programs for this test: converts words to values, with one step per line.
struct Step {
  std::map<char, double> at;  ///< all axes after the move
  double inverse_minutes = 0;
  bool on = false;
  bool feed = false;
};

std::vector<Step> StepsOf(const std::string& program) {
  std::vector<Step> steps;
  Step now;
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("(")) continue;
    std::istringstream words(line);
    bool moves = false;
    for (std::string word; words >> word;) {
      if (word == "M3") now.on = true;
      if (word == "M5") now.on = false;
      if (word == "G0" || word == "G1") now.feed = word == "G1";
      if (std::string("XYZABC").find(word[0]) == std::string::npos && word[0] != 'F') continue;
      const double value = std::stod(word.substr(1));
      if (word[0] == 'F')
        now.inverse_minutes = value;
      else
        now.at[word[0]] = value;
      moves = true;
    }
    if (moves) steps.push_back(now);
  }
  return steps;
}

Eigen::Matrix3d About(const Eigen::Vector3d& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis).toRotationMatrix();
}

/// Returns the position of the tip on the part, computed from the meaning of the axes.
Eigen::Vector3d TipOf(const AxisOptions& axes, Step step) {
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  const Eigen::Vector3d xyz(step.at['X'], step.at['Y'], step.at['Z']);
  const Eigen::Matrix3d a = About(x, step.at['A']), b = About(y, step.at['B']),
                        c = About(z, step.at['C']);
  switch (axes.layout) {
    case AxisLayout::kNone:
      return xyz;
    case AxisLayout::kTableAb:
      return (a * b).inverse() * (xyz - axes.centre_mm) + axes.centre_mm;
    case AxisLayout::kTableBc:
      return (b * c).inverse() * (xyz - axes.centre_mm) + axes.centre_mm;
    case AxisLayout::kHeadAb:
      return xyz - axes.pivot_mm * (b * a * z - z);
    case AxisLayout::kHeadBc:
      return xyz - axes.pivot_mm * (c * b * z - z);
  }
  return xyz;
}

class EveryLayout : public testing::TestWithParam<AxisLayout> {};

/// Each point must be reached within 1 um, in order, and the path between points must stay within
/// the tolerance.
TEST_P(EveryLayout, TheProgramReplaysThePaths) {
  const auto paths = PathsOver(Barrel());
  const ProgramOptions options{
      .axes = {.layout = GetParam(), .centre_mm = {1, 2, -30}, .tilt_deg = 120}};
  EngraveProgram program(options, 80);
  std::string text = program.Start();
  for (const LayerPath& path : paths) {
    const auto layer = program.Layer(path);
    ASSERT_TRUE(layer.ok()) << layer.status();
    text += *layer;
  }
  text += program.End();
  const auto steps = StepsOf(text);
  size_t at = 0;
  std::optional<Step> before;
  for (const LayerPath& path : paths) {
    for (size_t i = 0; i < path.points.size(); ++i) {
      const ToolPoint& point = path.points[i];
      if (before && (TipOf(options.axes, *before) - point.place_mm).norm() < 1e-3) continue;
      bool met = false;
      for (; at < steps.size() && !met; ++at) {
        const Eigen::Vector3d tip = TipOf(options.axes, steps[at]);
        met = (tip - point.place_mm).norm() < 1e-3;
        if (before && steps[at].feed) {  // halfway, as the controller moves
          Step half = steps[at];
          for (auto& [axis, value] : half.at) value = (value + before->at[axis]) / 2;
          const Eigen::Vector3d middle = (TipOf(options.axes, *before) + tip) / 2;
          ASSERT_LT((TipOf(options.axes, half) - middle).norm(), options.tolerance_mm + 1e-4);
          if ((tip - TipOf(options.axes, *before)).norm() > 2e-3) {  // else it may be skipped above
            ASSERT_EQ(steps[at].on, point.on);
          }
        }
        before = steps[at];
      }
      ASSERT_TRUE(met) << "layer " << path.layer << ", point " << i << " is not met";
    }
  }
  EXPECT_GT(program.facts().moves, 1000);
}

std::string NameOf(const testing::TestParamInfo<AxisLayout>& layout) {
  const char* const names[] = {"None", "TableAb", "TableBc", "HeadAb", "HeadBc"};
  return names[static_cast<size_t>(layout.param)];
}

INSTANTIATE_TEST_SUITE_P(Machines, EveryLayout,
                         testing::Values(AxisLayout::kTableAb, AxisLayout::kTableBc,
                                         AxisLayout::kHeadAb, AxisLayout::kHeadBc),
                         NameOf);

TEST(EngraveProgram, KeepsTheTipsSpeedByInverseTime) {
  const auto paths = PathsOver(Barrel());
  const ProgramOptions options{.turn_deg_min = 1e6};
  EngraveProgram program(options, 80);
  std::string text = program.Start() + *program.Layer(paths[0]);
  const auto steps = StepsOf(text);
  int fast = 0;
  for (size_t i = 1; i < steps.size(); ++i) {
    if (!steps[i].on || !steps[i].feed) continue;
    const double length =
        (TipOf(options.axes, steps[i]) - TipOf(options.axes, steps[i - 1])).norm();
    if (length > 0.1) {
      ++fast;
      EXPECT_NEAR(length * steps[i].inverse_minutes, options.feed_mm_min, 2);
    }
  }
  EXPECT_GT(fast, 100);
}

TEST(EngraveProgram, WithoutRotaryAxesSteepSurfacesAreRefused) {
  const auto paths = PathsOver(Barrel());
  EngraveProgram program({.axes = {.layout = AxisLayout::kNone}}, 40);
  const auto text = program.Layer(paths[0]);
  ASSERT_FALSE(text.ok());
  EXPECT_EQ(DetailOf(text.status()).reason, Reason::kOutOfRange);
  const auto flat = PathsOver(FlatSquare(3, 12));
  EngraveProgram easy({.axes = {.layout = AxisLayout::kNone}}, 40);
  EXPECT_TRUE(easy.Layer(flat[0]).ok());
}

TEST(EngraveProgram, LimitsOfAxesAreNamedWithThePlace) {
  EngraveProgram program({.axes = {.layout = AxisLayout::kTableBc, .tilt_deg = 30}}, 80);
  const auto text = program.Layer(PathsOver(Barrel())[0]);
  ASSERT_FALSE(text.ok());
  EXPECT_NE(text.status().message().find("30 degrees that B and C"), std::string::npos);
}

TEST(EngraveProgram, ALayersTextDependsOnNoOther) {
  const auto paths = PathsOver(Barrel());
  EngraveProgram one({}, 80), other({}, 80);
  const auto first = one.Layer(paths[0]), second = one.Layer(paths[1]);
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_EQ(*other.Layer(paths[1]), *second);
}

TEST(SafeHeight, IsAboveAPartHoweverItIsTurned) {
  const auto plan = PlanEngraving(MapFromAbove(FlatSquare(2, 30)),
                                  *TextureOf(*ComputedHeights(*ParseTextureSpec("bumps:height=2"))),
                                  std::nullopt, {});
  ASSERT_TRUE(plan.ok());
  ProgramOptions options{.axes = {.layout = AxisLayout::kTableBc, .centre_mm = {0, 0, -10}},
                         .safe_mm = 5};
  EXPECT_NEAR(SafeHeight(*plan, options), -10 + std::sqrt(1900.0) + 2 + 5, 1e-9);
  options.axes.layout = AxisLayout::kHeadBc;
  EXPECT_NEAR(SafeHeight(*plan, options), 2 + 5, 1e-9);
}

TEST(EngraveProgram, AnExtruderLaysDownWhatLinesTake) {
  const auto paths = PathsOver(FlatSquare(3, 12));
  EngraveProgram program(
      {.axes = {.layout = AxisLayout::kNone}, .tool = ToolKind::kExtruder, .layer_mm = 0.2}, 40);
  const auto text = program.Layer(paths[0]);
  ASSERT_TRUE(text.ok());
  const double volume = paths[0].on_mm * 0.5 * 0.2;
  EXPECT_NEAR(program.facts().filament_mm * std::numbers::pi * 1.75 * 1.75 / 4, volume,
              1e-3 * volume);
}

}  // namespace
}  // namespace slicefarm::texture::engrave_program_test
