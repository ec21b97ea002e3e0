#include "services/slicing/algo/mesh_io/threemf/package.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/slicing/algo/mesh_io/threemf/package/archive_files_test.h"

namespace slicefarm::slicing::threemf::package_test {
namespace {

absl::StatusOr<Package> Read(const Files& files) {
  const std::string bytes = Zipped(files);
  const auto archive = Archive::Open(bytes);
  if (!archive.ok()) return archive.status();
  return ReadPackage(*archive, {.coordinate_limit_mm = 10'000}, {});
}

TEST(ReadPackage, FollowsPathsInTheirOrder) {
  const auto package = Read(BambuFiles());
  ASSERT_TRUE(package.ok()) << package.status();
  ASSERT_EQ(package->files.size(), 2u);
  EXPECT_EQ(package->files[1].part, "3D/Objects/object_1.model");
  EXPECT_EQ(package->meshes.size(), 2u);
  const auto key = package->Resolve(package->files[0].objects[0].components[1], 0);
  ASSERT_TRUE(key.ok()) << key.status();
  EXPECT_EQ(package->At(*key).id, 3u);
}

TEST(ReadPackage, TakesTheModelThatTheRelationshipsName) {
  Files files = BambuFiles();
  files[0].second = Replaced(files[0].second, "/3D/3dmodel.model", "/else/m.model");
  files[1].first = "Else/M.model";
  const auto package = Read(files);
  ASSERT_TRUE(package.ok()) << package.status();
  EXPECT_EQ(package->files[0].part, "Else/M.model");
}

TEST(ReadPackage, SaysWhatIsWrong) {
  const std::string lost = ModelXml(
      ObjectXml(1, ComponentsXml("<component objectid=\"1\" p:path=\"/../x.model\"/>")), Item(1));
  struct Case {
    std::string name;
    Files files;
    Reason want;
  };
  const std::vector<Case> cases = {
      {"NoModel", {{"a.txt", "text"}}, Reason::kMeshFormatUnknown},
      {"LostPath", {{kModelName, lost}}, Reason::kMeshMalformed},
      {"BadRelationships", With(BambuFiles(), "_rels/.rels", "<a"), Reason::kMeshMalformed},
      {"BadPart", With(BambuFiles(), "3D/Objects/object_1.model", "<a"), Reason::kMeshMalformed},
  };
  for (const Case& c : cases) {
    const auto package = Read(c.files);
    EXPECT_EQ(DetailOf(package.status()).reason, c.want) << c.name << package.status();
  }
}

TEST(Package, ResolvesOnlyWhatIsThere) {
  const auto package = Read(CubeFiles());
  ASSERT_TRUE(package.ok()) << package.status();
  ObjectUse use;
  use.path = kModelName;
  use.object = 1;
  EXPECT_TRUE(package->Resolve(use, 0).ok());
  use.object = 1'000'000'000;
  EXPECT_EQ(DetailOf(package->Resolve(use, 0).status()).reason, Reason::kMeshMalformed);
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::package_test
