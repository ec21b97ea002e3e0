#include "services/motion/algo/firmware/numbered_objects.h"

#include <gtest/gtest.h>

#include "services/motion/algo/firmware/marlin.h"

namespace slicefarm::motion::numbered_objects_test {
namespace {

TEST(NumberedObjects, ByNumberWithTheirNamesOnce) {
  GcodeText out;
  const std::vector<std::string> labels = {"a", "b (Instance 2)"};
  const std::vector<CopySummary> copies(2);
  Marlin2().DefineCopies(copies, labels, out);
  Marlin2().BeginCopy(labels[1], 1, out);
  Marlin2().EndCopy(labels[1], 1, out);
  EXPECT_EQ(out.text(),
            "M486 T2\nM486 S0\nM486 Aa\nM486 S-1\nM486 S1\nM486 Ab (Instance 2)\n"
            "M486 S-1\nM486 S1\nM486 S-1\n");
  EXPECT_EQ(Marlin2().LabelOf("my part", 7), "my part");
}

}  // namespace
}  // namespace slicefarm::motion::numbered_objects_test
