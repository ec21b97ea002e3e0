#include "services/slicing/algo/topology/edge_fans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "common/model/scene/placement.h"
#include "common/model/scene/rotation.h"
#include "services/slicing/algo/placement/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::edge_fans_test {
namespace {

/// Leaf around the z axis: a face at an angle that runs up the axis (+) or down (-).
struct Leaf {
  double degrees;
  bool up;
};

struct Paired {
  IndexedMesh mesh;
  EdgeTable table;
};

Paired PairLeaves(const std::vector<Leaf>& leaves, const std::array<double, 3>& rotate_deg = {}) {
  RawMesh raw{{{0, 0, 0}, {0, 0, 10}}, {}};
  for (const Leaf& leaf : leaves) {
    const auto [sine, cosine] = SineCosineDegrees(leaf.degrees);
    const uint32_t apex = static_cast<uint32_t>(raw.positions.size());
    // Distances and heights differ, because only the angle may matter.
    raw.positions.push_back({(3 + apex) * cosine, (3 + apex) * sine, 1.0 * apex});
    raw.triangles.push_back(leaf.up ? std::array<uint32_t, 3>{0, 1, apex}
                                    : std::array<uint32_t, 3>{1, 0, apex});
  }
  Paired result{*PlaceMesh(raw, TransformOf({.rotate_deg = rotate_deg})), {}};
  result.table = BuildEdgeTable(result.mesh.triangles, result.mesh.vertices.size());
  PairFans(result.mesh, result.table);
  return result;
}

/// Returns for each leaf the leaf it is paired with, or -1. The half-edge on the axis is the first
/// of each face.
std::vector<int> Partners(const Paired& paired) {
  std::vector<int> partners;
  for (size_t leaf = 0; leaf < paired.mesh.triangles.size(); ++leaf) {
    const uint32_t twin = paired.table.twins[3 * leaf];
    partners.push_back(twin == kNoTwin ? -1 : static_cast<int>(FaceOf(twin)));
  }
  return partners;
}

struct Case {
  const char* name;
  std::vector<Leaf> leaves;
  std::vector<int> want;
};

// Material is clockwise of a face that runs up: from "down" at the smaller angle to "up" at the
// larger one.
const std::vector<Case>& Cases() {
  static const auto* cases = new std::vector<Case>{
      {"TwoWedges", {{10, false}, {80, true}, {190, false}, {260, true}}, {1, 0, 3, 2}},
      {"TwoGaps", {{10, true}, {80, false}, {190, true}, {260, false}}, {3, 2, 1, 0}},
      {"OneInTheOther", {{10, false}, {30, false}, {50, true}, {90, true}}, {3, 2, 1, 0}},
      {"SharedSide", {{0, false}, {90, true}, {90, false}, {180, true}}, {1, 0, 3, 2}},
      {"OverTheStart", {{350, false}, {20, true}, {100, false}, {120, true}}, {1, 0, 3, 2}},
      {"Opposite", {{0, false}, {180, true}, {180, false}, {0, true}}, {1, 0, 3, 2}},
      {"ThreeWedges",
       {{0, false}, {30, true}, {120, false}, {150, true}, {240, false}, {270, true}},
       {1, 0, 3, 2, 5, 4}},
      {"OneTooMany", {{10, false}, {80, true}, {190, false}}, {1, 0, -1}},
      {"AllAlike", {{10, false}, {80, false}, {190, false}}, {-1, -1, -1}},
  };
  return *cases;
}

TEST(PairFans, PairsTheSidesOfEachWedge) {
  for (const Case& c : Cases()) EXPECT_EQ(Partners(PairLeaves(c.leaves)), c.want) << c.name;
}

TEST(PairFans, DoesNotDependOnHowTheMeshLies) {
  for (const Case& c : Cases())
    for (const std::array<double, 3>& turn :
         {std::array{90.0, 0.0, 0.0}, {180.0, 0.0, 0.0}, {0.0, 90.0, 90.0}, {0.0, 0.0, 180.0}})
      EXPECT_EQ(Partners(PairLeaves(c.leaves, turn)), c.want) << c.name;
}

TEST(PairFans, DoesNotDependOnTheOrderOfTheFaces) {
  for (const Case& c : Cases()) {
    std::vector<size_t> order(c.leaves.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = i;
    do {
      std::vector<Leaf> leaves;
      for (const size_t i : order) leaves.push_back(c.leaves[i]);
      const std::vector<int> partners = Partners(PairLeaves(leaves));
      for (size_t i = 0; i < order.size(); ++i) {
        const int want = c.want[order[i]];
        EXPECT_EQ(partners[i] < 0 ? -1 : static_cast<int>(order[partners[i]]), want) << c.name;
      }
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

/// Faces without area have no angle, but their half-edges are still used.
TEST(PairFans, TakesFlatFaces) {
  RawMesh raw{{{0, 0, 0}, {0, 0, 10}, {0, 0, 5}, {4, 0, 0}, {0, 4, 0}},
              {{0, 1, 2}, {1, 0, 2}, {1, 0, 3}, {0, 1, 4}}};
  Paired paired{*PlaceMesh(raw), {}};
  paired.table = BuildEdgeTable(paired.mesh.triangles, paired.mesh.vertices.size());
  ASSERT_EQ(paired.table.fan_count(), 1);
  PairFans(paired.mesh, paired.table);
  for (uint32_t face = 0; face < 4; ++face) {
    const uint32_t twin = paired.table.twins[3 * face];
    ASSERT_NE(twin, kNoTwin);
    EXPECT_EQ(paired.table.twins[twin], 3 * face);
  }
}

}  // namespace
}  // namespace slicefarm::slicing::edge_fans_test
