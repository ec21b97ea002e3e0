#include "services/slicing/algo/mesh_io/threemf/settings/notes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::slicing::threemf::notes_test {
namespace {

TEST(Notes, NameTheFirstObjects) {
  Notes notes;
  notes.Add("painted seams", "a");
  notes.Add("drain holes", "");
  notes.Add("painted seams", "b");
  for (int i = 0; i < 10; ++i) notes.Add("parts", std::to_string(i));
  EXPECT_THAT(notes.Lines(),
              testing::ElementsAre("painted seams of `a`, `b`", "drain holes",
                                   "parts of `0`, `1`, `2`, `3`, `4`, `5`, `6`, `7` and 2 more"));
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::notes_test
