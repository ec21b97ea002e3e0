#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "services/beading/algo/arachne/constant_width_walls.h"
#include "services/beading/algo/arachne/variable_walls.h"
#include "services/beading/algo/sample_outlines_test.h"
#include "services/beading/algo/strategy/strategy_factory.h"

// Tests of outlines made from seeds. A failure or a crash reports the seed. Environment variables:
//   SLICEFARM_HOSTILE_OUTLINES   number of outlines (300)
//   SLICEFARM_HOSTILE_SEED       first seed (1); to repeat a failure: its seed, and 1 outline

namespace slicefarm::beading::hostile_outlines_test {
namespace {

constexpr Coord kWidthNm = 500'000;
constexpr Coord kMaxWidthNm = 2 * kWidthNm;
/// Largest ratio of covered area to island area. Beads overlap where their number changes and at
/// the tips of acute corners. Of 380,000 islands, all except 4 with saw teeth are below this value.
/// Islands of other kinds with at least 1 mm2 reach 1.23.
constexpr double kMaxCover = 1.25;
constexpr double kSlackNm2 = 0.3e12;
/// Radius of a disc. An area that can contain such a disc is thick enough for two beads, and no
/// filter applies to it. In 80,000 islands, at least 0.985 of this area is covered, and no disc's
/// centre is farther from a bead than 354,000 nm. (For discs of 250,000, pieces shorter than a
/// bead's width stay free.)
constexpr Coord kDiscNm = 400'000;
constexpr double kMinCover = 0.97;
constexpr double kMaxGapNm = kDiscNm;

uint64_t FromEnvironment(const char* name, uint64_t otherwise) {
  const char* const value = std::getenv(name);
  return value == nullptr ? otherwise : std::strtoull(value, nullptr, 10);
}

/// Returns the strategy that `slicefarm-lab beads` uses.
std::unique_ptr<const BeadingStrategy> Strategy(int max_walls) {
  StrategyOptions options;
  options.outer_width_nm = options.inner_width_nm = kWidthNm;
  options.min_width_nm = options.min_split_width_nm = options.min_feature_nm = 300'000;
  options.max_width_nm = kMaxWidthNm;
  options.distribution_count = 3;
  options.transition_length_nm = 650'000;
  options.max_walls = max_walls;
  return MakeStrategy(options);
}

VariableWallOptions WallOptions() {
  VariableWallOptions options;
  options.transition_angle = std::numbers::pi / 4;
  options.transition_length_nm = 650'000;
  options.tolerance_nm = 500;
  return options;
}

bool IsWithin(const Box& box, const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(), [&box](Point p) {
    return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y;
  });
}

std::string WrongWithLine(const ThickLine& line, const Box& box) {
  const size_t least = line.closed ? 3 : 2;
  if (line.points.size() < least) return fmt::format("a line of {} points", line.points.size());
  if (line.thickness_nm.size() != line.points.size()) return "not a width for each point";
  for (const Coord width : line.thickness_nm)
    if (width <= 0 || width > kMaxWidthNm) return fmt::format("a width of {} nm", width);
  return IsWithin(box, line.points) ? "" : "a bead outside";
}

double Covered(const VariableWalls& walls) {
  double covered = Area(walls.fill_area);
  for (const WallLine& wall : walls.lines) covered += Area(wall.line);
  return covered;
}

/// Returns the covered area with the half discs at the ends of lines; a dot consists only of them.
double CoveredWithEnds(const VariableWalls& walls) {
  double covered = Covered(walls);
  for (const WallLine& wall : walls.lines) {
    if (wall.line.closed) continue;
    for (const Coord width : {wall.line.thickness_nm.front(), wall.line.thickness_nm.back()})
      covered += std::numbers::pi / 8 * static_cast<double>(width) * static_cast<double>(width);
  }
  return covered;
}

double DistanceTo(Point p, const ThickLine& line) {
  double nearest = Distance(p, line.points.front());
  for (size_t i = line.closed ? 0 : 1; i < line.points.size(); ++i)
    nearest = std::min(
        nearest,
        DistanceToSegment(p, line.points[i == 0 ? line.points.size() - 1 : i - 1], line.points[i]));
  return nearest;
}

/// Coverage of the area that has space for a disc of kDiscNm.
struct RoomCover {
  double room_nm2 = 0;
  double share = 1;   ///< share of this area
  double gap_nm = 0;  ///< largest distance of a disc's centre from a bead or the fill area
};

RoomCover CoverOfRoom(const VariableWalls& walls, const PolygonWithHoles& island) {
  // Clipper's Offset is used, because the walls themselves are made by FastOffset.
  const MultiPolygon middles = Offset({island}, -kDiscNm);
  RoomCover cover;
  cover.room_nm2 = Area(Offset(middles, kDiscNm, {.join = Join::kRound}));
  if (middles.empty()) return cover;
  cover.share = CoveredWithEnds(walls) / cover.room_nm2;
  ForEachRing(middles, [&](const Polygon& ring) {
    for (const Point p : ring) {
      double gap = std::numeric_limits<double>::infinity();
      for (const PolygonWithHoles& fill : walls.fill_area)
        if (Locate(p, fill) != Side::kOutside) gap = 0;
      for (const WallLine& wall : walls.lines)
        if (gap > 0) gap = std::min(gap, DistanceTo(p, wall.line));
      cover.gap_nm = std::max(cover.gap_nm, gap);
    }
  });
  return cover;
}

std::string WrongWithRoom(const RoomCover& room) {
  if (room.share < kMinCover)
    return fmt::format("covers {:.3f} of the {:.6f} mm2 that it must", room.share,
                       room.room_nm2 * 1e-12);
  return room.gap_nm > kMaxGapNm ? fmt::format("no bead within {:.0f} nm", room.gap_nm) : "";
}

/// Returns the violated condition for the walls of an island; empty if there is none.
std::string WrongWith(const VariableWalls& walls, const PolygonWithHoles& island) {
  const Box box = Bounds(island.outer).Grown(kMaxWidthNm / 2);
  for (const WallLine& wall : walls.lines) {
    const std::string wrong = WrongWithLine(wall.line, box);
    if (!wrong.empty()) return wrong;
  }
  bool inside = true;
  ForEachRing(walls.fill_area, [&](const Polygon& ring) { inside &= IsWithin(box, ring); });
  if (!inside) return "fill outside";
  const double area = Area(island), covered = Covered(walls);
  if (covered < 0 || covered > kMaxCover * area + kSlackNm2)
    return fmt::format("covers {:.6f} of {:.6f} mm2", covered * 1e-12, area * 1e-12);
  return "";
}

bool AreSame(const std::optional<VariableWalls>& a, const std::optional<VariableWalls>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->fill_area == b->fill_area &&
         std::equal(a->lines.begin(), a->lines.end(), b->lines.begin(), b->lines.end(),
                    [](const WallLine& x, const WallLine& y) {
                      return x.inset == y.inset && x.is_middle == y.is_middle && x.line == y.line;
                    });
}

/// Prints the seed on a crash.
class SeedWatch {
 public:
  SeedWatch() {
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS}) std::signal(signal, Tell);
  }
  ~SeedWatch() {
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS}) std::signal(signal, SIG_DFL);
  }
  void Begin(uint64_t seed) {
    std::snprintf(text_, sizeof text_, "crashed: seed %llu\n",
                  static_cast<unsigned long long>(seed));
  }

 private:
  static void Tell(int signal) {
    const auto length = static_cast<size_t>(std::find(text_, text_ + sizeof text_, '\0') - text_);
    if (write(STDERR_FILENO, text_, length) < 0) _exit(1);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  static inline char text_[64] = {};
};

