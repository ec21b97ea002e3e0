#include "services/slicing/algo/mesh_io/threemf/transform_text.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "common/base/error.h"

namespace slicefarm::slicing::threemf::transform_text_test {
namespace {

TEST(ParseTransform, IsARowVectorsMatrix) {
  // The transform is a quarter turn to the left about z, then a translation.
  const auto turn = ParseTransform("0 1 0 -1 0 0 0 0 1 10 20 30", 25.4);
  ASSERT_TRUE(turn.ok()) << turn.status();
  const Eigen::Vector3d moved = *turn * Eigen::Vector4d(1, 0, 0, 1);
  EXPECT_NEAR(moved.x(), 254, 1e-9);
  EXPECT_NEAR(moved.y(), 1 + 508, 1e-9);
  EXPECT_NEAR(moved.z(), 762, 1e-9);
}

TEST(ParseTransform, SaysWhatIsWrong) {
  struct Case {
    std::string text;
    Reason want;
  };
  const std::vector<Case> cases = {
      {"", Reason::kMeshMalformed},
      {"1 0 0 0 1 0 0 0 1 0 0", Reason::kMeshMalformed},
      {"1 0 0 0 1 0 0 0 1 0 0 0 0", Reason::kMeshMalformed},
      {"1 0 0 0 1 0 0 0 one 0 0 0", Reason::kMeshMalformed},
      {"nan 0 0 0 1 0 0 0 1 0 0 0", Reason::kMeshNotFinite},
      {"1 0 0 0 1 0 0 0 1 0 0 inf", Reason::kMeshNotFinite},
      {"1 0 0 0 1 0 0 0 1 0 0 1e300", Reason::kOutOfRange},
      {"1 0 0 0 1 0 0 0 0 0 0 0", Reason::kMeshMalformed},
      {"1 2 3 2 4 6 0 0 1 0 0 0", Reason::kMeshMalformed},
      {"0 0 0 0 0 0 0 0 0 0 0 0", Reason::kMeshMalformed},
  };
  for (const Case& c : cases)
    EXPECT_EQ(DetailOf(ParseTransform(c.text, 1).status()).reason, c.want) << c.text;
  EXPECT_TRUE(ParseTransform("-1 0 0 0 1 0 0 0 1 0 0 0", 1).ok()) << "mirrored";
  EXPECT_TRUE(ParseTransform("1e-4 0 0 0 1e-4 0 0 0 1e-4 0 0 0", 1).ok()) << "small";
}

TEST(Composed, IsOneAfterTheOther) {
  const Transform a = *ParseTransform("0 1 0 -1 0 0 0 0 1 10 20 30", 1);
  const Transform b = *ParseTransform("2 0 0 0 3 0 0 1 4 1 2 3", 1);
  const Eigen::Vector3d point(5, 6, 7);
  const Eigen::Vector3d inner = b * point.homogeneous();
  const Eigen::Vector3d both = Composed(a, b) * point.homogeneous();
  EXPECT_LT((both - a * inner.homogeneous()).norm(), 1e-9);
}

TEST(CheckTransform, RefusesWhatOverflows) {
  Transform transform = Transform::Identity();
  EXPECT_TRUE(CheckTransform(transform).ok());
  transform(0, 0) = 1e7;
  EXPECT_EQ(DetailOf(CheckTransform(transform)).reason, Reason::kOutOfRange);
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::transform_text_test
