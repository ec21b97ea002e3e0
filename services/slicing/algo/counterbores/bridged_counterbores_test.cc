#include "services/slicing/algo/counterbores/bridged_counterbores.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/stage/slice_input_test.h"
#include "services/slicing/algo/counterbores/shapes_test.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "services/slicing/algo/mesh_reader/mesh_source.h"
#include "services/slicing/algo/sample_meshes_test.h"

namespace slicefarm::slicing::bridged_counterbores_test {
namespace {

using namespace counterbore_shapes_test;  // NOLINT(google-build-using-namespace)
using enum CounterboreBridging;

MultiPolygon Plate() { return {{Box(-10, -10, 20, 20), {}}}; }

ObjectSection SectionOf(MultiPolygon outlines) {
  ObjectSection section;
  section.regions = {{.outlines = std::move(outlines)}};
  return section;
}

/// Returns sections with a recess of two layers, then a smaller hole through `holed` layers, then a
/// lid.
std::vector<ObjectSection> Bored(int holed) {
  const MultiPolygon recess = Difference(Plate(), {{Disc(0, 0, 3), {}}});
  const MultiPolygon hole = Difference(Plate(), {{Disc(0, 0, 1.7), {}}});
  std::vector<ObjectSection> sections = {SectionOf(recess), SectionOf(recess)};
  for (int i = 0; i < holed; ++i) sections.push_back(SectionOf(hole));
  sections.push_back(SectionOf(Plate()));
  return sections;
}

std::vector<ObjectSection> Bridged(CounterboreBridging how, std::vector<ObjectSection> sections,
                                   int threads = 1) {
  std::vector<ObjectSection*> stack;
  for (ObjectSection& section : sections) stack.push_back(&section);
  BridgeCounterbores(how, stack, threads);
  return sections;
}

/// Returns the open area of each layer.
std::vector<double> OpenMm2(const std::vector<ObjectSection>& sections) {
  std::vector<double> open;
  for (const ObjectSection& section : sections)
    open.push_back(Mm2(Difference(Plate(), OutlineOf(section))));
  return open;
}

void ExpectOpen(const std::vector<ObjectSection>& sections, const std::vector<double>& want_mm2) {
  const std::vector<double> open = OpenMm2(sections);
  ASSERT_EQ(open.size(), want_mm2.size());
  for (size_t i = 0; i < open.size(); ++i) EXPECT_NEAR(open[i], want_mm2[i], 0.15) << i;
}

TEST(BridgeCounterbores, NothingUnlessAsked) { EXPECT_EQ(Bridged(kNone, Bored(5)), Bored(5)); }

TEST(BridgeCounterbores, SlotSquareOctagonHole) {
  ExpectOpen(Bridged(kPartial, Bored(5)), {28.27, 28.27, 19.3, 11.56, 9.58, 9.08, 9.08, 0});
}

TEST(BridgeCounterbores, NothingIsOpenedBeyondTheHole) {
  for (const auto how : {kPartial, kSacrificial}) EXPECT_EQ(Bridged(how, Bored(1)), Bored(1));
  ExpectOpen(Bridged(kPartial, Bored(2)), {28.27, 28.27, 19.3, 11.56, 0});
}

TEST(BridgeCounterbores, ASacrificialLayerClosesTheHoleOnce) {
  ExpectOpen(Bridged(kSacrificial, Bored(3)), {28.27, 28.27, 0, 9.08, 9.08, 0});
}

TEST(BridgeCounterbores, RegionsStayTiles) {
  const MultiPolygon right = {{Box(0.5, -10, 9.5, 20), {}}};
  for (const CounterboreBridging how : {kPartial, kSacrificial}) {
    std::vector<ObjectSection> sections = Bored(5);
    for (ObjectSection& section : sections) {
      section.whole = section.regions[0].outlines;
      section.regions = {{.settings = 0, .outlines = Difference(section.whole, right)},
                         {.settings = 1, .outlines = Intersection(section.whole, right)}};
    }
    const std::vector<ObjectSection> plain = Bridged(how, Bored(5));
    sections = Bridged(how, std::move(sections));
    for (size_t i = 0; i < sections.size(); ++i) {
      EXPECT_EQ(sections[i].whole, plain[i].regions[0].outlines) << i;
      ASSERT_EQ(sections[i].regions.size(), 2U);
      const MultiPolygon &a = sections[i].regions[0].outlines, &b = sections[i].regions[1].outlines;
      EXPECT_NEAR(Mm2(a) + Mm2(b), Mm2(sections[i].whole), 1e-4) << i;
      EXPECT_LT(Mm2(Intersection(a, b)), 1e-4) << i;
    }
  }
}

TEST(BridgeCounterbores, HollowSectionsStay) {
  std::vector<ObjectSection> sections = Bored(5);
  for (ObjectSection& section : sections) section.hollow = true;
  EXPECT_EQ(Bridged(kPartial, sections), sections);
}

TEST(BridgeCounterbores, ThreadsChangeNothing) {
  EXPECT_EQ(Bridged(kPartial, Bored(9), 4), Bridged(kPartial, Bored(9)));
}

/// Returns a cube of 20 mm with a recess of 10 by 10 by 10 mm and a hole of 4 by 4 by 2 mm above
/// it.
SliceInput BoredCube() {
  SliceInput input;
  for (const RawMesh& mesh : {Cube(0, 0, 0, 20), Cube(5, 5, 0, 10), Cube(8, 8, 8, 4)})
    input.files.push_back({"part", MeshFormat::kUnknown, ToBinaryStl(mesh)});
  input = InputOf(std::move(input.files), {Placement{}});
  ObjectInput& object = input.objects[0];
  object.parts.resize(3, object.parts[0]);
  for (const int32_t i : {1, 2}) {
    object.parts[static_cast<size_t>(i)].mesh.file = i;
    object.parts[static_cast<size_t>(i)].role = PartRole::kNegative;
  }
  input.objects.resize(1);
  return input;
}

TEST(BridgeCounterbores, OfObjectsThatAskForIt) {
  for (const auto& [how, open_mm2] :
       {std::pair(kNone, 16.0), std::pair(kPartial, 40.0), std::pair(kSacrificial, 0.0)}) {
    SlicingOptions options;
    options.objects[0].counterbores = how;
    const auto job = MakeLocalSlicing(MakeDirectMeshSource())->Slice({}, BoredCube(), options);
    ASSERT_TRUE(job.ok()) << job.status();
    const auto covered_mm2 = [&](size_t layer) {
      return Mm2(OutlineOf(job->layers[layer].sections[0]));
    };
    EXPECT_NEAR(covered_mm2(49), 300, 1e-6);
    EXPECT_NEAR(covered_mm2(50), 400 - open_mm2, 1e-3);
    EXPECT_NEAR(covered_mm2(51), 400 - 16, 1e-3);
  }
}

}  // namespace
}  // namespace slicefarm::slicing::bridged_counterbores_test
