#include "services/beading/algo/skeleton/centrality.h"

#include <algorithm>
#include <cmath>

#include "common/base/portable_math.h"

namespace slicefarm::beading {
namespace {

class EndTrimmer {
 public:
  EndTrimmer(const SkeletalGraph& graph, double min_length, std::vector<char>& central)
      : graph_(graph), min_length_(min_length), central_(central), leaving_(graph.Leaving()) {}

  void Trim() {
    for (int node = 0; node < static_cast<int>(graph_.nodes.size()); ++node)
      if (OnlyCentral(node, -1) >= 0) TrimFrom(node);
  }

 private:
  /// Returns the only central half-edge that leaves the node, not counting edge `but`; -1 if there
  /// is none or more than one.
  int OnlyCentral(int node, int but) const {
    int only = -1, count = 0;
    graph_.ForEachLeaving(leaving_[node], [&](int half) {
      if (!central_[half / 2] || half / 2 == but) return;
      only = half;
      ++count;
    });
    return count == 1 ? only : -1;
  }

  void TrimFrom(int node) {
    std::vector<int> chain;
    double length = 0;
    for (int half = OnlyCentral(node, -1); half >= 0 && length < min_length_;
         half = OnlyCentral(graph_.To(half), half / 2)) {
      chain.push_back(half / 2);
      length += graph_.Length(half);
      if (graph_.To(half) == node) return;
    }
    if (length >= min_length_ || EndsAlone(chain, node)) return;
    for (const int edge : chain) central_[edge] = false;
  }

  /// Returns true if the short line `chain` is not connected to another central line. Then it is
  /// the only line of its part of the island, and is kept.
  bool EndsAlone(const std::vector<int>& chain, int start) const {
    int at = start;
    for (const int edge : chain) {
      const int half = graph_.half_edges[2 * edge].from == at ? 2 * edge : 2 * edge + 1;
      at = graph_.To(half);
    }
    int others = 0;
    graph_.ForEachLeaving(
        leaving_[at], [&](int half) { others += central_[half / 2] && half / 2 != chain.back(); });
    return others == 0;
  }

  const SkeletalGraph& graph_;
  const double min_length_;
  std::vector<char>& central_;
  const std::vector<int> leaving_;
};

}  // namespace

std::vector<char> CentralEdges(const SkeletalGraph& graph, const CentralityOptions& options) {
  const double steepest = Sin(options.transition_angle / 2);
  std::vector<char> central(graph.half_edges.size() / 2);
  for (size_t edge = 0; edge < central.size(); ++edge) {
    const int half = static_cast<int>(2 * edge);
    const double a = graph.FromNode(half).radius, b = graph.ToNode(half).radius;
    central[edge] =
        std::max(a, b) >= options.min_radius_nm && std::abs(a - b) < graph.Length(half) * steepest;
  }
  EndTrimmer(graph, options.min_length_nm, central).Trim();
  return central;
}

}  // namespace slicefarm::beading
