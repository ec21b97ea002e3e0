#pragma once

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/geometry/vector.h"
#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/tsplib.h"

namespace slicefarm::ordering {

/// Returns the length of the shortest closed tour, by dynamic programming over sets of nodes.
/// `may_use(a, b)` is true if the edge ab exists. REQUIRES: at most 13 nodes.
template <typename MayUse>
int64_t ShortestTour(const Costs& costs, const MayUse& may_use) {
  constexpr int64_t kFar = std::numeric_limits<int64_t>::max() / 4;
  const auto size = static_cast<size_t>(costs.size());
  const auto length = [&](size_t a, size_t b) {
    const auto from = static_cast<int32_t>(a);
    const auto to = static_cast<int32_t>(b);
    return may_use(from, to) ? costs(from, to) : kFar;
  };
  if (size == 1) return 0;
  std::vector<std::vector<int64_t>> least(size_t{1} << size, std::vector<int64_t>(size, kFar));
  least[1][0] = 0;
  for (size_t set = 1; set < least.size(); ++set) {
    for (size_t last = 0; last < size; ++last) {
      if (least[set][last] >= kFar) continue;
      for (size_t next = 0; next < size; ++next) {
        if ((set >> next & 1) != 0) continue;
        int64_t& best = least[set | size_t{1} << next][next];
        best = std::min(best, least[set][last] + length(last, next));
      }
    }
  }
  int64_t best = kFar;
  for (size_t last = 1; last < size; ++last)
    best = std::min(best, least.back()[last] + length(last, 0));
  return best;
}

inline int64_t ShortestTour(const Costs& costs) {
  return ShortestTour(costs, [](int32_t, int32_t) { return true; });
}

inline std::vector<Vector2> RandomPlaces(size_t count, uint32_t seed, int range = 1000) {
  std::mt19937 random(seed);
  std::vector<Vector2> points(count);
  for (Vector2& place : points) {
    place.x() = static_cast<double>(random() % static_cast<uint32_t>(range));
    place.y() = static_cast<double>(random() % static_cast<uint32_t>(range));
  }
  return points;
}

inline Costs RandomCosts(size_t count, uint32_t seed, int range = 1000) {
  return Costs::OfPoints(RandomPlaces(count, seed, range), Metric::kNearest);
}

/// Reads an instance from tests/corpus.
inline TspInstance CorpusInstance(const std::string& name) {
  std::string path = SLICEFARM_CORPUS;
  path.append("/tsplib/").append(name).append(".tsp");
  std::ifstream in(path);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  absl::StatusOr<TspInstance> instance = ReadTsplib(text);
  if (!instance.ok()) throw std::runtime_error(instance.status().ToString());
  return *std::move(instance);
}

}  // namespace slicefarm::ordering
