#include "services/slicing/algo/mesh_io/threemf/mesh_collector.h"

#include <gtest/gtest.h>

#include <utility>

#include "common/base/error.h"

namespace slicefarm::slicing::threemf::mesh_collector_test {
namespace {

using Attributes = std::vector<XmlAttribute>;

Attributes At(std::string_view x, std::string_view y, std::string_view z) {
  return {{"x", x}, {"y", y}, {"z", z}};
}

Attributes Corners(std::string_view a, std::string_view b, std::string_view c) {
  return {{"v1", a}, {"v2", b}, {"v3", c}};
}

TEST(MeshCollector, ConvertsWeldsAndCounts) {
  MeshReading reading = {.coordinate_limit_mm = 100};
  MeshCollector mesh(25.4, reading);
  for (const Attributes& at : {At("1", "0", "0"), At("0", "1", "0"), At("0", "0", " 1 "),
                               At("1", "-0", "0"), At("2", "2", "2")})
    ASSERT_TRUE(mesh.Vertex(at).ok());
  ASSERT_TRUE(mesh.Triangle(Corners("0", "1", "2")).ok());
  ASSERT_TRUE(mesh.Triangle(Corners("3", "2", "1")).ok());
  EXPECT_EQ(mesh.triangles(), 2);
  EXPECT_EQ(reading.triangles, 2);
  EXPECT_EQ(reading.vertices, 5);
  const RawMesh raw = std::move(mesh).Take();
  EXPECT_EQ(raw.positions, (std::vector<Vector3>{{25.4, 0, 0}, {0, 25.4, 0}, {0, 0, 25.4}}));
  EXPECT_EQ(raw.triangles, (std::vector<std::array<uint32_t, 3>>{{0, 1, 2}, {0, 2, 1}}));
}

TEST(MeshCollector, KeepsNothingOfAStructure) {
  MeshReading reading = {.keep = false, .coordinate_limit_mm = 100};
  MeshCollector mesh(1, reading);
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(mesh.Vertex(At("1", "0", "0")).ok());
  ASSERT_TRUE(mesh.Triangle(Corners("0", "1", "2")).ok());
  EXPECT_EQ(mesh.triangles(), 1);
  EXPECT_TRUE(std::move(mesh).Take().positions.empty());
}

TEST(MeshCollector, SaysWhatIsWrong) {
  struct Case {
    bool vertex;
    Attributes attributes;
    Reason want;
  };
  const std::vector<Case> cases = {
      {true, At("nan", "0", "0"), Reason::kMeshNotFinite},
      {true, At("0", "inf", "0"), Reason::kMeshNotFinite},
      {true, At("0", "1e999", "0"), Reason::kMeshNotFinite},
      {true, At("0", "0", "101"), Reason::kOutOfRange},
      {true, At("0", "0", ""), Reason::kMeshMalformed},
      {true, At("0", "0", "1,5"), Reason::kMeshMalformed},
      {true, {{"x", "0"}, {"y", "0"}}, Reason::kMeshMalformed},
      {false, Corners("0", "1", "3"), Reason::kMeshMalformed},
      {false, Corners("0", "1", "-1"), Reason::kMeshMalformed},
      {false, Corners("0", "1", "4294967296"), Reason::kMeshMalformed},
      {false, Corners("0", "1", "1000000000"), Reason::kMeshMalformed},
      {false, Corners("0", "1", "1.0"), Reason::kMeshMalformed},
      {false, {{"v1", "0"}, {"v2", "1"}}, Reason::kMeshMalformed},
  };
  for (const Case& c : cases) {
    MeshReading reading = {.coordinate_limit_mm = 100};
    MeshCollector mesh(1, reading);
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(mesh.Vertex(At("1", "0", "0")).ok());
    const absl::Status status = c.vertex ? mesh.Vertex(c.attributes) : mesh.Triangle(c.attributes);
    EXPECT_EQ(DetailOf(status).reason, c.want) << status;
  }
}

TEST(MeshCollector, CountsOverAllMeshes) {
  MeshReading reading = {.coordinate_limit_mm = 100, .triangles = 20'000'000};
  MeshCollector mesh(1, reading);
  ASSERT_TRUE(mesh.Vertex(At("1", "0", "0")).ok());
  const absl::Status status = mesh.Triangle(Corners("0", "0", "0"));
  EXPECT_EQ(DetailOf(status).reason, Reason::kMeshTooLarge);
  EXPECT_EQ(DetailOf(status).metadata["limit"], "20000000");
}

TEST(MeshCollector, NotesPaint) {
  struct Case {
    std::string_view name;
    int want;
  };
  for (const Case& c : std::initializer_list<Case>{{"slic3rpe:custom_supports", 0},
                                                   {"slic3rpe:custom_seam", 0},
                                                   {"slic3rpe:mmu_segmentation", kPaintedColours},
                                                   {"slic3rpe:fuzzy_skin", kPaintedFuzzySkin},
                                                   {"paint_supports", 0},
                                                   {"paint_seam", 0},
                                                   {"paint_color", kPaintedColours},
                                                   {"face_property", 0}}) {
    MeshReading reading = {.coordinate_limit_mm = 100};
    MeshCollector mesh(1, reading);
    ASSERT_TRUE(mesh.Vertex(At("1", "0", "0")).ok());
    Attributes triangle = Corners("0", "0", "0");
    triangle.push_back({c.name, "4"});
    ASSERT_TRUE(mesh.Triangle(triangle).ok());
    EXPECT_EQ(mesh.paint(), c.want) << c.name;
    EXPECT_FALSE(mesh.coloured());
    triangle.push_back({"pid", "1"});
    ASSERT_TRUE(mesh.Triangle(triangle).ok());
    EXPECT_TRUE(mesh.coloured());
  }
}

/// In the first triangle, one half is enforced and the other one blocked. The second triangle is
/// enforced as a whole.
TEST(MeshCollector, TakesPaintedSeamsAndSupports) {
  for (const std::string_view name :
       {"slic3rpe:custom_seam", "paint_seam", "slic3rpe:custom_supports", "paint_supports"}) {
    for (const bool keep : {true, false}) {
      MeshReading reading = {.keep = keep, .coordinate_limit_mm = 100};
      MeshCollector mesh(1, reading);
      for (const Attributes& at : {At("0", "0", "0"), At("8", "0", "0"), At("0", "8", "0")})
        ASSERT_TRUE(mesh.Vertex(at).ok());
      for (const std::string_view code : {"841", "4", "0", ""}) {
        // The paint attribute may precede or follow the corners.
        Attributes triangle = Corners("0", "1", "2");
        triangle.insert(code == "4" ? triangle.begin() : triangle.end(), {name, code});
        ASSERT_TRUE(mesh.Triangle(triangle).ok());
      }
      EXPECT_EQ(mesh.triangles(), 4);
      EXPECT_EQ(reading.triangles, 7) << "with the pieces that are painted";
      const MeshPaint marks = mesh.TakeMarks();
      const bool supports = name.ends_with("supports");
      const MarkPaint& seams = supports ? marks.supports : marks.seams;
      const MarkPaint& none = supports ? marks.seams : marks.supports;
      EXPECT_EQ(none.enforcers.triangles + none.blockers.triangles, 0);
      EXPECT_EQ(seams.enforcers.triangles, 2);
      EXPECT_EQ(seams.blockers.triangles, 1);
      EXPECT_EQ(seams.blockers.number, -1);
      if (!keep) {
        EXPECT_TRUE(seams.enforcers.mesh.positions.empty());
        continue;
      }
      EXPECT_EQ(seams.enforcers.mesh.positions,
                (std::vector<Vector3>{{4, 4, 0}, {0, 8, 0}, {0, 0, 0}, {8, 0, 0}}));
      EXPECT_EQ(seams.enforcers.mesh.triangles,
                (std::vector<std::array<uint32_t, 3>>{{0, 1, 2}, {2, 3, 1}}));
      EXPECT_EQ(seams.blockers.mesh.positions,
                (std::vector<Vector3>{{0, 0, 0}, {8, 0, 0}, {4, 4, 0}}));
    }
  }
}

TEST(MeshCollector, RefusesPaintThatIsNone) {
  MeshReading reading = {.coordinate_limit_mm = 100};
  MeshCollector mesh(1, reading);
  ASSERT_TRUE(mesh.Vertex(At("0", "0", "0")).ok());
  Attributes triangle = Corners("0", "0", "0");
  triangle.push_back({"paint_seam", "3"});
  EXPECT_EQ(DetailOf(mesh.Triangle(triangle)).reason, Reason::kMeshMalformed);
}

TEST(MeshCollector, CountsPaintOverAllMeshes) {
  MeshReading reading = {.keep = false, .coordinate_limit_mm = 100, .triangles = 19'999'998};
  MeshCollector mesh(1, reading);
  ASSERT_TRUE(mesh.Vertex(At("0", "0", "0")).ok());
  Attributes triangle = Corners("0", "0", "0");
  triangle.push_back({"paint_seam", "441"});
  EXPECT_EQ(DetailOf(mesh.Triangle(triangle)).reason, Reason::kMeshTooLarge);
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::mesh_collector_test
