#include "tests/load/generator/algo/latency_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <vector>

namespace slicefarm::load::latency_plot_test {
namespace {

using testing::HasSubstr;
using testing::Not;

RunReport RunAt(double rate_rps, int64_t latency_ns, int ended, int skipped = 0) {
  RunLog log;
  for (int i = 0; i < ended + skipped; ++i) log.Arrived();
  for (int i = 0; i < skipped; ++i) log.Skipped();
  for (int i = 0; i < ended; ++i) log.Ended(0, latency_ns, {});
  RunReport report;
  report.scenario = "print";
  report.mix = "tiny";
  report.intended_rps = rate_rps;
  report.seconds = 1;
  report.record = log.Take();
  return report;
}

/// Returns true if all elements are closed in the right order, and no text contains an unescaped
/// `<` or `&`.
bool IsWellFormed(const std::string& xml) {
  static const std::regex kToken(
      R"re(<(/?)([a-z]+)((?:\s+[A-Za-z0-9-]+="[^"<&]*")*)\s*(/?)>|(&(?:amp|lt|gt);)|([^<&]+))re");
  std::vector<std::string> open;
  auto at = xml.cbegin();
  bool rooted = false;
  for (std::smatch token; at != xml.cend(); at = token.suffix().first) {
    if (!std::regex_search(at, xml.cend(), token, kToken, std::regex_constants::match_continuous)) {
      return false;
    }
    if (!token[2].matched) continue;
    if (token[1].length() > 0) {
      if (open.empty() || open.back() != token[2]) return false;
      open.pop_back();
    } else if (token[4].length() == 0) {
      if (open.empty() && rooted) return false;
      rooted = true;
      open.push_back(token[2]);
    }
  }
  return rooted && open.empty();
}

int Count(const std::string& text, const std::string& part) {
  int count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(LatencyPlot, TheCheckFindsFaults) {
  EXPECT_TRUE(IsWellFormed("<a x=\"1\"><b/>t &amp; t</a>\n"));
  EXPECT_FALSE(IsWellFormed("<a><b></a></b>"));
  EXPECT_FALSE(IsWellFormed("<a>"));
  EXPECT_FALSE(IsWellFormed("<a>x & y</a>"));
  EXPECT_FALSE(IsWellFormed("<a x=1></a>"));
}

TEST(LatencyPlot, IsWellFormed) {
  RunReport odd = RunAt(7, 3, 2);
  odd.scenario = "a<b&c>d";
  const std::vector<std::vector<RunReport>> cases = {
      {}, {RunAt(5, 0, 0)}, {odd}, {RunAt(5, 1'000'000, 10), RunAt(10, 90'000'000'000, 3, 4)}};
  for (const auto& runs : cases) {
    const std::string svg = LatencyPlot(runs);
    EXPECT_TRUE(IsWellFormed(svg)) << svg;
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
  }
}

TEST(LatencyPlot, ALineForEachPercentileThroughAllRuns) {
  const std::string svg =
      LatencyPlot({RunAt(5, 1'000'000, 10), RunAt(10, 5'000'000, 10), RunAt(20, 900'000'000, 10)});
  EXPECT_EQ(Count(svg, "<polyline"), 5);
  EXPECT_EQ(Count(svg, "<circle"), 5 * 3 + 5);  // points, legend
}

TEST(LatencyPlot, WhatWasLostIsTold) {
  EXPECT_THAT(LatencyPlot({RunAt(5, 1000, 10)}), Not(HasSubstr("lost")));
  EXPECT_THAT(LatencyPlot({RunAt(5, 1000, 30, 10)}), HasSubstr("25 % lost"));
  EXPECT_THAT(LatencyPlot({RunAt(5, 1000, 0, 10)}), HasSubstr("100 % lost"));
}

TEST(LatencyPlot, MoreLatencyIsHigherUp) {
  const std::string svg = LatencyPlot({RunAt(5, 1'000'000, 10), RunAt(10, 50'000'000, 10)});
  std::smatch points;
  ASSERT_TRUE(
      std::regex_search(svg, points, std::regex(R"(points="([\d.]+),([\d.]+) ([\d.]+),([\d.]+))")));
  EXPECT_LT(std::stod(points[1]), std::stod(points[3]));
  EXPECT_GT(std::stod(points[2]), std::stod(points[4]));
}

}  // namespace
}  // namespace slicefarm::load::latency_plot_test
