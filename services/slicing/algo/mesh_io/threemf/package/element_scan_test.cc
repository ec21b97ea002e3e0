#include "services/slicing/algo/mesh_io/threemf/package/element_scan.h"

#include <gtest/gtest.h>

namespace slicefarm::slicing::threemf::element_scan_test {
namespace {

TEST(ElementScan, TakesRunsOfElements) {
  ElementScan scan("\n <vertex x=\"1\" y='-2.5e3'/>\n<vertex/>\t</vertices>", "vertex");
  ASSERT_EQ(scan.Next(), ScanEnd::kElement);
  ASSERT_EQ(scan.attributes().size(), 2u);
  EXPECT_EQ(scan.attributes()[0].name, "x");
  EXPECT_EQ(scan.attributes()[1].value, "-2.5e3");
  ASSERT_EQ(scan.Next(), ScanEnd::kElement);
  EXPECT_TRUE(scan.attributes().empty());
  EXPECT_EQ(scan.Next(), ScanEnd::kOther);
  EXPECT_EQ(scan.rest(), "</vertices>");
  EXPECT_EQ(scan.lines(), 2);
}

TEST(ElementScan, LeavesWhatItDoesNotKnow) {
  for (const std::string text :
       {"<!-- comment --> and more", "<vertexes x=\"1\"/>", "<vertex x=\"&#49;\"/>",
        "<vertex x=\"1\"></vertex>", "<vertex x=\"1\"y=\"2\"/>", "<vertex x = \"1\"/>",
        "<vertex x=\"1\" x=\"1\"/>", "<vertex x=\"\xc3\xa4\"/>", "<vertex x=\"<\"/>",
        "<vertex x=\"1\t\"/>", "<vertex\nx=\"1\"/>", "text and more text", "<vertex x=1/>"}) {
    ElementScan scan(text, "vertex");
    EXPECT_EQ(scan.Next(), ScanEnd::kOther) << text;
    EXPECT_EQ(scan.rest(), text);
  }
}

TEST(ElementScan, AsksForMoreAtEveryCut) {
  const std::string whole = "<vertex x=\"1\" y=\"2\"/>";
  for (size_t size = 0; size < whole.size(); ++size) {
    ElementScan scan(std::string_view(whole).substr(0, size), "vertex");
    EXPECT_EQ(scan.Next(), ScanEnd::kMore) << size;
    EXPECT_EQ(scan.rest().size(), size);
  }
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::element_scan_test
