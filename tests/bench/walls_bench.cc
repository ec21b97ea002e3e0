#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/geometry/offset/offset.h"
#include "common/geometry/skeleton/boundary.h"
#include "services/beading/algo/sample_outlines_test.h"
#include "services/lab/bead_files.h"
#include "services/lab/bead_maker.h"
#include "tests/bench/benchmarks.h"

namespace slicefarm::bench {
namespace {

using lab::BeadMaker;
using lab::BeadTotals;

constexpr int kRounds = 3;
constexpr int kPoints = 10'000;
constexpr Coord kOpenNm = 1'500;  ///< opening of self-touching outlines, as in MakeVariableWalls

/// Segment in the form that voronoi_builder accepts.
struct Segment {
  int32_t x0, y0, x1, y1;
};

struct Outline {
  MultiPolygon islands;
  std::vector<std::vector<Segment>> segments;  ///< segments by island
};

/// Returns the CPU time of the thread, which depends less on other load of the machine.
double Now() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <typename Work>
double Seconds(const Work& work) {
  const double start = Now();
  work();
  return Now() - start;
}

std::vector<Segment> Segments(const Boundary& boundary) {
  std::vector<Segment> segments;
  for (const BoundaryEdge& edge : boundary.edges) {
    segments.push_back({static_cast<int32_t>(edge.from.x), static_cast<int32_t>(edge.from.y),
                        static_cast<int32_t>(edge.to.x), static_cast<int32_t>(edge.to.y)});
  }
  return segments;
}

/// Returns the outline as MakeVariableWalls prepares it for diagrams: rounded to um, or to nm if
/// sides would cross after rounding to um.
Outline Prepare(MultiPolygon islands) {
  Outline outline;
  for (const PolygonWithHoles& island : islands) {
    if (const std::optional<Boundary> boundary = MakeBoundary(island)) {
      outline.segments.push_back(Segments(*boundary));
      continue;
    }
    for (const PolygonWithHoles& part : Offset({island}, -kOpenNm))
      if (const auto boundary = MakeBoundary(part)) outline.segments.push_back(Segments(*boundary));
  }
  outline.islands = std::move(islands);
  return outline;
}

std::optional<std::vector<Outline>> Read(const std::string& directory) {
  const auto files = lab::OutlineFiles(directory);
  if (!files.ok()) {
    std::fprintf(stderr, "%s\n", std::string(files.status().message()).c_str());
    return std::nullopt;
  }
  std::vector<Outline> outlines;
  for (const auto& file : *files) {
    auto islands = lab::ReadOutlines(file);
    if (!islands.ok()) {
      std::fprintf(stderr, "%s\n", std::string(islands.status().message()).c_str());
      return std::nullopt;
    }
    outlines.push_back(Prepare(*std::move(islands)));
  }
  return outlines;
}

void BuildDiagrams(const Outline& outline) {
  for (const std::vector<Segment>& segments : outline.segments) {
    boost::polygon::voronoi_builder<int32_t> builder;
    for (const Segment& s : segments) builder.insert_segment(s.x0, s.y0, s.x1, s.y1);
    boost::polygon::voronoi_diagram<double> diagram;
    builder.construct(&diagram);
  }
}

void MakeInsets(const Outline& outline) {
  for (const Coord distance : {250'000, 750'000, 1'250'000})
    (void)Offset(outline.islands, -distance);
}

struct Times {
  double voronoi_s = 0;
  double insets_s = 0;
  double filled_s = 0;
  double walls3_s = 0;
  double vertices10k_s = 0;
  int fallbacks = 0;
};

Times RunRound(const std::vector<Outline>& outlines, const MultiPolygon& ring) {
  const BeadMaker fills({}), makes_three({.walls = 3});
  Times times;
  BeadTotals totals;
  // Measures all methods outline by outline, so that a slow period of the machine affects all of
  // them alike.
  for (const Outline& outline : outlines) {
    times.voronoi_s += Seconds([&] { BuildDiagrams(outline); });
    times.insets_s += Seconds([&] { MakeInsets(outline); });
    times.filled_s += Seconds([&] { (void)fills.Make(outline.islands, totals); });
    times.walls3_s += Seconds([&] { (void)makes_three.Make(outline.islands, totals); });
  }
  times.vertices10k_s = Seconds([&] { (void)fills.Make(ring, totals); });
  times.fallbacks = totals.fallbacks;
  return times;
}

/// Returns the shortest time of each method over all rounds.
Times Best(const std::vector<Outline>& outlines) {
  const MultiPolygon ring = {beading::WavyRing(kPoints)};
  Times best = RunRound(outlines, ring);
  for (int round = 1; round < kRounds; ++round) {
    const Times times = RunRound(outlines, ring);
    for (double Times::*part : {&Times::voronoi_s, &Times::insets_s, &Times::filled_s,
                                &Times::walls3_s, &Times::vertices10k_s})
      best.*part = std::min(best.*part, times.*part);
  }
  return best;
}

}  // namespace

/// Measures walls for the outlines of a directory, beside the times of a Voronoi diagram alone and
/// of constant insets alone.
int BenchWalls(const std::string& outlines) {
  const auto read = Read(outlines);
  if (!read) return 1;
  size_t segments = 0;
  for (const Outline& outline : *read)
    for (const std::vector<Segment>& island : outline.segments) segments += island.size();
  const Times best = Best(*read);
  std::printf("outlines %zu\nsegments %zu\n", read->size(), segments);
  std::printf("voronoi_s %.4f\ninsets_s %.4f\n", best.voronoi_s, best.insets_s);
  std::printf("filled_s %.4f\nfilled_per_voronoi %.3f\n", best.filled_s,
              best.filled_s / best.voronoi_s);
  std::printf("walls3_s %.4f\nwalls3_per_voronoi %.3f\n", best.walls3_s,
              best.walls3_s / best.voronoi_s);
  std::printf("vertices10k_s %.4f\nfallbacks %d\n", best.vertices10k_s, best.fallbacks);
  return 0;
}

}  // namespace slicefarm::bench
