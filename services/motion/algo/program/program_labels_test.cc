#include "services/motion/algo/program/program_labels.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::program_labels_test {
namespace {

TEST(ProgramLabels, OfEachSlicer) {
  ProgramLabels labels;
  EXPECT_EQ(labels.layer(), -1);
  EXPECT_TRUE(labels.Custom());
  EXPECT_FALSE(labels.Read(" a remark"));
  EXPECT_TRUE(labels.Read("LAYER_CHANGE"));
  EXPECT_FALSE(labels.Custom());
  EXPECT_TRUE(labels.Read("TYPE:External perimeter"));
  EXPECT_EQ(labels.feature(), "External perimeter");
  EXPECT_TRUE(labels.Read(" FEATURE: Outer wall"));
  EXPECT_EQ(labels.feature(), "Outer wall");
  EXPECT_TRUE(labels.Read("LAYER:7"));
  EXPECT_TRUE(labels.Read(" CHANGE_LAYER"));
  EXPECT_EQ(labels.layer(), 2);
  EXPECT_FALSE(labels.Read("LAYER_COUNT:9"));
  labels.Read("TYPE:Custom");
  EXPECT_TRUE(labels.Custom());
}

TEST(QuotedValue, OfItsKeyAlone) {
  EXPECT_EQ(QuotedValue(" filament used [mm] = 12.5 ", "filament used [mm]"), "12.5");
  EXPECT_FALSE(QuotedValue(" filament used [g] = 12.5", "filament used [mm]"));
  EXPECT_FALSE(QuotedValue("bed_shape2 = 1", "bed_shape"));
}

}  // namespace
}  // namespace slicefarm::motion::program_labels_test
