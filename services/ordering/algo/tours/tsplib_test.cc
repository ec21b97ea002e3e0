#include "services/ordering/algo/tours/tsplib.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <numeric>

#include "common/base/error.h"
#include "services/ordering/algo/tours/exact_tour_test.h"
#include "services/ordering/algo/tours/tour_search.h"

namespace slicefarm::ordering::tsplib_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string Triangle(const std::string& type) {
  return "NAME : three\nTYPE : TSP\nCOMMENT : a : b\nDIMENSION : 3\nEDGE_WEIGHT_TYPE : " + type +
         "\nNODE_COORD_SECTION\n1 0 0\n3 3.0e0 4\n2 3 0\nEOF\n";
}

std::string Table(const std::string& format, const std::string& weights) {
  return "TYPE: TSP\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: " + format +
         "\nEDGE_WEIGHT_SECTION\n" + weights + "\nEOF\n";
}

std::string WithFixed(const std::string& edges) {
  std::string text = Triangle("EUC_2D");
  return text.insert(text.find("NODE_COORD"), "FIXED_EDGES_SECTION\n" + edges + "\n");
}

std::array<int64_t, 3> LengthsOf(const Costs& costs) {
  return {costs(0, 1), costs(0, 2), costs(1, 2)};
}

TEST(Tsplib, ReadsPlaces) {
  const auto instance = ReadTsplib(Triangle("EUC_2D"));
  ASSERT_TRUE(instance.ok()) << instance.status();
  EXPECT_EQ(instance->name, "three");
  EXPECT_THAT(LengthsOf(instance->costs), ElementsAre(3, 5, 4));
  EXPECT_TRUE(instance->fixed.empty());
}

TEST(Tsplib, ReadsEveryMetric) {
  const auto lengths = [](const std::string& type) {
    const auto instance = ReadTsplib(Triangle(type));
    EXPECT_TRUE(instance.ok()) << instance.status();
    return LengthsOf(instance->costs);
  };
  EXPECT_THAT(lengths("CEIL_2D"), ElementsAre(3, 5, 4));
  EXPECT_THAT(lengths("ATT"), ElementsAre(1, 2, 2));
  // A distance of 3 degrees along a meridian of the globe, and of 4 degrees across it.
  EXPECT_THAT(lengths("GEO"), ElementsAre(334, 557, 445));
}

TEST(Tsplib, ReadsEveryTable) {
  for (const auto& [format, weights] :
       {std::pair("FULL_MATRIX", "0 3 5\n3 0 4\n5 4 0"), std::pair("UPPER_ROW", "3 5\n4"),
        std::pair("UPPER_DIAG_ROW", "0 3 5\n0 4\n0"), std::pair("LOWER_ROW", "3\n5 4"),
        std::pair("LOWER_DIAG_ROW", "0 3 0\n5 4\n0")}) {
    const auto instance = ReadTsplib(Table(format, weights));
    ASSERT_TRUE(instance.ok()) << format << instance.status();
    EXPECT_THAT(LengthsOf(instance->costs), ElementsAre(3, 5, 4)) << format;
  }
}

TEST(Tsplib, ReadsFixedEdges) {
  for (const char* edges : {"1 3\n2 3\n-1", "1 3 2 3 -1", "1 3\n2 3 -1\n"}) {
    const auto instance = ReadTsplib(WithFixed(edges));
    ASSERT_TRUE(instance.ok()) << instance.status();
    EXPECT_THAT(instance->fixed, ElementsAre(NodePair{0, 2}, NodePair{1, 2}));
  }
  EXPECT_TRUE(ReadTsplib(WithFixed("1 3\n2 3\n1 2\n-1")).ok()) << "a ring of all";
}

