#include "services/slicing/algo/mesh_io/threemf/threemf_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive_files_test.h"
#include "services/slicing/algo/mesh_reader/mesh_reader.h"
#include "tests/corpus_file.h"

namespace slicefarm::slicing::threemf::threemf_reader_test {
namespace {

using testing::ElementsAre;

absl::StatusOr<MeshFileContents> Read(const std::string& bytes,
                                      ReadDepth depth = ReadDepth::kMeshes) {
  return ReadMeshFile(bytes, MeshFormat::kUnknown, 10'000, depth, {});
}

absl::StatusOr<MeshFileContents> Read(const Files& files) { return Read(Zipped(files)); }

Setting Of(std::string key, std::string value) {
  return {std::move(key), std::move(value), Source::kProfile};
}

TEST(Read3mf, ReadsAPartOfACadProgram) {
  const auto contents = Read(CubeFiles());
  ASSERT_TRUE(contents.ok()) << contents.status();
  ASSERT_EQ(contents->meshes.size(), 1u);
  EXPECT_EQ(contents->meshes[0].triangles.size(), 12u);
  ASSERT_EQ(contents->project.objects.size(), 1u);
  EXPECT_FALSE(contents->project.objects[0].instances[0].placed);
  EXPECT_TRUE(contents->project.without_effect.empty());
}

TEST(Read3mf, ReadsUnits) {
  struct Case {
    std::string_view unit;
    double mm;
  };
  for (const Case& c : std::initializer_list<Case>{{"micron", 0.001},
                                                   {"millimeter", 1},
                                                   {"centimeter", 10},
                                                   {"inch", 25.4},
                                                   {"foot", 304.8},
                                                   {"meter", 1000}}) {
    const auto contents =
        Read({{kModelName, ModelXml(ObjectXml(1, MeshXml(Cube(0, 0, 0, 1))),
                                    Item(1, "transform=\"1 0 0 0 1 0 0 0 1 2 0 0\""),
                                    fmt::format("unit=\"{}\"", c.unit))}});
    ASSERT_TRUE(contents.ok()) << contents.status();
    double largest = 0;
    for (const Vector3& p : contents->meshes[0].positions) largest = std::max(largest, p.x());
    EXPECT_DOUBLE_EQ(largest, c.mm) << c.unit;
    EXPECT_DOUBLE_EQ(contents->project.objects[0].instances[0].to_plate(0, 3), 2 * c.mm);
  }
}

TEST(Read3mf, ReadsAProjectOfPrusaSlicer) {
  const auto contents = Read(PrusaFiles());
  ASSERT_TRUE(contents.ok()) << contents.status();
  const Project& project = contents->project;
  EXPECT_EQ(project.application, "PrusaSlicer-2.9.2");
  EXPECT_EQ(project.dialect, SettingsDialect::kPrusa);
  EXPECT_THAT(project.settings,
              ElementsAre(Of("layer_height", "0.2"), Of("start_gcode", "G28\\nG1 Z5")));
  EXPECT_TRUE(project.plates.empty());
  ASSERT_EQ(project.objects.size(), 2u);
  const SceneObject& bracket = project.objects[0];
  EXPECT_EQ(bracket.name, "Bracket");
  EXPECT_THAT(bracket.settings, ElementsAre(Of("perimeters", "4")));
  ASSERT_EQ(bracket.parts.size(), 2u);
  EXPECT_EQ(bracket.parts[0].mesh, (MeshRef{0, 0, 0, 12}));
  EXPECT_EQ(bracket.parts[0].to_object, Transform(Transform::Identity()))
      << "its triangles lie in the object already";
  EXPECT_EQ(bracket.parts[1].mesh, (MeshRef{0, 0, 12, 12}));
  EXPECT_EQ(bracket.parts[1].role, PartRole::kModifier);
  EXPECT_THAT(bracket.parts[1].settings, ElementsAre(Of("fill_density", "80%")));
  ASSERT_EQ(bracket.instances.size(), 2u) << "a component that is not moved is a copy";
  EXPECT_TRUE(bracket.instances[0].placed);
  EXPECT_EQ(bracket.instances[0].to_plate(1, 3), 60);
  EXPECT_FALSE(bracket.instances[1].printable);
  EXPECT_EQ(bracket.instances[1].to_plate(1, 0), 1);
  const SceneObject& block = project.objects[1];
  EXPECT_EQ(block.parts[0].mesh, (MeshRef{0, 1, 0, -1}));
  ASSERT_EQ(block.ranges.size(), 1u);
  EXPECT_THAT(block.ranges[0].settings,
              ElementsAre(Of("layer_height", "0.1"), Of("extruder", "0")));
  EXPECT_THAT(project.without_effect, ElementsAre("scripts (post_process), which are never run"));
}

TEST(Read3mf, ReadsAProjectOfBambuStudio) {
  const auto contents = Read(BambuFiles());
  ASSERT_TRUE(contents.ok()) << contents.status();
  const Project& project = contents->project;
  EXPECT_EQ(project.dialect, SettingsDialect::kOrca);
  EXPECT_EQ(contents->meshes.size(), 2u);
  EXPECT_THAT(project.settings, testing::Contains(Of("wall_loops", "3")));
  ASSERT_EQ(project.objects.size(), 1u);
  const SceneObject& cube = project.objects[0];
  EXPECT_EQ(cube.name, "Cube");
  EXPECT_THAT(cube.settings, ElementsAre(Of("extruder", "1")));
  EXPECT_EQ(cube.ranges.size(), 1u);
  ASSERT_EQ(cube.parts.size(), 2u);
  EXPECT_EQ(cube.parts[0].name, "body");
  EXPECT_EQ(cube.parts[0].to_object(2, 3), 5);
  EXPECT_EQ(cube.parts[1].role, PartRole::kNegative);
  EXPECT_EQ(cube.parts[1].mesh.mesh, 1);
  EXPECT_THAT(cube.parts[1].settings, ElementsAre(Of("wall_loops", "5")));
  ASSERT_EQ(project.plates.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(cube.instances[i].to_plate(0, 3), 128, 1e-9) << "each in the middle of its plate";
    EXPECT_NEAR(cube.instances[i].to_plate(1, 3), 128, 1e-9);
    EXPECT_THAT(project.plates[i].members,
                ElementsAre(ProjectPlate::Member{0, static_cast<int32_t>(i)}));
  }
  EXPECT_THAT(project.plates[1].settings, ElementsAre(Of("spiral_mode", "1")));
  EXPECT_THAT(project.without_effect,
              ElementsAre("scripts (post_process), which are never run",
                          "G-code in the project: the parts are sliced again"));
}

/// OrcaSlicer's files differ from Bambu Studio's only in details that do not matter here.
TEST(Read3mf, ReadsAProjectOfOrcaSlicer) {
  Files files = BambuFiles();
  files[1].second = Replaced(files[1].second, "BambuStudio-02.00.01.50", "OrcaSlicer-2.3.1");
  files[1].second = Replaced(files[1].second, " requiredextensions=\"p\"", "");
  const auto contents = Read(files);
  ASSERT_TRUE(contents.ok()) << contents.status();
  EXPECT_EQ(contents->project.application, "OrcaSlicer-2.3.1");
  EXPECT_EQ(contents->project.plates.size(), 2u);
}

TEST(Read3mf, TellsTheStructureWithoutMeshes) {
  for (const Files& files : {CubeFiles(), PrusaFiles(), BambuFiles()}) {
    const std::string bytes = Zipped(files);
    const auto all = Read(bytes), structure = Read(bytes, ReadDepth::kStructure);
    ASSERT_TRUE(structure.ok()) << structure.status();
    EXPECT_TRUE(structure->meshes.empty());
    EXPECT_EQ(structure->project, all->project);
  }
}

TEST(Read3mf, NotesPaint) {
  Files files = CubeFiles();
  files[0].second = Replaced(files[0].second, "v1=\"0\" ", "slic3rpe:fuzzy_skin=\"4\" v1=\"0\" ");
  const auto contents = Read(files);
  ASSERT_TRUE(contents.ok()) << contents.status();
  EXPECT_THAT(contents->project.without_effect, ElementsAre("painted fuzzy skin of `object 1`"));
}

TEST(Read3mf, ReadsPaintedSeamsAsParts) {
  for (const Files& plain : {PrusaFiles(), BambuFiles()}) {
    Files files = plain;
    size_t painted = 0;
    for (auto& [name, text] : files)
      if (const size_t at = text.find("<triangle "); at != std::string::npos) {
        text.insert(at + 9,
                    painted++ == 0 ? " slic3rpe:custom_seam=\"841\"" : " paint_seam=\"841\"");
      }
    ASSERT_EQ(painted, 1u);
    const auto before = Read(plain), contents = Read(files);
    ASSERT_TRUE(contents.ok()) << contents.status();
    const size_t meshes = before->meshes.size();
    ASSERT_EQ(contents->meshes.size(), meshes + 2) << "after those of the objects";
    std::vector<Part> parts = contents->project.objects[0].parts;
    std::vector<MeshRef> seams;
    for (const Part& part : parts)
      if (part.name == "painted seams") seams.push_back(part.mesh);
    const auto number = static_cast<int32_t>(meshes);
    EXPECT_THAT(seams, ElementsAre(MeshRef{0, number, 0, 1}, MeshRef{0, number + 1, 0, 1}));
    std::erase_if(parts, [](const Part& part) { return part.name == "painted seams"; });
    EXPECT_EQ(parts, before->project.objects[0].parts) << "nothing else changes";
    EXPECT_EQ(contents->project.without_effect, before->project.without_effect);
    EXPECT_EQ(Read(Zipped(files), ReadDepth::kStructure)->project, contents->project);
  }
}

double SurfaceOf(const RawMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Vector3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const double ux = b.x() - a.x(), uy = b.y() - a.y(), uz = b.z() - a.z();
    const double vx = c.x() - a.x(), vy = c.y() - a.y(), vz = c.z() - a.z();
    area += std::hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
  }
  return area;
}

/// The stripe is 2.4 mm wide, and the rear corners are blocked over 5 mm to each side. Both areas
/// end in steps, because the pieces are 0.8 mm long.
TEST(Read3mf, ReadsThePaintedBox) {
  const auto contents = Read(CorpusFile("models/painted_box.3mf"));
  ASSERT_TRUE(contents.ok()) << contents.status();
  ASSERT_EQ(contents->meshes.size(), 3u);
  EXPECT_NEAR(SurfaceOf(contents->meshes[1]), 2.4 * 20, 5);
  EXPECT_NEAR(SurfaceOf(contents->meshes[2]), 4 * 5 * 20 + 4 * 25, 25);
  for (const Vector3& p : contents->meshes[1].positions) {
    EXPECT_EQ(p.y(), 0);
    EXPECT_NEAR(p.x(), 6 + 0.4 * p.z(), 1.2 + 0.8);
  }
}

TEST(Read3mf, NamesTheLineOfBadPaint) {
  Files files = CubeFiles();
  files[0].second = Replaced(files[0].second, "v1=\"0\" ", "paint_seam=\"xyz\" v1=\"0\" ");
  for (const ReadDepth depth : {ReadDepth::kStructure, ReadDepth::kMeshes}) {
    const auto contents = Read(Zipped(files), depth);
    EXPECT_EQ(DetailOf(contents.status()).reason, Reason::kMeshMalformed);
    EXPECT_TRUE(DetailOf(contents.status()).metadata.contains("line")) << contents.status();
  }
}

Files Model(const std::string& objects, const std::string& items = Item(1)) {
  return {{kModelName, ModelXml(objects, items)}};
}

/// Hostile files that try to break readers: each must give a typed error.
TEST(Read3mf, RefusesHostileArchives) {
  struct Case {
    std::string name, bytes;
    Reason want;
  };
  const std::string cube = Zipped(CubeFiles());
  const std::string mesh = MeshXml(Cube(0, 0, 0));
  Files bomb = CubeFiles();
  bomb[0].second += std::string(32 << 20, ' ');
  Files entity = CubeFiles();
  entity[0].second.insert(entity[0].second.find("<model"), "<!DOCTYPE m [<!ENTITY a \"aaaa\">]>");
  Files escape = CubeFiles();
  escape.emplace_back("../../etc/cron.d/x", "x");
  Files twice = CubeFiles();
  twice.emplace_back("3D/3dmodel.xxxxx", ModelXml("", ""));
  const std::vector<Case> cases = {
      {"Bomb", Zipped(bomb), Reason::kMeshTooLarge},
      {"Doctype", Zipped(entity), Reason::kMeshMalformed},
      {"Cycle",
       Zipped(Model(ObjectXml(1, ComponentsXml("<component objectid=\"2\"/>")) +
                    ObjectXml(2, ComponentsXml("<component objectid=\"1\"/>")))),
       Reason::kMeshMalformed},
      {"PathEscape", Zipped(escape), Reason::kMeshMalformed},
      {"NanMatrix",
       Zipped(Model(ObjectXml(1, mesh), Item(1, "transform=\"nan 0 0 0 1 0 0 0 1 0 0 0\""))),
       Reason::kMeshNotFinite},
      {"FlatMatrix",
       Zipped(Model(ObjectXml(1, mesh), Item(1, "transform=\"0 0 0 0 1 0 0 0 1 0 0 0\""))),
       Reason::kMeshMalformed},
      {"Truncated", cube.substr(0, cube.size() / 2), Reason::kMeshTruncated},
      {"HugeIds", Zipped(Model(ObjectXml(1, Replaced(mesh, "v1=\"0\"", "v1=\"1000000000\"")))),
       Reason::kMeshMalformed},
      {"HugeObjectIds", Zipped(Model(ObjectXml(1, mesh), Item(2'000'000'000))),
       Reason::kMeshMalformed},
      {"WrongIds", Zipped(Model(ObjectXml(1, mesh), Item(2))), Reason::kMeshMalformed},
      {"MissingId", Zipped(Model("<object>" + mesh + "</object>")), Reason::kMeshMalformed},
      {"Duplicates", Replaced(Zipped(twice), "3dmodel.xxxxx", "3dmodel.model"),
       Reason::kMeshMalformed},
      {"Volumes",
       Zipped(With(PrusaFiles(), "Metadata/Slic3r_PE_model.config",
                   "<config><object id='1'><volume firstid='0' lastid='24'/></object></config>")),
       Reason::kMeshMalformed},
      {"Encrypted", Zipped(CubeFiles(), {.encrypted = true}), Reason::kMeshMalformed},
      {"NothingToBuild", Zipped(Model(ObjectXml(1, mesh), "")), Reason::kMeshEmpty},
      {"NoTriangles", Zipped(Model(ObjectXml(1, "<mesh><vertices/><triangles/></mesh>"))),
       Reason::kMeshEmpty},
      {"NoModel", Zipped({{"word/document.xml", "<a/>"}}), Reason::kMeshFormatUnknown},
      {"FarVertex", Zipped(Model(ObjectXml(1, MeshXml(Cube(1e6, 0, 0))))), Reason::kOutOfRange},
  };
  for (const Case& c : cases) {
    for (const ReadDepth depth : {ReadDepth::kStructure, ReadDepth::kMeshes}) {
      const auto contents = Read(c.bytes, depth);
      ASSERT_FALSE(contents.ok()) << c.name;
      EXPECT_TRUE(absl::IsInvalidArgument(contents.status())) << c.name;
      EXPECT_EQ(DetailOf(contents.status()).reason, c.want) << c.name << contents.status();
    }
  }
}

TEST(Read3mf, HugeIdsAreJustIds) {
  const auto contents =
      Read(Model(ObjectXml(2'000'000'000, MeshXml(Cube(0, 0, 0))), Item(2'000'000'000)));
  EXPECT_TRUE(contents.ok()) << contents.status();
}

TEST(Read3mf, SurvivesEveryCutAndManyWrongBytes) {
  for (const Files& files : {PrusaFiles(), BambuFiles()}) {
    for (const zip_int32_t method : {ZIP_CM_STORE, ZIP_CM_DEFLATE}) {
      const std::string good = Zipped(files, {.method = method});
      for (size_t size = 0; size < good.size(); ++size)
        EXPECT_FALSE(Read(good.substr(0, size)).ok()) << size;
      for (size_t at = 0; at < good.size(); at += 3) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 0x21);
        (void)Read(bad);
      }
    }
  }
}

using Corner = std::array<float, 3>;

/// Returns the triangles of a mesh as floats, independent of the numbering of its vertices.
std::multiset<std::array<Corner, 3>> Triangles(const RawMesh& mesh) {
  std::multiset<std::array<Corner, 3>> all;
  for (const auto& t : mesh.triangles) {
    std::array<Corner, 3> triangle;
    for (size_t i = 0; i < 3; ++i) {
      const Vector3& p = mesh.positions[t[i]];
      triangle[i] = {static_cast<float>(p.x()), static_cast<float>(p.y()),
                     static_cast<float>(p.z())};
    }
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()),
                triangle.end());
    all.insert(triangle);
  }
  return all;
}

/// The file was made by `prusa-slicer --export-3mf` from the STL.
TEST(Read3mf, AgreesWithTheStl) {
  const auto contents = Read(CorpusFile("models/textbox.3mf"));
  ASSERT_TRUE(contents.ok()) << contents.status();
  const auto stl = ReadMesh(CorpusFile("models/textbox.stl"), MeshFormat::kStl, 10'000, {});
  ASSERT_EQ(contents->meshes.size(), 1u);
  EXPECT_EQ(Triangles(contents->meshes[0]), Triangles(*stl));
  EXPECT_EQ(contents->project.objects[0].name, "textbox.stl");
  EXPECT_FALSE(contents->project.objects[0].instances[0].placed);
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::threemf_reader_test
