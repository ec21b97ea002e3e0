#include "services/infill/algo/edge_links.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "common/geometry/measure.h"
#include "services/infill/algo/ring_way.h"

namespace slicefarm::infill {
namespace {

constexpr int32_t kNone = -1;

/// An end of a piece: number 2 i and 2 i + 1 are those of piece i.
struct End {
  Point place;
  int32_t ring = 0;
  int32_t edge = 0;
  double along_nm = 0;  ///< the ring, from its first point
};

/// A stretch of the edge between two ends that are neighbours on it, from `from` forwards.
struct Stretch {
  double length_nm = 0;
  int32_t from = 0;
  int32_t to = 0;
};

class Linker {
 public:
  Linker(std::span<const ScanLines> families, const EdgeLinkOptions& options)
      : options_(options), rings_(families[0].rings) {
    MeasureRings();
    for (const ScanLines& lines : families) {
      for (const int32_t crossing : lines.order) {
        const Crossing& at = lines.crossings[crossing];
        const Point place = lines.PlaceOf(at);
        const double along =
            corner_at_[at.ring][at.edge] + Distance((*rings_[at.ring])[at.edge], place);
        ends_.push_back({place, at.ring, at.edge, along});
      }
    }
    link_.assign(ends_.size(), kNone);
    forward_.assign(ends_.size(), false);
  }

  std::vector<Polyline> Run() {
    ChooseLinks(Stretches());
    std::vector<bool> done(ends_.size() / 2, false);
    std::vector<Polyline> paths;
    for (size_t end = 0; end < ends_.size(); ++end) {
      if (link_[end] != kNone || done[end / 2]) continue;
      Polyline path = Follow(static_cast<int32_t>(end), done);
      if (Length(path) >= options_.min_length_nm) paths.push_back(std::move(path));
    }
    return paths;
  }

 private:
  /// Where each ring's corners lie along it, and its length at last.
  void MeasureRings() {
    for (const Polygon* ring : rings_) {
      std::vector<double>& at = corner_at_.emplace_back(1, 0.0);
      at.reserve(ring->size() + 1);
      for (size_t i = 0; i < ring->size(); ++i)
        at.push_back(at.back() + Distance((*ring)[i], (*ring)[i + 1 == ring->size() ? 0 : i + 1]));
    }
  }

  /// The stretches between neighbouring ends, shortest first.
  std::vector<Stretch> Stretches() const {
    std::vector<int32_t> order(ends_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [this](int32_t a, int32_t b) {
      return std::tuple(ends_[a].ring, ends_[a].along_nm, a) <
             std::tuple(ends_[b].ring, ends_[b].along_nm, b);
    });
    std::vector<Stretch> stretches;
    for (size_t first = 0; first < order.size();) {
      size_t last = first;
      while (last < order.size() && ends_[order[last]].ring == ends_[order[first]].ring) ++last;
      for (size_t i = first; i < last; ++i) {
        const int32_t from = order[i], to = order[i + 1 == last ? first : i + 1];
        double length = ends_[to].along_nm - ends_[from].along_nm;
        if (i + 1 == last) length += corner_at_[ends_[from].ring].back();
        if (length <= options_.max_link_nm) stretches.push_back({length, from, to});
      }
      first = last;
    }
    std::stable_sort(stretches.begin(), stretches.end(),
                     [](const Stretch& a, const Stretch& b) { return a.length_nm < b.length_nm; });
    return stretches;
  }

  void ChooseLinks(const std::vector<Stretch>& stretches) {
    std::vector<int32_t> path_of(ends_.size() / 2);
    std::iota(path_of.begin(), path_of.end(), 0);
    const auto path = [&](int32_t piece) {
      while (path_of[piece] != piece) piece = path_of[piece] = path_of[path_of[piece]];
      return piece;
    };
    double left = options_.link_budget_nm;
    for (const Stretch& stretch : stretches) {
      if (stretch.length_nm > left) return;
      if (link_[stretch.from] != kNone || link_[stretch.to] != kNone) continue;
      const int32_t a = path(stretch.from / 2), b = path(stretch.to / 2);
      if (a == b) continue;
      path_of[a] = b;
      link_[stretch.from] = stretch.to;
      link_[stretch.to] = stretch.from;
      forward_[stretch.from] = true;
      left -= stretch.length_nm;
    }
  }

  Polyline Follow(int32_t end, std::vector<bool>& done) const {
    Polyline path;
    const auto append = [&path](Point p) {
      if (path.empty() || path.back() != p) path.push_back(p);
    };
    while (true) {
      done[end / 2] = true;
      append(ends_[end].place);
      const int32_t out = end ^ 1;
      append(ends_[out].place);
      end = link_[out];
      if (end == kNone) return path;
      ForEachCorner(*rings_[ends_[out].ring], WayOf(out, end), append);
    }
  }

  /// The way that a link takes from one end to another.
  RingWay WayOf(int32_t from, int32_t to) const {
    const bool forward = forward_[from];
    const bool ahead = (ends_[from].along_nm <= ends_[to].along_nm) == forward;
    return {ends_[from].edge, ends_[to].edge, forward, !ahead};
  }

  const EdgeLinkOptions& options_;
  const std::vector<const Polygon*>& rings_;
  std::vector<std::vector<double>> corner_at_;
  std::vector<End> ends_;
  std::vector<int32_t> link_;  ///< by end: the end it is joined to
  std::vector<bool> forward_;  ///< by end: whether its link runs forwards along the ring
};

}  // namespace

std::vector<Polyline> LinkAlongEdge(std::span<const ScanLines> families,
                                    const EdgeLinkOptions& options) {
  if (families.empty()) return {};
  return Linker(families, options).Run();
}

}  // namespace slicefarm::infill
