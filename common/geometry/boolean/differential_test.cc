#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/cgal_judge_test.h"
#include "common/geometry/boolean/clipper_oracle_test.h"
#include "common/geometry/boolean/region_pairs_test.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/text_format_test.h"

// Compares slicefarm's results with Clipper's, and where the two differ, with CGAL's exact
// arithmetic. Environment variables:
//   SLICEFARM_REGION_PAIRS       number of pairs (1500)
//   SLICEFARM_REGION_PAIRS_SEED  seed of the first pair (1); to repeat a failure: its seed, and 1
//   pair

namespace slicefarm::differential_test {
namespace {

uint32_t FromEnvironment(const char* name, uint32_t otherwise) {
  const char* const value = std::getenv(name);
  return value == nullptr ? otherwise : static_cast<uint32_t>(std::atoi(value));
}

RegionPair PairOf(uint32_t seed) {
  std::mt19937 random(seed);
  return MakeRegionPair([&](uint32_t below) { return random() % below; });
}

template <typename Check>
void ForEachPair(const Check& check) {
  const uint32_t first = FromEnvironment("SLICEFARM_REGION_PAIRS_SEED", 1);
  const uint32_t count = FromEnvironment("SLICEFARM_REGION_PAIRS", 1500);
  for (uint32_t seed = first; seed < first + count; ++seed) {
    const RegionPair pair = PairOf(seed);
    SCOPED_TRACE(fmt::format("seed {}: {}", seed, pair.kind));
    check(pair);
  }
}

struct Totals {
  int tried = 0, made = 0, judged = 0;
  Differences worst;
  void Add(const Differences& d) {
    ++judged;
    worst.thickness_nm = std::max(worst.thickness_nm, d.thickness_nm);
    worst.distance_nm = std::max(worst.distance_nm, d.distance_nm);
    worst.overlap_nm2 = std::max(worst.overlap_nm2, std::abs(d.overlap_nm2));
  }
};

void Print(const std::map<std::string, Totals>& all) {
  for (const auto& [name, t] : all)
    fmt::print("{:22} tried {:5} made {:5} judged {:5} thick {:.2f} away {:.2f} overlap {:.1f}\n",
               name, t.tried, t.made, t.judged, t.worst.thickness_nm, t.worst.distance_nm,
               t.worst.overlap_nm2);
}

constexpr std::pair<Operation, const char*> kOperations[] = {
    {Operation::kUnion, "union"},
    {Operation::kIntersection, "intersection"},
    {Operation::kDifference, "difference"}};

// Corners are the exact corners, rounded: at most sqrt(1/2) nm away.
TEST(Differential, FastBooleans) {
  std::map<std::string, Totals> all;
  ForEachPair([&](const RegionPair& pair) {
    for (const auto& [op, name] : kOperations) {
      Totals& totals = all[fmt::format("{} {}", pair.kind, name)];
      ++totals.tried;
      const auto got = TryBoolean(pair.a, pair.b, op);
      totals.made += got.has_value();
      if (!got || *got == ClipperBoolean(pair.a, pair.b, op)) continue;
      const Differences d = JudgeBoolean(*got, pair.a, pair.b, op);
      totals.Add(d);
      EXPECT_LT(d.thickness_nm, 1) << name << ": " << ToText(d);
      EXPECT_LT(d.distance_nm, 0.71) << name << ": " << ToText(d);
    }
  });
  Print(all);
}

// Includes the functions that use Clipper. Where edges are less than a nanometre apart, Clipper
// omits or adds spurs of any length and no thickness. Therefore the test does not check the
// distance.
TEST(Differential, AllBooleans) {
  std::map<std::string, Totals> all;
  ForEachPair([&](const RegionPair& pair) {
    for (const auto& [op, name] : kOperations) {
      Totals& totals = all[fmt::format("{} {}", pair.kind, name)];
      ++totals.tried;
      const MultiPolygon got = op == Operation::kUnion          ? Union(pair.a, pair.b)
                               : op == Operation::kIntersection ? Intersection(pair.a, pair.b)
                                                                : Difference(pair.a, pair.b);
      const Differences d = JudgeBoolean(got, pair.a, pair.b, op);
      totals.Add(d);
      EXPECT_LT(d.thickness_nm, 1.5) << name << ": " << ToText(d);
    }
  });
  Print(all);
}

// The test does not check the distance along tips. Where edges meet at a small angle, a nanometre
// across them is micrometres along them.
TEST(Differential, Offsets) {
  std::map<std::string, Totals> all;
  ForEachPair([&](const RegionPair& pair) {
    for (const Coord distance :
         {-2'300'000, -500'001, -225'000, -1'000, 1'000, 333'333, 1'500'000}) {
      const MultiPolygon want = ClipperOffset(pair.a, distance);
      const auto check = [&](const char* name, const MultiPolygon& got) {
        Totals& totals = all[fmt::format("{} {}", pair.kind, name)];
        ++totals.made;
        if (got == want) return;
        const Differences d = JudgeEqual(got, want);
        totals.Add(d);
        EXPECT_LT(d.thickness_nm, 2) << name << " " << distance << ": " << ToText(d);
      };
      if (const auto got = TryOffset(pair.a, distance)) check("TryOffset", got->polygons);
      if (distance < 0 && pair.a.size() == 1)
        if (const auto got = TryErode(pair.a[0], -distance)) check("TryErode", *got);
    }
  });
  Print(all);
}

}  // namespace
}  // namespace slicefarm::differential_test
