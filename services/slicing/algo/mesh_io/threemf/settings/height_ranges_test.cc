#include "services/slicing/algo/mesh_io/threemf/settings/height_ranges.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::slicing::threemf::height_ranges_test {
namespace {

TEST(ReadHeightRanges, TellsThemByObject) {
  const auto ranges = ReadHeightRanges(
      "<objects><object id='2'><range min_z='0' max_z='5.5'><option opt_key='layer_height'> 0.1\n"
      "</option><option opt_key='post_process'>evil</option><other>x</other></range>"
      "<range min_z='5.5' max_z='7'/></object><object id='1'/></objects>",
      "ranges");
  ASSERT_TRUE(ranges.ok()) << ranges.status();
  const std::vector<HeightRange> want = {{0, 5.5, {{"layer_height", "0.1", Source::kProfile}}},
                                         {5.5, 7, {}}};
  EXPECT_EQ(ranges->at(2), want);
  EXPECT_TRUE(ranges->at(1).empty());
}

TEST(ReadHeightRanges, SaysWhatIsWrong) {
  const auto in_object = [](const std::string& inside) {
    return "<objects><object id='1'>" + inside + "</object></objects>";
  };
  for (const std::string& text :
       {std::string("<objects><object/></objects>"),
        std::string("<objects><object id='0'/></objects>"),
        in_object("<range min_z='1' max_z='1'/>"), in_object("<range min_z='nan' max_z='1'/>"),
        in_object("<range min_z='0' max_z='1e300'/>"), in_object("<range max_z='1'/>"),
        in_object("<range min_z='0' max_z='1'><option>0.1</option></range>"), in_object("<")}) {
    const auto ranges = ReadHeightRanges(text, "ranges");
    EXPECT_EQ(DetailOf(ranges.status()).reason, Reason::kMeshMalformed) << text;
    EXPECT_EQ(DetailOf(ranges.status()).metadata["part"], "ranges") << text;
  }
  std::string many;
  for (int i = 0; i < 1001; ++i) many += "<range min_z='0' max_z='1'/>";
  EXPECT_EQ(DetailOf(ReadHeightRanges(in_object(many), "ranges").status()).reason,
            Reason::kMeshTooLarge);
}

/// Elements at unexpected positions change nothing.
TEST(ReadHeightRanges, PassesOverTheRest) {
  for (const std::string text :
       {"<objects><x><range min_z='0' max_z='1'><option "
        "opt_key='a'>1</option></range></x></objects>",
        "<range><option opt_key='a'>1</option></range>",
        "<objects><object id='1'><x><option opt_key='a'>1</option></x></object></objects>"}) {
    const auto ranges = ReadHeightRanges(text, "ranges");
    ASSERT_TRUE(ranges.ok()) << ranges.status();
    for (const auto& [object, all] : *ranges) EXPECT_TRUE(all.empty()) << text;
  }
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::height_ranges_test