struct KindTotals {
  int outlines = 0;
  int islands = 0;
  int fallbacks = 0;
  int failures = 0;
  double worst_cover = 0;  ///< for islands of 1 mm2 and more
  double worst_excess_mm2 = 0;
  int with_room = 0;
  double least_room_share = 1;
  double worst_gap_nm = 0;
};

void CheckIsland(const PolygonWithHoles& island, const BeadingStrategy& strategy,
                 const std::string& name, KindTotals& totals) {
  const auto walls = MakeVariableWalls(island, strategy, WallOptions());
  std::string wrong = walls ? WrongWith(*walls, island) : "";
  if (wrong.empty() && !AreSame(walls, MakeVariableWalls(island, strategy, WallOptions())))
    wrong = "not the same on another call";
  ++totals.islands;
  if (!walls) {
    ++totals.fallbacks;
    fmt::print("fallback: {}\n", name);
  }
  if (walls) {
    const double area = Area(island), covered = Covered(*walls);
    if (area >= 1e12) totals.worst_cover = std::max(totals.worst_cover, covered / area);
    totals.worst_excess_mm2 = std::max(totals.worst_excess_mm2, (covered - area) * 1e-12);
    const RoomCover room = CoverOfRoom(*walls, island);
    if (wrong.empty()) wrong = WrongWithRoom(room);
    totals.with_room += room.room_nm2 > 0;
    totals.least_room_share = std::min(totals.least_room_share, room.share);
    totals.worst_gap_nm = std::max(totals.worst_gap_nm, room.gap_nm);
  }
  totals.failures += !wrong.empty();
  EXPECT_EQ(wrong, "") << name;
}