// TSPLIB checks its distance functions by the lengths of best tours.
TEST(Tsplib, UlyssesOnTheGlobe) {
  const auto instance = ReadTsplib(
      "NAME: ulysses16.tsp\nTYPE: TSP\nCOMMENT: Odyssey of Ulysses\nDIMENSION: 16\n"
      "EDGE_WEIGHT_TYPE: GEO\nDISPLAY_DATA_TYPE: COORD_DISPLAY\nNODE_COORD_SECTION\n"
      " 1 38.24 20.42\n 2 39.57 26.15\n 3 40.56 25.32\n 4 36.26 23.12\n 5 33.48 10.54\n"
      " 6 37.56 12.19\n 7 38.42 13.11\n 8 37.52 20.44\n 9 41.23 9.10\n 10 41.17 13.05\n"
      " 11 36.08 -5.21\n 12 38.47 15.13\n 13 38.15 15.35\n 14 37.51 15.17\n 15 35.49 14.32\n"
      " 16 39.36 19.56\nEOF\n");
  ASSERT_TRUE(instance.ok()) << instance.status();
  const Neighbours neighbours(instance->costs, 8, 0);
  const TourRules rules;
  Tour tour(16);
  std::iota(tour.begin(), tour.end(), 0);
  TourSearch search(instance->costs, neighbours, rules, tour, SearchDepth::kChains, 1);
  WorkBudget budget{1'000'000};
  search.Improve(budget);
  search.Iterate(1000, budget);
  EXPECT_EQ(TourLength(instance->costs, search.tour()), 6859);
}

TEST(Tsplib, LinesMayEndAsOnWindows) {
  std::string text;
  for (const char c : Triangle("EUC_2D")) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_TRUE(ReadTsplib(text).ok());
}

TEST(Tsplib, ReadsTheCorpus) {
  EXPECT_EQ(CorpusInstance("att48").costs.size(), 48);
  EXPECT_EQ(CorpusInstance("d1291").costs.size(), 1291);
  EXPECT_THAT(CorpusInstance("linhp318").fixed, ElementsAre(NodePair{0, 213}));
}

struct BadCase {
  const char* name;
  std::string text;
  const char* message;
};

class BadTsplibTest : public testing::TestWithParam<BadCase> {};

TEST_P(BadTsplibTest, IsRefused) {
  const auto instance = ReadTsplib(GetParam().text);
  ASSERT_FALSE(instance.ok());
  EXPECT_EQ(DetailOf(instance.status()).reason, Reason::kRequestMalformed);
  EXPECT_THAT(std::string(instance.status().message()), HasSubstr(GetParam().message));
}

std::string Replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

