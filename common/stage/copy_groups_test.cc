#include "common/stage/copy_groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::copy_groups_test {
namespace {

using testing::ElementsAre;

Instance InstanceAt(double x, double z_scale, bool placed, bool by_middle = false) {
  Instance instance;
  instance.to_plate(0, 3) = x;
  instance.to_plate(2, 2) = z_scale;
  instance.placed = placed;
  instance.by_middle = by_middle;
  return instance;
}

TEST(CopyGroups, AreOfCopiesThatDifferByAShiftAlone) {
  std::vector<Instance> instances = {InstanceAt(10, 1, true), InstanceAt(20, 2, false),
                                     InstanceAt(30, 1, true, true), InstanceAt(40, 1, true)};
  instances[3].printable = false;
  const std::vector<CopyGroup> groups = GroupsOf(instances);
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_THAT(groups[0].instances, ElementsAre(&instances[0], &instances[2]));
  EXPECT_EQ(groups[0].to_plate(0, 3), 0);
  EXPECT_EQ(groups[1].to_plate(2, 2), 2);
  EXPECT_THAT(CopiesOf(groups[0]),
              ElementsAre(CopyInput{CopyInput::Place::kOriginAt, {FromMm(10), 0}},
                          CopyInput{CopyInput::Place::kMiddleAt, {FromMm(30), 0}}));
  EXPECT_THAT(CopiesOf(groups[1]), ElementsAre(CopyInput{}));
}

}  // namespace
}  // namespace slicefarm::copy_groups_test
