#include "services/infill/algo/linking/all_links.h"

#include <utility>
#include <vector>

namespace slicefarm::infill {
namespace {

/// Returns the edge parts of one ring, beginning with a given end.
std::vector<int32_t> SpansFrom(const EdgeEnds& ends, int32_t first) {
  std::vector<int32_t> spans;
  int32_t at = first;
  do {
    spans.push_back(at);
    at = ends.Next(at);
  } while (at != first);
  return spans;
}

/// Every second edge part.
struct Choice {
  std::vector<int32_t> spans;
  int too_long = 0;  ///< number of edge parts omitted because of their length
  double length_nm = 0;
};

Choice EverySecond(const EdgeEnds& ends, const std::vector<int32_t>& ring, size_t first,
                   double max_link_nm) {
  Choice choice;
  for (size_t i = 0; i + 1 < ring.size(); i += 2) {
    const int32_t span = ring[(first + i) % ring.size()];
    const double length = ends.LinkLength(span);
    if (length > max_link_nm) {
      ++choice.too_long;
      continue;
    }
    choice.spans.push_back(span);
    choice.length_nm += length;
  }
  return choice;
}

}  // namespace

Links LinkAllEnds(const EdgeEnds& ends, double max_link_nm) {
  Links links(static_cast<size_t>(ends.size()), false);
  std::vector<bool> seen(static_cast<size_t>(ends.size()), false);
  for (const int32_t end : ends.OnEdge()) {
    if (seen[static_cast<size_t>(end)]) continue;
    const std::vector<int32_t> ring = SpansFrom(ends, end);
    for (const int32_t span : ring) seen[static_cast<size_t>(span)] = true;
    const Choice one = EverySecond(ends, ring, 0, max_link_nm);
    const Choice other = EverySecond(ends, ring, 1, max_link_nm);
    const auto badness = [](const Choice& c) { return std::pair(c.too_long, c.length_nm); };
    for (const int32_t span : (badness(other) < badness(one) ? other : one).spans)
      links[static_cast<size_t>(span)] = true;
  }
  return links;
}

}  // namespace slicefarm::infill
