#include "services/slicing/algo/mesh_io/threemf/package/xml.h"

#include <gtest/gtest.h>

namespace slicefarm::slicing::threemf::xml_test {
namespace {

/// Handler that records its calls.
class Listener : public XmlHandler {
 public:
  absl::Status Start(std::string_view name, XmlAttributes attributes, int64_t line) override {
    reported += "<" + std::string(name) + "@" + std::to_string(line);
    for (const XmlAttribute& each : attributes)
      reported += " " + std::string(each.name) + "=" + std::string(each.value);
    return name == "bad" ? Malformed("bad") : absl::OkStatus();
  }
  absl::Status End(std::string_view name) override {
    reported += ">" + std::string(name);
    return absl::OkStatus();
  }
  absl::Status Text(std::string_view text) override {
    reported += text;
    return absl::OkStatus();
  }

  std::string reported;
};

TEST(ParseXml, TellsElementsAttributesAndText) {
  Listener listener;
  ASSERT_TRUE(ParseXml("<a x='1' p:y=\"&lt;2\">\n<b/>t</a>", "part", listener).ok());
  EXPECT_EQ(listener.reported, "<a@1 x=1 p:y=<2\n<b@2>bt>a");
}

absl::Status Parse(const std::string& text) {
  Listener listener;
  return ParseXml(text, "x.model", listener);
}

std::string Nested(int depth) {
  std::string text;
  for (int i = 0; i < depth; ++i) text += "<a>";
  for (int i = 0; i < depth; ++i) text += "</a>";
  return text;
}

TEST(ParseXml, RefusesWithAPlace) {
  struct Case {
    std::string name, text, line;
  };
  const std::vector<Case> cases = {
      {"Nothing", "", "1"},
      {"NotWellFormed", "<a>\n<b></a>", "2"},
      {"Cut", "<a>\n\n<b", "3"},
      {"OfTheHandler", "<a>\n<bad/></a>", "2"},
      {"Doctype", "\n<!DOCTYPE a><a/>", "2"},
      {"Entity", "<!DOCTYPE a [<!ENTITY e \"x\">]>\n<a>&e;</a>", "1"},
      {"External", "<!DOCTYPE a SYSTEM \"file:///etc/passwd\"><a/>", "1"},
      {"UndefinedEntity", "<a>&e;</a>", "1"},
      {"Depth", Nested(65), "1"},
      {"TwoRoots", "<a/><b/>", "1"},
      {"Nul", std::string("<a>\0</a>", 8), "1"},
      {"TwoOfOneAttribute", "<a x='1' x='2'/>", "1"},
  };
  for (const Case& c : cases) {
    const absl::Status status = Parse(c.text);
    EXPECT_EQ(DetailOf(status).reason, Reason::kMeshMalformed) << c.name << status;
    EXPECT_EQ(DetailOf(status).metadata["part"], "x.model") << c.name;
    EXPECT_EQ(DetailOf(status).metadata["line"], c.line) << c.name << status;
  }
  EXPECT_TRUE(Parse(Nested(64)).ok());
}

TEST(XmlParser, LimitsTheLengthOfATag) {
  Listener listener;
  XmlParser parser("x", listener);
  absl::Status status = parser.Feed("<a x='", false);
  const std::string piece(64 << 10, 'y');
  int64_t fed = 0;
  for (; status.ok() && fed < (8 << 20); fed += static_cast<int64_t>(piece.size()))
    status = parser.Feed(piece, false);
  EXPECT_FALSE(status.ok());
  EXPECT_LE(fed, 3 << 20);
}

TEST(XmlParser, KnowsWhetherAllIsUnderstood) {
  Listener listener;
  XmlParser parser("x", listener);
  ASSERT_TRUE(parser.Feed("<a><b>", false).ok());
  EXPECT_TRUE(parser.AtBoundary());
  ASSERT_TRUE(parser.Feed("<!-- <c>", false).ok());
  EXPECT_FALSE(parser.AtBoundary());
  ASSERT_TRUE(parser.Feed(" -->", false).ok());
  EXPECT_TRUE(parser.AtBoundary());
  ASSERT_TRUE(parser.Feed("<![CDATA[ <c>", false).ok());
  ASSERT_TRUE(parser.Feed("]]><d", false).ok());
  EXPECT_FALSE(parser.AtBoundary());
}

TEST(XmlParser, CountsSkippedLines) {
  Listener listener;
  XmlParser parser("x", listener);
  ASSERT_TRUE(parser.Feed("<a>\n", false).ok());
  parser.SkipLines(10);
  ASSERT_TRUE(parser.Feed("<b/>", false).ok());
  EXPECT_EQ(listener.reported, "<a@1\n<b@12>b");
}

TEST(XmlAttributes, AreFoundByName) {
  const std::vector<XmlAttribute> attributes = {{"x", "1"}, {"p:path", "2"}};
  EXPECT_EQ(Find(attributes, "x"), "1");
  EXPECT_EQ(Find(attributes, "path"), std::nullopt);
  EXPECT_EQ(FindPrefixed(attributes, "path"), "2");
  EXPECT_EQ(FindPrefixed(attributes, "x"), std::nullopt);
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::xml_test