TEST(HostileOutlines, KeepTheInvariants) {
  const uint64_t count = FromEnvironment("SLICEFARM_HOSTILE_OUTLINES", 300);
  const uint64_t first = FromEnvironment("SLICEFARM_HOSTILE_SEED", 1);
  const auto filled = Strategy(0), three_walls = Strategy(3);
  SeedWatch watch;
  std::map<std::string_view, KindTotals> all;
  for (uint64_t seed = first; seed < first + count; ++seed) {
    watch.Begin(seed);
    const HostileOutline outline = MakeHostileOutline(seed);
    KindTotals& totals = all[outline.kind];
    ++totals.outlines;
    for (size_t i = 0; i < outline.islands.size(); ++i)
      CheckIsland(outline.islands[i], seed % 2 == 0 ? *filled : *three_walls,
                  fmt::format("seed {}, island {}", seed, i), totals);
  }
  int islands = 0, fallbacks = 0, with_room = 0;
  for (const auto& [kind, totals] : all) {
    islands += totals.islands, fallbacks += totals.fallbacks, with_room += totals.with_room;
    fmt::print(
        "{}: outlines {} islands {} fallbacks {} failures {} cover {:.3f} excess {:.3f} "
        "with room {} least cover {:.3f} gap {:.3f} mm\n",
        kind, totals.outlines, totals.islands, totals.fallbacks, totals.failures,
        totals.worst_cover, totals.worst_excess_mm2, totals.with_room, totals.least_room_share,
        totals.worst_gap_nm * 1e-6);
  }
  EXPECT_LE(fallbacks, islands / 1000);
  EXPECT_GT(with_room, count < 100 ? -1 : islands / 20);
}

// The skeleton agrees with walls of constant width: the beads and the infill have the same areas.
TEST(HostileOutlines, ConstantWallsAreThoseOfTheSkeleton) {
  const uint64_t count = FromEnvironment("SLICEFARM_HOSTILE_OUTLINES", 300);
  const uint64_t first = FromEnvironment("SLICEFARM_HOSTILE_SEED", 1);
  const auto strategy = Strategy(2);
  int constant = 0;
  const auto beads = [](const VariableWalls& walls) {
    return Covered(walls) - Area(walls.fill_area);
  };
  for (uint64_t seed = first; seed < first + count; ++seed) {
    for (const PolygonWithHoles& island : MakeHostileOutline(seed).islands) {
      const auto walls = TryWideWalls(island, *strategy, 2, WallOptions());
      const auto skeletal = MakeVariableWalls(island, *strategy, WallOptions());
      if (!walls || !skeletal) continue;
      ++constant;
      EXPECT_EQ(WrongWith(*walls, island), "") << seed;
      EXPECT_NEAR(beads(*walls), beads(*skeletal), 0.005 * beads(*skeletal) + 0.02e12) << seed;
      EXPECT_NEAR(Area(walls->fill_area), Area(skeletal->fill_area),
                  0.002 * beads(*skeletal) + 0.02e12)
          << seed;
    }
  }
  EXPECT_GT(constant, count < 100 ? -1 : static_cast<int>(count / 30));
}

// These seeds failed once: teeth with coinciding nodes, and a blend that continued past a branch,
// gave beads on top of each other. A level edge (31837) was split from both ends.
TEST(HostileOutlines, ThoseThatFailedOnce) {
  const auto filled = Strategy(0), three_walls = Strategy(3);
  KindTotals totals;
  for (const uint64_t seed : {3121, 20095, 31837, 71467, 74338}) {
    const HostileOutline outline = MakeHostileOutline(seed);
    for (const PolygonWithHoles& island : outline.islands)
      CheckIsland(island, seed % 2 == 0 ? *filled : *three_walls, fmt::format("seed {}", seed),
                  totals);
  }
  EXPECT_EQ(totals.fallbacks, 0);
  EXPECT_GE(totals.with_room, 1);
}

TEST(HostileOutlines, AHundredThousandPoints) {
  const PolygonWithHoles island = WavyRing(100'000);
  const auto walls = MakeVariableWalls(island, *Strategy(0), WallOptions());
  ASSERT_TRUE(walls.has_value());
  EXPECT_EQ(WrongWith(*walls, island), "");
  EXPECT_GT(Covered(*walls), 0.98 * Area(island));
}

}  // namespace
}  // namespace slicefarm::beading::hostile_outlines_test
