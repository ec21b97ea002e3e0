#include "services/slicing/algo/mesh_io/threemf/model_handler.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive_files_test.h"

namespace slicefarm::slicing::threemf::model_handler_test {
namespace {

struct Model {
  ModelFile file;
  std::vector<RawMesh> meshes;
};

absl::StatusOr<Model> Read(const std::string& text) {
  MeshReading reading = {.coordinate_limit_mm = 10'000};
  Model model;
  ModelHandler handler(reading, model.meshes);
  absl::Status status = ParseXml(text, "m.model", handler);
  if (!status.ok()) return status;
  absl::StatusOr<ModelFile> file = std::move(handler).Take();
  if (!file.ok()) return file.status();
  model.file = *std::move(file);
  return model;
}

TEST(ModelHandler, ReadsObjectsAndItems) {
  const auto model = Read(ModelXml(
      ObjectXml(7, MeshXml(Cube(0, 0, 0)), "name=\"Gear\"") +
          ObjectXml(2147483647, ComponentsXml("<component objectid=\"7\" p:path=\"/a.model\" "
                                              "transform=\"1 0 0 0 1 0 0 0 1 1 2 3\"/>")),
      Item(7, "printable=\"0\"") + Item(2147483647), "unit=\"inch\"", "Some CAD 1.0"));
  ASSERT_TRUE(model.ok()) << model.status();
  EXPECT_EQ(model->file.application, "Some CAD 1.0");
  EXPECT_EQ(model->file.unit_mm, 25.4);
  ASSERT_EQ(model->file.objects.size(), 2u);
  EXPECT_EQ(model->file.objects[0].name, "Gear");
  EXPECT_EQ(model->file.objects[0].mesh, 0);
  EXPECT_EQ(model->file.objects[0].triangles, 12);
  EXPECT_EQ(model->meshes[0].positions[1], (Vector3{0, 254, 0}));
  ASSERT_EQ(model->file.objects[1].components.size(), 1u);
  EXPECT_EQ(model->file.objects[1].components[0].path, "/a.model");
  EXPECT_EQ(model->file.objects[1].components[0].transform(2, 3), 3 * 25.4);
  ASSERT_EQ(model->file.items.size(), 2u);
  EXPECT_FALSE(model->file.items[0].printable);
  EXPECT_TRUE(model->file.items[1].printable);
}

TEST(ModelHandler, TakesThePrefixOfTheRoot) {
  const auto model = Read(
      "<c:model xmlns:c='core' xmlns='other'><c:resources><object id='9'/><c:object id='1'>"
      "<c:mesh><c:vertices><c:vertex x='0' y='0' z='0'/><vertex/></c:vertices><c:triangles>"
      "<c:triangle v1='0' v2='0' v3='0'/></c:triangles></c:mesh></c:object></c:resources>"
      "<c:build><c:item objectid='1'/><item objectid='2'/></c:build></c:model>");
  ASSERT_TRUE(model.ok()) << model.status();
  EXPECT_EQ(model->file.objects.size(), 1u);
  EXPECT_EQ(model->file.items.size(), 1u);
  EXPECT_EQ(model->meshes[0].triangles.size(), 1u);
}

struct Case {
  std::string name, text;
  Reason want = Reason::kMeshMalformed;
};

TEST(ModelHandler, SaysWhatIsWrong) {
  const std::string mesh = MeshXml(Cube(0, 0, 0));
  const auto component = [](std::string_view attributes) {
    return ModelXml(ObjectXml(1, ComponentsXml("<component " + std::string(attributes) + "/>")),
                    "");
  };
  const std::vector<Case> cases = {
      {"NoModel", "<html/>"},
      {"Unit", ModelXml("", "", "unit=\"furlong\"")},
      {"NoId", ModelXml("<object/>", "")},
      {"ZeroId", ModelXml(ObjectXml(0, mesh), "")},
      {"NegativeId", ModelXml(ObjectXml(-1, mesh), "")},
      {"HugeId", ModelXml("<object id=\"2147483648\"/>", "")},
      {"TwoOfOneId", ModelXml(ObjectXml(1, mesh) + ObjectXml(1, mesh), "")},
      {"TwoMeshes", ModelXml(ObjectXml(1, mesh + mesh), "")},
      {"MeshAndComponents", ModelXml(ObjectXml(1, mesh + ComponentsXml("")), "")},
      {"NoObjectId", component("")},
      {"WordAsId", component("objectid=\"one\"")},
      {"ShortTransform", component("objectid=\"1\" transform=\"1 0 0\"")},
      {"NanTransform", component("objectid=\"1\" transform=\"nan 0 0 0 1 0 0 0 1 0 0 0\""),
       Reason::kMeshNotFinite},
      {"FlatTransform", component("objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 0 0 0 0\"")},
      {"ItemOfNothing", ModelXml("", "<item/>")},
      {"Needed", ModelXml("", "", "requiredextensions=\"b\" xmlns:b=\"http://beams\"")},
      {"NeededAndNotNamed", ModelXml("", "", "requiredextensions=\"zz\"")},
  };
  for (const Case& c : cases) {
    const auto model = Read(c.text);
    ASSERT_FALSE(model.ok()) << c.name;
    EXPECT_EQ(DetailOf(model.status()).reason, c.want) << c.name << model.status();
  }
}

TEST(ModelHandler, BoundsCopies) {
  std::string items;
  for (int i = 0; i < 1001; ++i) items += Item(1);
  const auto model = Read(ModelXml("", items));
  EXPECT_EQ(DetailOf(model.status()).reason, Reason::kMeshTooLarge);
  EXPECT_EQ(DetailOf(model.status()).metadata["limit"], "1000");
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::model_handler_test