INSTANTIATE_TEST_SUITE_P(
    Tsplib, BadTsplibTest,
    testing::Values(
        BadCase{"Empty", "", "TYPE '' must be TSP"},
        BadCase{"NoText", std::string("\0\1\2", 3), "line 1: "},
        BadCase{"OtherType", Replaced(Triangle("EUC_2D"), "TYPE : TSP", "TYPE : ATSP"),
                "line 2: TYPE 'ATSP' must be TSP"},
        BadCase{"OtherMetric", Triangle("MAX_2D"), "line 5: EDGE_WEIGHT_TYPE 'MAX_2D' must be"},
        BadCase{"UnknownKey", Replaced(Triangle("EUC_2D"), "COMMENT", "CAPACITY"),
                "line 3: 'CAPACITY' is not a known key"},
        BadCase{"KeyTwice", "TYPE: TSP\nTYPE: TSP\n", "line 2: TYPE comes twice"},
        BadCase{"SectionTwice",
                Replaced(Triangle("EUC_2D"), "EOF", "NODE_COORD_SECTION\n1 0 0\nEOF"),
                "NODE_COORD_SECTION comes twice"},
        BadCase{"NoDimension", Replaced(Triangle("EUC_2D"), "DIMENSION : 3\n", ""),
                "DIMENSION must be"},
        BadCase{"NoNodes", Replaced(Triangle("EUC_2D"), ": 3\n", ": 0\n"), "DIMENSION must be"},
        BadCase{"HalfANode", Replaced(Triangle("EUC_2D"), ": 3\n", ": 2.5\n"), "DIMENSION must be"},
        BadCase{"TooFewNodes", Replaced(Triangle("EUC_2D"), ": 3\n", ": 4\n"),
                "has 9 numbers, for 4 nodes it needs 12"},
        BadCase{"NodeTwice", Replaced(Triangle("EUC_2D"), "2 3 0", "3 3 0"),
                "line 9: node 3 comes twice"},
        BadCase{"NodeZero", Replaced(Triangle("EUC_2D"), "1 0 0", "0 0 0"),
                "line 7: '0' is not a node of 1 .. 3"},
        BadCase{"NoNumber", Replaced(Triangle("EUC_2D"), "2 3 0", "2 3 0x1"),
                "line 9: '0x1' is not a number"},
        BadCase{"NotFinite", Replaced(Triangle("EUC_2D"), "2 3 0", "2 3 1e999"), "line 9: "},
        BadCase{"FarAway", Replaced(Triangle("EUC_2D"), "2 3 0", "2 3 1e10"),
                "line 9: a coordinate beyond 1e9"},
        BadCase{"BeyondTheGlobe", Replaced(Triangle("GEO"), "2 3 0", "2 3 1e8"),
                "beyond 360 degrees"},
        BadCase{"NoCoordinates", "TYPE: TSP\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EUC_2D\nEOF\n",
                "there is no NODE_COORD_SECTION"},
        BadCase{"ThreeDimensions",
                Replaced(Triangle("EUC_2D"), "COMMENT : a",
                         "NODE_COORD_TYPE : THREED_COORDS\nCOMMENT : a"),
                "only TWOD_COORDS"},
        BadCase{"NoTable",
                "TYPE: TSP\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EXPLICIT\n"
                "EDGE_WEIGHT_FORMAT: UPPER_ROW\n",
                "there is no EDGE_WEIGHT_SECTION"},
        BadCase{"OtherTable", Table("FUNCTION", "1"), "EDGE_WEIGHT_FORMAT 'FUNCTION' must be"},
        BadCase{"ShortTable", Table("UPPER_ROW", "3 5"), "has 2 numbers, UPPER_ROW of 3"},
        BadCase{"NegativeWeight", Table("UPPER_ROW", "3 -5 4"), "a weight must be"},
        BadCase{"BrokenWeight", Table("UPPER_ROW", "3 5.5 4"), "a weight must be"},
        BadCase{"GreatWeight", Table("UPPER_ROW", "3 5e12 4"), "a weight must be"},
        BadCase{"NotSymmetric", Table("FULL_MATRIX", "0 3 5\n3 0 4\n5 7 0"),
                "line 8: the weights between 3 and 2 differ"},
        BadCase{"FixedWithoutEnd", WithFixed("1 3"), "must end with -1"},
        BadCase{"HalfAnEdge", WithFixed("1 3\n2\n-1"), "half a fixed edge"},
        BadCase{"FixedToItself", WithFixed("2 2\n-1"), "from a node to itself"},
        BadCase{"FixedUnknown", WithFixed("2 7\n-1"), "'7' is not a node of 1 .. 3"},
        BadCase{"FixedTwice", WithFixed("2 1\n1 2\n-1"), "a ring of fewer than all nodes"},
        BadCase{"ThirdFixed", WithFixed("1 2\n3 1\n1 2\n-1"), "a third fixed edge"}),
    [](const auto& info) { return info.param.name; });

TEST(Tsplib, TooLargeIsRefusedBeforeItIsRead) {
  for (const auto& [type, size] :
       {std::pair("EUC_2D", "20001"), std::pair("GEO", "5001"), std::pair("EXPLICIT", "1e300")}) {
    const auto instance =
        ReadTsplib(Replaced(Triangle(type), ": 3\n", ": " + std::string(size) + "\n"));
    ASSERT_FALSE(instance.ok());
    EXPECT_EQ(DetailOf(instance.status()).reason, Reason::kRequestTooLarge) << type;
  }
}

// A truncated or damaged file gives an error or an instance, but no crash.
TEST(Tsplib, SurvivesSpoiltFiles) {
  std::mt19937 random(1);
  const std::vector<std::string> sources = {WithFixed("1 3\n-1"), Triangle("GEO"),
                                            Table("LOWER_DIAG_ROW", "0 3 0\n5 4\n0")};
  int refused = 0;
  for (const std::string& source : sources) {
    for (size_t length = 0; length < source.size(); ++length)
      refused += !ReadTsplib(source.substr(0, length)).ok();
    for (int i = 0; i < 2000; ++i) {
      std::string spoilt = source;
      for (int k = 0; k < 3; ++k) spoilt[random() % spoilt.size()] = " \n-:.19E\xff"[random() % 9];
      const auto instance = ReadTsplib(spoilt);
      refused += !instance.ok();
      ASSERT_TRUE(!instance.ok() || instance->costs.size() >= 1);
    }
  }
  EXPECT_GT(refused, 3000);
}

TEST(Tsplib, PrintsTours) {
  EXPECT_EQ(PrintTour("x", {2, 0, 1}),
            "NAME : x\nTYPE : TOUR\nDIMENSION : 3\nTOUR_SECTION\n3\n1\n2\n-1\nEOF\n");
}

}  // namespace
}  // namespace slicefarm::ordering::tsplib_test
