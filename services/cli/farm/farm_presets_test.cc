#include "services/cli/farm/farm_presets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::cli::farm_presets_test {
namespace {

using config::presets::PresetFile;

/// Returns the bundles as `NAME: PATH PATH`.
std::vector<std::string> Texts(const std::vector<BundleFiles>& bundles) {
  std::vector<std::string> texts;
  for (const BundleFiles& bundle : bundles) {
    texts.push_back(bundle.name + ":");
    for (const PresetFile& file : bundle.files) texts.back() += " " + file.path;
  }
  return texts;
}

TEST(BundlesOf, AreVendorsAndTheRest) {
  const std::string list = R"({"machine_list": []})";
  EXPECT_THAT(
      Texts(BundlesOf({{"a/system/Co Print.json", list},
                       {"a/system/Co Print/machine/m.json", "{}"},
                       {"a/system/BBL.json", list},
                       {"a/user/1/process/p.json", R"({"name": "p"})"},
                       {"a/vendor/PrusaResearch.ini", "[vendor]"},
                       {"a/filament/My PLA.ini", "temperature = 1"}},
                      "mine")),
      testing::ElementsAre("BBL: BBL.json", "Co_Print: Co Print.json Co Print/machine/m.json",
                           "PrusaResearch: PrusaResearch.ini",
                           "mine: a/filament/My PLA.ini a/user/1/process/p.json"));
}

/// Returns 5 MB of random characters. `kinds`: number of different characters.
std::string Noise(uint32_t kinds) {
  std::string noise(5 << 20, ' ');
  uint32_t state = 1;
  for (char& c : noise)
    c = static_cast<char>('0' + ((state = state * 1664525 + 1013904223) >> 24) % kinds);
  return noise;
}

TEST(ImportRequest, PacksLargeBundles) {
  BundleFiles bundle = {"b", {{"a.json", std::string(1000, ' ')}, {"b.json", "{}"}}};
  const auto small = ImportRequest(bundle);
  ASSERT_TRUE(small.ok()) << small.status();
  ASSERT_EQ(small->files_size(), 2);
  EXPECT_EQ(small->files(1).path(), "b.json");
  bundle.files[0].bytes = Noise(8);
  const auto large = ImportRequest(bundle);
  ASSERT_TRUE(large.ok()) << large.status();
  ASSERT_EQ(large->files_size(), 1);
  const auto unpacked = config::presets::UnpackArchive({"b.zip", large->files(0).content()});
  ASSERT_TRUE(unpacked.ok()) << unpacked.status();
  ASSERT_EQ(unpacked->size(), 2U);
  EXPECT_EQ((*unpacked)[0].path, "b.zip/a.json");
  EXPECT_EQ((*unpacked)[0].bytes, bundle.files[0].bytes);
}

TEST(ImportRequest, RefusesBundlesThatDoNotFit) {
  EXPECT_EQ(DetailOf(ImportRequest({"b", {{"a.json", Noise(200)}}}).status()).reason,
            Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::cli::farm_presets_test
