#include "services/cli/job/field_files.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <vector>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"
#include "common/model/fields/field_text.h"

namespace slicefarm::cli::field_files_test {
namespace {

class FieldFiles : public testing::Test {
 protected:
  std::string Write(const std::string& name, const std::string& bytes) {
    const std::string path = folder_.path() + "/" + name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }

  DensityField Density(const std::string& json) {
    const auto setting = ReadFieldFile(Write("field.json", json), FieldKind::kDensity);
    EXPECT_TRUE(setting.ok()) << setting.status();
    if (!setting.ok()) return {};
    EXPECT_EQ(setting->key, "density_field");
    return ParseDensityField(setting->value).value();
  }

  Reason ReasonOf(const std::string& json, FieldKind kind = FieldKind::kDensity) {
    const auto setting = ReadFieldFile(Write("field.json", json), kind);
    EXPECT_FALSE(setting.ok());
    return setting.ok() ? Reason::kInternal : DetailOf(setting.status()).reason;
  }

  TempDirectory folder_;
};

template <class T>
std::string Raw(const std::vector<T>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
}

TEST_F(FieldFiles, RawFilesOfAllTypesGiveTheSameGrid) {
  Write("a.raw", Raw<uint8_t>({0, 51, 255}));
  Write("b.raw", Raw<uint16_t>({0, 13107, 65535}));
  Write("c.raw", Raw<float>({0, 0.2F, 1}));
  for (const auto& [file, type] :
       {std::pair("a.raw", "uint8"), std::pair("b.raw", "uint16"), std::pair("c.raw", "float32")}) {
    const DensityField field = Density(std::string(R"({"kind":"voxels","count":[3,1,1],)") +
                                       R"("origin":[0,0,0],"spacing":[1,1,1],"file":")" + file +
                                       R"(","type":")" + type + "\"}");
    EXPECT_EQ(field.grid.values, (std::vector<double>{0, 0.2, 1})) << file;
  }
}

TEST_F(FieldFiles, ThePicturesTopIsTheGreatestY) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = 2, image.height = 2, image.format = PNG_FORMAT_GRAY;
  const std::vector<uint8_t> grey = {255, 0, 0, 0};  // white pixel at the top left
  ASSERT_NE(png_image_write_to_file(&image, (folder_.path() + "/p.png").c_str(), 0, grey.data(), 0,
                                    nullptr),
            0);
  const DensityField field = Density(
      R"({"kind":"image","file":"p.png","origin":[10,20],"size":[4,8],"min":0.1,"max":0.6})");
  EXPECT_DOUBLE_EQ(field.At({11, 26, 0}, 0), 0.6);
  EXPECT_DOUBLE_EQ(field.At({11, 22, 0}, 0), 0.1);
  EXPECT_DOUBLE_EQ(field.At({13, 26, 50}, 0), 0.1);
  EXPECT_NEAR(field.At({12, 26, 0}, 0), 0.35, 1e-12);
}

TEST_F(FieldFiles, StressesComeFromRawFloats) {
  Write("s.raw", Raw<float>({1, -2, 0.5F}));
  const auto setting = ReadFieldFile(
      Write("s.json", R"({"kind":"voxels","count":[1,1,1],"origin":[0,0,0],"spacing":[1,1,1],)"
                      R"("file":"s.raw","type":"float32"})"),
      FieldKind::kStress);
  ASSERT_TRUE(setting.ok()) << setting.status();
  EXPECT_EQ(ParseStressField(setting->value)->yy.values, std::vector<double>{-2});
}

TEST_F(FieldFiles, RefusesWhatIsNoFieldWithAReason) {
  Write("nan.raw", Raw<float>({0, NAN, 1}));
  Write("short.raw", Raw<float>({0, 1}));
  Write("odd.raw", "abc");
  Write("text.png", "no picture");
  const auto raw = [](const std::string& rest) {
    return R"({"kind":"voxels","count":[3,1,1],"origin":[0,0,0],"spacing":[1,1,1],)" + rest + "}";
  };
  EXPECT_EQ(ReasonOf("{"), Reason::kSettingMalformed);
  EXPECT_EQ(ReasonOf("[]"), Reason::kSettingMalformed);
  EXPECT_EQ(ReasonOf(raw(R"("file":"nan.raw","type":"float32")")), Reason::kSettingMalformed);
  EXPECT_EQ(ReasonOf(raw(R"("file":"short.raw","type":"float32")")), Reason::kSettingMalformed);
  EXPECT_EQ(ReasonOf(raw(R"("file":"odd.raw","type":"uint16")")), Reason::kSettingMalformed);
  EXPECT_EQ(ReasonOf(raw(R"("file":"odd.raw","type":"int3")")), Reason::kSettingMalformed);
  EXPECT_EQ(ReasonOf(raw(R"("file":"none.raw","type":"uint8")")), Reason::kRequestMalformed);
  EXPECT_EQ(ReasonOf(R"({"kind":"image","file":"text.png","origin":[0,0],"size":[1,1]})"),
            Reason::kSettingMalformed);
  EXPECT_EQ(ReasonOf(R"({"kind":"constant","density":0.5})", FieldKind::kMaterials),
            Reason::kSettingMalformed);
  const auto missing = ReadFieldFile("/nowhere/field.json", FieldKind::kStress);
  EXPECT_EQ(DetailOf(missing.status()).reason, Reason::kRequestMalformed);
}

}  // namespace
}  // namespace slicefarm::cli::field_files_test
