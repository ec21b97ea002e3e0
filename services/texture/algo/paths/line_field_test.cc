#include "services/texture/algo/paths/line_field.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/texture/algo/paths/sample_maps_test.h"

namespace slicefarm::texture::line_field_test {
namespace {

TEST(CentredLevels, LeaveEqualMargins) {
  const auto expect = [](double low, double high, double spacing, std::vector<double> want) {
    const auto levels = CentredLevels(low, high, spacing);
    ASSERT_EQ(levels.size(), want.size());
    for (size_t i = 0; i < want.size(); ++i) EXPECT_NEAR(levels[i], want[i], 1e-12);
  };
  expect(0, 10, 3, {2, 5, 8});
  expect(0, 9, 3, {1.5, 4.5, 7.5});
  expect(0, 1, 3, {0.5});
  expect(-4, 6, 3, {-2, 1, 4});
}

/// Returns the share of the surface's area where the distance of lines is within 10 % of the
/// requested one.
double EvenShare(const SurfaceMap& map, const std::vector<double>& field) {
  double even = 0, all = 0;
  for (size_t t = 0; t < map.mesh().triangles.size(); ++t) {
    const double area = DoubleAreaVector(map.mesh(), t).norm();
    all += area;
    if (std::abs(1 / GradientLength(map, field, static_cast<int32_t>(t)) - 1) <= 0.1) even += area;
  }
  return even / all;
}

TEST(StraightField, IsEvenOnWhatCanBeLaidFlat) {
  const SurfaceMap map = FlatMapOf(HalfCylinder(12, 5, 9));
  EXPECT_GT(EvenShare(map, StraightField(map, {0.8, 0.6})), 0.999);
}

TEST(EquidistantField, IsEvenWhereAStraightOneIsNot) {
  for (const double lowest : {0.0, -0.5}) {
    const SurfaceMap map = FlatMapOf(Cap(20, lowest));
    const auto field = EquidistantField(map, {1, 0});
    ASSERT_TRUE(field.ok()) << field.status();
    EXPECT_GT(EvenShare(map, *field), 0.955) << lowest;
    EXPECT_LT(EvenShare(map, StraightField(map, {1, 0})), 0.8) << lowest;
  }
}

TEST(EquidistantField, KeepsItsDirection) {
  const SurfaceMap map = FlatMapOf(HalfCylinder(12, 5, 9));
  const auto field = EquidistantField(map, {1, 0});
  ASSERT_TRUE(field.ok());
  const auto straight = StraightField(map, {1, 0});
  for (size_t i = 0; i < field->size(); ++i)
    EXPECT_NEAR((*field)[i] - (*field)[0], straight[i] - straight[0], 0.05);
}

TEST(EquidistantField, CanBeCancelled) {
  const SurfaceMap map = MapFromAbove(FlatSquare(3, 3));
  const auto field = EquidistantField(map, {1, 0}, CancelToken([] { return true; }));
  EXPECT_EQ(DetailOf(field.status()).reason, Reason::kCancelled);
}

}  // namespace
}  // namespace slicefarm::texture::line_field_test
