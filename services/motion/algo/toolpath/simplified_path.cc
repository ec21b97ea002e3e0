#include "services/motion/algo/toolpath/simplified_path.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "common/model/bead_section.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {
namespace {

constexpr size_t kMostNodes = 256;
constexpr double kLeastShare = 0.95;
/// Lengths are of points before they are rounded.
constexpr double kLengthSlackUm = 2;
/// What rounding of doubles may do to a distance.
constexpr double kSlackUm = 1e-3;

/// Um.
struct Vector {
  double x = 0;
  double y = 0;
};

Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
double Cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
double Dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }

/// A place to which the path leads in the text. What leads there is said of the way from the node
/// before.
struct Node {
  size_t point = 0;  ///< of the path
  Vector place;      ///< whole um
  double width = 0;  ///< nm
  double along = 0;  ///< length from the start, um
  double area = 0;   ///< width times length, from the start
};

/// Nodes of a path, its start once more at the end of a closed one.
std::vector<Node> NodesOf(const Path& path) {
  const auto place = [&](size_t i) {
    return Vector{static_cast<double>(ToUm(path.points[i].x)),
                  static_cast<double>(ToUm(path.points[i].y))};
  };
  std::vector<Node> nodes = {{0, place(0)}};
  nodes.reserve(path.points.size() + 1);
  double along = 0, area = 0;
  const size_t count = path.points.size();
  for (size_t i = 1; i < count + (path.closed ? 1 : 0); ++i) {
    const size_t at = i < count ? i : 0;
    const double length = Distance(path.points[i - 1], path.points[at]) / 1000;
    const auto width = static_cast<double>((path.WidthAt(i - 1) + path.WidthAt(at)) / 2);
    along += length;
    area += length * width;
    const Node next = {at, place(at), width, along, area};
    Node& last = nodes.back();
    if (next.place.x == last.place.x && next.place.y == last.place.y) {
      last.along = along;
      last.area = area;
    } else {
      nodes.push_back(next);
    }
  }
  return nodes;
}

/// The directions of rays from a point that pass discs.
class Cone {
 public:
  /// Leaves those that pass the disc around `centre`, seen from the point, which lies outside.
  void Narrow(Vector centre, double radius) {
    if (!told_) axis_ = centre;
    told_ = true;
    const double squared = Dot(centre, centre);
    const double s = std::sqrt(radius * radius / squared), c = std::sqrt(1 - s * s);
    const Vector right = {centre.x * c + centre.y * s, centre.y * c - centre.x * s};
    const Vector left = {centre.x * c - centre.y * s, centre.y * c + centre.x * s};
    least_ = std::max(least_, SlopeOf(right));
    most_ = std::min(most_, SlopeOf(left));
  }

  bool Empty() const { return !(least_ < most_); }

  bool Holds(Vector direction) const {
    if (!told_) return true;
    const double ahead = Dot(axis_, direction);
    const double slope = Cross(axis_, direction) / ahead;
    return ahead > 0 && least_ <= slope && slope <= most_;
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  /// Tangent of the angle from the axis, without end where that is a right one or more. So a cone
  /// that lies behind leaves nothing.
  double SlopeOf(Vector direction) const {
    const double ahead = Dot(axis_, direction), aside = Cross(axis_, direction);
    if (ahead > 0) return aside / ahead;
    return aside > 0 ? kInfinity : -kInfinity;
  }

  bool told_ = false;
  Vector axis_;  ///< the first disc's direction, which all others are seen from
  double least_ = -kInfinity;
  double most_ = kInfinity;
};

/// The beads that may stand for what begins at one node, grown node by node.
class Reach {
 public:
  Reach(const std::vector<Node>& nodes, size_t from, double tolerance_um)
      : nodes_(nodes), from_(from), tolerance_um_(tolerance_um) {}

  /// To be called for one node after the other. Whether a bead may end at it.
  bool Take(size_t to) {
    const Node& start = nodes_[from_];
    const Node& end = nodes_[to];
    narrowest_ = std::min(narrowest_, end.width);
    widest_ = std::max(widest_, end.width);
    way_ = end.place - start.place;
    squared_ = Dot(way_, way_);
    const double length = end.along - start.along;
    const double width = (end.area - start.area) / length;
    return squared_ > 0 && squared_ >= farthest_ && cone_.Holds(way_) &&
           widest_ - width <= kWidthToleranceNm && width - narrowest_ <= kWidthToleranceNm &&
           kLeastShare * length <= std::sqrt(squared_) + kLengthSlackUm;
  }

  /// The squared deviations of the nodes passed from a bead to the node taken last.
  double Deviation() const {
    return (way_.y * way_.y * xx_ - 2 * way_.x * way_.y * xy_ + way_.x * way_.x * yy_) / squared_;
  }

