#include "common/model/milling/mill_input.h"

#include <gtest/gtest.h>

#include <set>

namespace slicefarm::mill_input_test {
namespace {

TEST(DigestOf, TellsMeshesApart) {
  const IndexedMesh a = {{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {{0, 1, 2}}};
  IndexedMesh moved = a, turned = a;
  moved.vertices[1].z = 1;
  turned.triangles[0] = {0, 2, 1};
  const std::set<std::string> digests = {DigestOf(a, {}), DigestOf({}, a), DigestOf(a, a),
                                         DigestOf(moved, {}), DigestOf(turned, {})};
  EXPECT_EQ(digests.size(), 5u);
  EXPECT_EQ(DigestOf(a, moved), DigestOf(a, moved));
}

}  // namespace
}  // namespace slicefarm::mill_input_test
