#include "services/slicing/algo/mesh_io/threemf/model_stream.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive_files_test.h"

namespace slicefarm::slicing::threemf::model_stream_test {
namespace {

struct Model {
  ModelFile file;
  std::vector<RawMesh> meshes;
};

absl::StatusOr<Model> Read(const std::string& text, const CancelToken& cancel = {}) {
  const std::string bytes = Zipped({{kModelName, text}}, {.method = ZIP_CM_STORE});
  const auto archive = Archive::Open(bytes);
  if (!archive.ok()) return archive.status();
  MeshReading reading = {.coordinate_limit_mm = 10'000};
  Model model;
  auto file = ReadModelFile(*archive, archive->entries()[0], reading, model.meshes, cancel);
  if (!file.ok()) return file.status();
  model.file = *std::move(file);
  return model;
}

std::string ModelOf(const std::string& mesh) { return ModelXml(ObjectXml(1, mesh), Item(1)); }

/// Returns a mesh of much more text than one piece.
RawMesh Large() { return TorusMesh({.around = 200, .sides = 150}); }

TEST(ReadModelFile, ReadsLargeMeshes) {
  const auto model = Read(ModelOf(MeshXml(Large())));
  ASSERT_TRUE(model.ok()) << model.status();
  EXPECT_EQ(model->meshes[0].triangles.size(), Large().triangles.size());
}

/// The scanner and the parser must give equal results for every position of the piece ends and
/// every form of the elements.
TEST(ReadModelFile, GivesTheSameForEveryForm) {
  const std::string usual = MeshXml(Large());
  const auto want = Read(ModelOf(usual));
  ASSERT_TRUE(want.ok()) << want.status();
  std::vector<std::string> forms = {
      Replaced(usual, "<vertices>", "<vertices >"),
      Replaced(usual, "<vertices>", "<vertices><!-- a <vertices> -->"),
      Replaced(usual, "<triangles>", "<triangles><![CDATA[<triangles>]]>"),
      Replaced(usual, "</vertices>", "<!-- vertices> <vertex x='1' y='1' z='1'/> --></vertices>"),
      Replaced(usual, "/>\n", " />"),
      Replaced(usual, "/>\n", "></triangle>"),
      Replaced(usual, "y=\"", "\ny='"),
      Replaced(usual, "v2=\"", "other=\"&lt;\" v2=\""),
  };
  forms[5] = Replaced(usual, "<vertex ", "<vertex\t");
  for (std::string& form : forms) {
    form = Replaced(form, "\ny='", "\ny=\"");
    for (const size_t blanks : {0, 1, 7, 100}) {
      const auto model = Read(ModelOf(std::string(blanks, ' ') + form));
      ASSERT_TRUE(model.ok()) << form.substr(0, 60) << model.status();
      EXPECT_EQ(model->meshes[0].positions, want->meshes[0].positions) << form.substr(0, 60);
      EXPECT_EQ(model->meshes[0].triangles, want->meshes[0].triangles) << form.substr(0, 60);
    }
  }
}

/// Elements in a comment or in CDATA do not count.
TEST(ReadModelFile, TakesNoElementOutOfAComment) {
  const std::string box = MeshXml(Cube(0, 0, 0));
  const std::string more = "<vertex x=\"9\" y=\"9\" z=\"9\"/>";
  for (const std::string& hidden :
       {"<vertices><!-- vertices>" + more + " -->", "<vertices><![CDATA[vertices>" + more + "]]>",
        "<vertices><?x vertices>" + more + "?>"}) {
    const auto model = Read(ModelOf(
        Replaced(Replaced(box, "<vertices>", hidden), "v1=\"0\" v2=\"2\"", "v1=\"8\" v2=\"2\"")));
    EXPECT_EQ(DetailOf(model.status()).reason, Reason::kMeshMalformed) << hidden;
  }
}

TEST(ReadModelFile, NamesTheLine) {
  std::string mesh = MeshXml(Large());
  const size_t at = mesh.find("<vertex", mesh.size() / 4);
  mesh.replace(at, 11, "<vertex x=\"nan\" w=\"");
  const std::string text = ModelOf(mesh);
  const auto lines = std::count(text.begin(), text.begin() + text.find("nan"), '\n') + 1;
  const auto model = Read(text);
  EXPECT_EQ(DetailOf(model.status()).reason, Reason::kMeshNotFinite) << model.status();
  EXPECT_EQ(DetailOf(model.status()).metadata["line"], std::to_string(lines)) << model.status();
  // The error is behind a run, where the parser reads again.
  const auto late = Read(Replaced(text, "nan", "123") + "<");
  EXPECT_EQ(DetailOf(late.status()).metadata["line"],
            std::to_string(std::count(text.begin(), text.end(), '\n') + 1))
      << late.status();
}

TEST(ReadModelFile, EveryCutIsAnError) {
  const std::string text = ModelOf(MeshXml(Cube(0, 0, 0)));
  for (size_t size = 0; size < text.size(); ++size)
    EXPECT_FALSE(Read(text.substr(0, size)).ok()) << size;
}

TEST(ReadModelFile, CanBeCancelled) {
  const CancelToken cancelled([] { return true; });
  EXPECT_TRUE(absl::IsCancelled(Read(ModelOf(""), cancelled).status()));
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::model_stream_test