  /// Lets beads pass the node taken last. False if none may.
  bool Pass() {
    farthest_ = std::max(farthest_, squared_);
    if (squared_ > tolerance_um_ * tolerance_um_) cone_.Narrow(way_, tolerance_um_);
    xx_ += way_.x * way_.x;
    xy_ += way_.x * way_.y;
    yy_ += way_.y * way_.y;
    return !cone_.Empty() && widest_ - narrowest_ <= 2 * kWidthToleranceNm;
  }

 private:
  const std::vector<Node>& nodes_;
  const size_t from_;
  const double tolerance_um_;
  Cone cone_;
  double narrowest_ = std::numeric_limits<double>::infinity();
  double widest_ = 0;
  double farthest_ = 0;  ///< squared distance of what was passed: beads must not end before it
  double xx_ = 0, xy_ = 0, yy_ = 0;  ///< moments of what was passed, around the start
  Vector way_;                       ///< to the node taken last
  double squared_ = 0;
};

/// The nodes between which the fewest beads run, first and last included.
std::vector<size_t> FewestBeads(const std::vector<Node>& nodes, double tolerance_um) {
  struct Best {
    size_t beads = std::numeric_limits<size_t>::max();
    double deviation = 0;
    size_t from = 0;
  };
  std::vector<Best> best(nodes.size());
  best[0].beads = 0;
  for (size_t from = 0; from + 1 < nodes.size(); ++from) {
    Reach reach(nodes, from, tolerance_um);
    const size_t end = std::min(nodes.size(), from + 1 + kMostNodes);
    for (size_t to = from + 1; to < end; ++to) {
      // What is written after all needs no reason: from node to node.
      if (reach.Take(to) || to == from + 1) {
        const Best here = {best[from].beads + 1, best[from].deviation + reach.Deviation(), from};
        if (std::pair(here.beads, here.deviation) < std::pair(best[to].beads, best[to].deviation))
          best[to] = here;
      }
      if (!reach.Pass()) break;
    }
  }
  std::vector<size_t> kept = {nodes.size() - 1};
  while (kept.back() != 0) kept.push_back(best[kept.back()].from);
  std::ranges::reverse(kept);
  return kept;
}

double Plastic(const Path& path, Coord bead_height_nm) {
  double plastic = 0, section = 0;
  Coord of_width = -1;
  const size_t count = path.points.size();
  for (size_t i = 1; i < count + (path.closed ? 1 : 0); ++i) {
    const size_t to = i < count ? i : 0;
    const Coord width = (path.WidthAt(i - 1) + path.WidthAt(to)) / 2;
    if (width != of_width) section = SectionMm2(width, bead_height_nm);
    of_width = width;
    plastic += section * Distance(path.points[i - 1], path.points[to]);
  }
  return plastic;
}

/// The points and widths of beads between nodes.
void PutBeads(const std::vector<Node>& nodes, const std::vector<size_t>& kept, const Path& from,
              Path& path) {
  const auto put = [&](size_t node, Coord width_nm) {
    path.points.push_back(from.points[nodes[node].point]);
    path.widths_nm.push_back(width_nm);
  };
  for (size_t i = 1; i < kept.size(); ++i) {
    const Node &start = nodes[kept[i - 1]], &end = nodes[kept[i]];
    const Coord width_nm = std::llround((end.area - start.area) / (end.along - start.along));
    if (i == 1 || width_nm != path.widths_nm.back()) put(kept[i - 1], width_nm);
    put(kept[i], width_nm);
  }
  const bool even = std::ranges::all_of(
      path.widths_nm, [&](Coord width) { return width == path.widths_nm.front(); });
  if (path.closed && path.widths_nm.back() == path.widths_nm.front()) {
    path.points.pop_back();
    path.widths_nm.pop_back();
  }
  if (even) path.widths_nm.resize(1);
}

}  // namespace

SimplifiedPath Simplified(const Path& path, Coord tolerance_nm, Coord bead_height_nm) {
  const std::vector<Node> nodes = NodesOf(path);
  const double tolerance_um = static_cast<double>(tolerance_nm) / 1000 - kSlackUm;
  if (nodes.size() < 3 || tolerance_um <= 0) return {path};
  const std::vector<size_t> kept = FewestBeads(nodes, tolerance_um);
  if (path.closed && kept.size() < 4) return {path};
  SimplifiedPath simple;
  simple.path = {path.feature,    path.settings, path.inset, path.ring, path.closed,
                 path.reversible, path.tool,     {},         {}};
  PutBeads(nodes, kept, path, simple.path);
  simple.flow = Plastic(path, bead_height_nm) / Plastic(simple.path, bead_height_nm);
  return simple;
}

}  // namespace slicefarm::motion
