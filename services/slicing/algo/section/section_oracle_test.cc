#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "common/geometry/measure.h"
#include "common/model/scene/placement.h"
#include "common/stage/slice_input_test.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"
#include "services/slicing/algo/placement/placement.h"
#include "services/slicing/algo/sample_meshes_test.h"
#include "services/slicing/algo/section/layer_heights.h"
#include "tests/corpus_file.h"

namespace slicefarm::slicing::section_oracle_test {
namespace {

/// Test oracle for points of a layer: decides from the triangles themselves whether a point is
/// inside the part. A ray straight up counts how often it leaves the part minus how often it enters
/// it. The oracle shares no code with the sweep.
class SolidOracle {
 public:
  explicit SolidOracle(IndexedMesh mesh) : mesh_(std::move(mesh)) {}

  int WindingNumber(Point p, Coord z) const {
    int winding = 0;
    for (const auto& t : mesh_.triangles) winding += Passes(t, p, z);
    return winding;
  }

  Box BoundsXy() const {
    const auto [min, max] = ExtentOf(mesh_);
    return {{min.x, min.y}, {max.x, max.y}};
  }

 private:
  int Passes(const std::array<uint32_t, 3>& t, Point p, Coord z) const {
    const Vertex &a = mesh_.vertices[t[0]], &b = mesh_.vertices[t[1]], &c = mesh_.vertices[t[2]];
    const auto side = [p](const Vertex& from, const Vertex& to) {
      return static_cast<double>(to.x - from.x) * static_cast<double>(p.y - from.y) -
             static_cast<double>(to.y - from.y) * static_cast<double>(p.x - from.x);
    };
    const double wc = side(a, b), wa = side(b, c), wb = side(c, a);
    const bool up = wa > 0 && wb > 0 && wc > 0, down = wa < 0 && wb < 0 && wc < 0;
    if (!up && !down) return 0;
    const double height = (wa * static_cast<double>(a.z) + wb * static_cast<double>(b.z) +
                           wc * static_cast<double>(c.z)) /
                          (wa + wb + wc);
    if (height <= static_cast<double>(z)) return 0;
    return up ? 1 : -1;
  }

  IndexedMesh mesh_;
};

bool IsInside(Point p, const MultiPolygon& outlines) {
  for (const PolygonWithHoles& island : outlines)
    if (Locate(p, island) == Side::kInside) return true;
  return false;
}

double DistanceToOutlines(Point p, const MultiPolygon& outlines) {
  double nearest = HUGE_VAL;
  for (const Polygon& ring : Rings(outlines))
    for (size_t i = 0; i < ring.size(); ++i)
      nearest = std::min(nearest, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
  return nearest;
}

void ExpectLayersMatch(const std::string& name, const std::string& bytes) {
  const MeshFile file{name, MeshFormat::kUnknown, bytes};
  const Placement at_origin{.centers = {{0, 0}}};
  SlicingOptions options;
  options.bed = {};
  const auto job = MakeLocalSlicing()->Slice({}, InputOf({file}, {at_origin}), options);
  ASSERT_TRUE(job.ok()) << name << job.status();
  const SolidOracle oracle(
      *PlaceMesh(*ReadMesh(file.bytes, file.format, 1e4, {}), TransformOf(at_origin)));
  const Box box = oracle.BoundsXy();
  std::mt19937 random(7);
  const auto between = [&random](Coord low, Coord high) {
    return low + static_cast<Coord>(random() * static_cast<double>(high - low) / 4294967296.0);
  };
  int inside = 0, compared = 0;
  for (int sample = 0; sample < 150; ++sample) {
    const SlicedLayer& layer = job->layers[random() % job->layers.size()];
    const MultiPolygon& outlines = OutlineOf(layer.sections.at(0));
    const Point p{between(box.min.x, box.max.x), between(box.min.y, box.max.y)};
    // Simplification moves the outline by up to outline_resolution.
    if (DistanceToOutlines(p, outlines) < 6'000) continue;
    const Coord z = layer.frame.print_z_nm - layer.frame.height_nm / 2;
    const bool want = oracle.WindingNumber(p, z) != 0;
    EXPECT_EQ(IsInside(p, outlines), want)
        << name << " layer " << layer.frame.index << " at " << p.x << " " << p.y;
    inside += want;
    ++compared;
  }
  EXPECT_GT(compared, 120) << name;
  EXPECT_GT(inside, 10) << name;
  EXPECT_LT(inside, compared - 10) << name;
}

TEST(SectionOracle, AgreesOnMadeShapes) {
  const RawMesh two = Joined(TorusMesh({}), BoxMesh({0, -35, 2}, {12, 10, 16}));
  ExpectLayersMatch("torus and box", ToBinaryStl(two));
  ExpectLayersMatch("torus on its planes", ToBinaryStl(TorusMesh({.snap_to_layer = 0.2})));
  ExpectLayersMatch("tetrahedron", ToBinaryStl(TetrahedronMesh(30)));
}

TEST(SectionOracle, AgreesOnModels) {
  for (const char* name :
       {"benchy.stl", "spot.stl", "featuretype.stl", "busted.stl", "textbox.stl"})
    ExpectLayersMatch(name, CorpusFile(std::string("models/") + name));
}

}  // namespace
}  // namespace slicefarm::slicing::section_oracle_test
