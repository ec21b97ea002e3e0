#include "services/motion/algo/toolpath/simplified_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "common/geometry/arc_fit.h"
#include "common/geometry/vector.h"
#include "common/model/bead_section.h"
#include "services/motion/algo/toolpath/divided_path.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {
namespace {

constexpr size_t kMostNodes = 256;
/// Number of nodes, before the farthest node that n beads can reach, from which further beads are
/// tried. On real walls, fewer nodes than this would suffice.
constexpr size_t kLastNodes = 16;
constexpr double kLeastShare = 0.95;
/// Tolerance of lengths, because they are measured before points are rounded.
constexpr double kLengthSlackUm = 2;
/// Largest distance between a position and the same position rounded to whole um.
constexpr double kWholeUm = 0.75;
/// Cosine of 30 degrees. A point at which the path bends by more than this is a corner and is not
/// moved.
constexpr double kCornerCosine = 0.866;
constexpr double kNmPerUm = 1000;
/// Largest difference between the widths of short beads and the path's, as a share.
constexpr double kShortBeadShare = 0.05, kInnerShortBeadShare = 0.1;
/// Rounding error of a distance in double precision.
constexpr double kSlackUm = 1e-3;

/// Rounds like std::round, without a function call.
double Rounded(double um) {
  return static_cast<double>(static_cast<int64_t>(um < 0 ? um - 0.5 : um + 0.5));
}

/// Point of the path, rounded as in the G-code. Widths, length and area describe the path from the
/// previous node.
struct Node {
  Point point;                      ///< point of the path
  Vector2 place = Vector2::Zero();  ///< rounded position, in whole um
  Coord narrowest_nm = 0, widest_nm = 0;
  double along = 0;  ///< length from the start, in um
  double area = 0;   ///< width times length, from the start
  /// Alternative end of a bead, outside the curve. With it, beads deviate to both sides of a curve,
  /// so they can be longer. Equal to `place` at corners, at ends, and where longer beads are
  /// impossible.
  Vector2 outside = Vector2::Zero();
  bool stays = true;  ///< true if no bead may pass this node, so that a bead ends here

  Coord MeanWidthNm() const { return (narrowest_nm + widest_nm) / 2; }
};

/// Returns the nodes of a path. A closed path has its start again at the end.
std::vector<Node> NodesOf(const Path& path) {
  const auto node_at = [&](size_t i) {
    const Point point = path.points[i];
    const Vector2 place = {static_cast<double>(ToUm(point.x)), static_cast<double>(ToUm(point.y))};
    return Node{.point = point, .place = place, .outside = place};
  };
  const size_t count = path.points.size();
  std::vector<Node> nodes = {node_at(0)};
  nodes.reserve(count + 1);
  double along = 0, area = 0;
  for (size_t i = 1; i < count + (path.closed ? 1 : 0); ++i) {
    const size_t at = i < count ? i : 0;
    const double length = Distance(path.points[i - 1], path.points[at]) / kNmPerUm;
    const auto [narrower, wider] = std::minmax({path.WidthAt(i - 1), path.WidthAt(at)});
    Node next = node_at(at);
    next.narrowest_nm = narrower;
    next.widest_nm = wider;
    along += length;
    area += length * static_cast<double>(next.MeanWidthNm());
    if (next.place != nodes.back().place) nodes.push_back(next);
    nodes.back().along = along;
    nodes.back().area = area;
  }
  return nodes;
}

/// Marks the nodes that no bead may pass. Such a node and its two neighbours do not fit into a
/// strip of twice the tolerance. Most nodes of solid infill are of this kind.
void FindStays(double tolerance_um, std::vector<Node>& nodes) {
  for (size_t i = 1; i + 1 < nodes.size(); ++i) {
    const Vector2 in = nodes[i].place - nodes[i - 1].place;
    const Vector2 out = nodes[i + 1].place - nodes[i].place;
    const Vector2 across = nodes[i + 1].place - nodes[i - 1].place;
    const double longest = std::max({Dot(in, in), Dot(out, out), Dot(across, across)});
    const double turn = Cross(in, out);
    nodes[i].stays = turn * turn > 4 * tolerance_um * tolerance_um * longest;
  }
}

/// Sets the alternative ends of beads outside curves.
void FindOutsides(double tolerance_um, std::vector<Node>& nodes) {
  const double away = tolerance_um - kWholeUm;
  if (away <= 0) return;
  for (size_t i = 1; i + 1 < nodes.size(); ++i) {
    if (nodes[i - 1].stays && nodes[i + 1].stays) continue;
    const Vector2 in = nodes[i].place - nodes[i - 1].place;
    const Vector2 out = nodes[i + 1].place - nodes[i].place;
    const double in_length = Norm(in), out_length = Norm(out), turn = Cross(in, out);
    if (turn == 0 || Dot(in, out) < kCornerCosine * in_length * out_length) continue;
    const Vector2 mean = in / in_length + out / out_length;
    const double share = away / Norm(mean) * (turn > 0 ? 1 : -1);
    nodes[i].outside.x() += Rounded(mean.y() * share);
    nodes[i].outside.y() -= Rounded(mean.x() * share);
  }
}

/// Set of directions of rays from a point that meet all given discs. It uses cross products instead
/// of divisions, which would take most of the time: each node tests as many discs as a bead may
/// replace nodes.
class Cone {
 public:
  /// Removes the directions that miss the disc around `centre`. `centre` is relative to the point,
  /// which is outside the disc.
  void Narrow(Vector2 centre, double radius) {
    if (!written_) axis_ = centre;
    written_ = true;
    // Tangents, not normalized.
    const double c = std::sqrt(Dot(centre, centre) - radius * radius);
    const Vector2 right = {centre.x() * c + centre.y() * radius,
                           centre.y() * c - centre.x() * radius};
    const Vector2 left = {centre.x() * c - centre.y() * radius,
                          centre.y() * c + centre.x() * radius};
    const Slope least = SlopeOf(right), most = SlopeOf(left);
    if (least_ < least) least_ = least;
    if (most < most_) most_ = most;
  }

  bool Empty() const { return written_ && !(least_ < most_); }

  bool Holds(Vector2 direction) const {
    if (!written_) return true;
    const Slope slope = {Cross(axis_, direction), Dot(axis_, direction)};
    return slope.ahead > 0 && !(slope < least_) && !(most_ < slope);
  }

 private:
  /// Tangent of the angle from the axis, as a fraction; infinite if `ahead` is 0.
  struct Slope {
    double aside = 0;
    double ahead = 0;  ///< not less than 0

    friend bool operator<(const Slope& a, const Slope& b) {
      return a.aside * b.ahead < b.aside * a.ahead;
    }
  };

  /// Returns the slope of a direction against the axis; infinite for angles of 90 degrees and more.
  /// So a cone to the rear leaves no directions.
  Slope SlopeOf(Vector2 direction) const {
    const double ahead = Dot(axis_, direction), aside = Cross(axis_, direction);
    if (ahead > 0) return {aside, ahead};
    return {aside > 0 ? 1.0 : -1.0, 0};
  }

  bool written_ = false;
  Vector2 axis_ = Vector2::Zero();  ///< direction of the first disc; angles are measured from it
  Slope least_ = {-1, 0};
  Slope most_ = {1, 0};
};

/// Largest differences between beads and the path.
struct Tolerance {
  double place_um = 0;
  double width_share = 0;
  double short_share = 0;  ///< share on beads shorter than kShortBeadNm

  Coord OfWidth(Coord width_nm, double length_um) const {
    const double share =
        length_um * kNmPerUm < kShortBeadNm ? std::max(short_share, width_share) : width_share;
    if (share == 0)
      return length_um * kNmPerUm > kLongBeadNm ? kLongWidthToleranceNm : kWidthToleranceNm;
    return std::max(kWidthToleranceNm,
                    static_cast<Coord>(share * static_cast<double>(width_nm) + 0.5));
  }
};

/// Bead that may replace the path from one node on. The replaced path is extended node by node.
class Reach {
 public:
  /// `begin`: start of the beads.
  Reach(const Node& from, Vector2 begin, const Tolerance& tolerance)
      : from_(from), begin_(begin), tolerance_(tolerance) {}

  /// Extends the replaced path to the next node.
  void Take(const Node& to) {
    even_ = widest_ == 0;  // a single edge is always a valid bead
    narrowest_ = std::min(narrowest_, to.narrowest_nm);
    widest_ = std::max(widest_, to.widest_nm);
    length_ = to.along - from_.along;
    if (even_ || widest_ == narrowest_) {
      even_ = true;
      return;
    }
    // The mean width is rounded to whole nanometres.
    const double area = to.area - from_.area;
    const auto least = static_cast<double>(widest_ - tolerance_.OfWidth(widest_, length_)) - 0.5;
    const auto most =
        static_cast<double>(narrowest_ + tolerance_.OfWidth(narrowest_, length_)) + 0.5;
    even_ = area >= least * length_ && area < most * length_;
  }

  /// Returns the sum of squared deviations of the passed nodes from a bead that ends at `end`.
  /// `end` is at the last node or its `outside`. Returns nothing if the bead may not replace the
  /// nodes.
  std::optional<double> DeviationTo(Vector2 end) const {
    const Vector2 travel = end - begin_;
    const double squared = Dot(travel, travel);
    if (!even_ || squared == 0 || squared < farthest_ || !cone_.Holds(travel)) return std::nullopt;
    const double least = std::max(0.0, kLeastShare * length_ - kLengthSlackUm);
    if (least * least > squared) return std::nullopt;
    return (travel.y() * travel.y() * xx_ - 2 * travel.x() * travel.y() * xy_ +
            travel.x() * travel.x() * yy_) /
           squared;
  }

  /// Requires that the bead passes `place`, the last node, within the tolerance. Returns false if
  /// no bead can.
  bool Pass(Vector2 place) {
    const Vector2 travel = place - begin_;
    const double squared = Dot(travel, travel);
    farthest_ = std::max(farthest_, squared);
    const double away = tolerance_.place_um;
    if (squared > away * away) cone_.Narrow(travel, away);
    xx_ += travel.x() * travel.x();
    xy_ += travel.x() * travel.y();
    yy_ += travel.y() * travel.y();
    return !cone_.Empty() && (widest_ == narrowest_ ||
                              widest_ - narrowest_ <= tolerance_.OfWidth(widest_, length_) +
                                                          tolerance_.OfWidth(narrowest_, length_));
  }

 private:
  const Node& from_;
  const Vector2 begin_;
  const Tolerance tolerance_;
  Cone cone_;
  Coord narrowest_ = std::numeric_limits<Coord>::max();
  Coord widest_ = 0;
  double length_ = 0;  ///< length of the replaced path
  bool even_ = false;  ///< true if one width may replace all widths
  /// Largest squared distance of a passed node from the start; a bead must not end before it.
  double farthest_ = 0;
  double xx_ = 0, xy_ = 0, yy_ = 0;  ///< second moments of the passed nodes around the bead's start
};

/// End of a bead: at a node, or at the node's `outside`.
struct BeadStop {
  size_t node = 0;
  bool outside = false;
  bool on_arc = false;  ///< true if the bead is a piece of an arc
};

Vector2 EndAt(const Node& node, bool outside) { return outside ? node.outside : node.place; }

/// Best known sequence of beads that ends at a stop.
struct BeadChain {
  size_t beads = std::numeric_limits<size_t>::max();
  double deviation = 0;  ///< sum of squared deviations of all nodes
  BeadStop before;

  friend bool operator<(const BeadChain& a, const BeadChain& b) {
    return std::pair(a.beads, a.deviation) < std::pair(b.beads, b.deviation);
  }
};

/// Finds the fewest beads from the first to the last of some nodes, by the best sequence to each
/// stop. Of the nodes that are reached with the same number of beads, only the farthest kLastNodes
/// are extended, which bounds the cost. With two of them the results differ by 0.1 % of all moves;
/// with 17 there is no difference.
class FewestBeads {
 public:
  FewestBeads(std::span<const Node> nodes, const Tolerance& tolerance)
      : nodes_(nodes), tolerance_(tolerance), travels_(nodes.size()), farthest_(nodes.size()) {
    travels_[0][0].beads = 0;
    size_t fewest = 0;  // fewest beads to any node from here on
    for (size_t i = 0; i + 1 < nodes_.size(); ++i) {
      while (farthest_[fewest] < i) ++fewest;
      if (std::min(travels_[i][0].beads, travels_[i][1].beads) != fewest) continue;
      if (i + kLastNodes < farthest_[fewest]) continue;
      for (const bool outside : {false, true})
        if (travels_[i][outside].beads == fewest) GoOnFrom({i, outside});
    }
  }

  /// Returns the ends of the beads, from the first on.
  std::vector<BeadStop> Stops() const {
    std::vector<BeadStop> stops;
    for (BeadStop at = {nodes_.size() - 1}; at.node != 0; at = TravelTo(at).before)
      stops.push_back(at);
    std::ranges::reverse(stops);
    return stops;
  }

 private:
  const BeadChain& TravelTo(BeadStop stop) const { return travels_[stop.node][stop.outside]; }

  void GoOnFrom(BeadStop from) {
    Reach reach(nodes_[from.node], EndAt(nodes_[from.node], from.outside), tolerance_);
    const size_t end = std::min(nodes_.size(), from.node + 1 + kMostNodes);
    const size_t beads = TravelTo(from).beads + 1;
    for (size_t i = from.node + 1; i < end; ++i) {
      reach.Take(nodes_[i]);
      const bool next = !from.outside && i == from.node + 1;
      if (beads <= travels_[i][0].beads)
        Improve({i, false}, from, next ? 0 : reach.DeviationTo(nodes_[i].place));
      if (beads <= travels_[i][1].beads && nodes_[i].outside != nodes_[i].place)
        Improve({i, true}, from, reach.DeviationTo(nodes_[i].outside));
      if (nodes_[i].stays || !reach.Pass(nodes_[i].place)) return;
    }
  }

  void Improve(BeadStop stop, BeadStop from, std::optional<double> deviation) {
    if (!deviation) return;
    const Node& node = nodes_[stop.node];
    const Vector2 away = EndAt(node, stop.outside) - node.place;
    const BeadChain& before = TravelTo(from);
    const BeadChain travel = {before.beads + 1, before.deviation + *deviation + Dot(away, away),
                              from};
    BeadChain& best = travels_[stop.node][stop.outside];
    if (travel < best) best = travel;
    farthest_[travel.beads] = std::max(farthest_[travel.beads], stop.node);
  }

  const std::span<const Node> nodes_;
  const Tolerance tolerance_;
  /// Best sequence to each node, and to the node's `outside`.
  std::vector<std::array<BeadChain, 2>> travels_;
  std::vector<size_t> farthest_;  ///< farthest node that is reached, indexed by number of beads
};

/// Nodes [first, last] that one arc may replace.
struct NodeArc {
  size_t first = 0;
  size_t last = 0;
};

/// Returns the node ranges that arcs of equal width may replace. `nodes`: positions in um.
std::vector<NodeArc> ArcsOf(std::span<const Node> nodes) {
  std::vector<NodeArc> arcs;
  for (size_t first = 0; first + 1 < nodes.size();) {
    std::vector<PointUm> places;
    const auto add = [&](const Node& node) {
      places.push_back(
          {static_cast<int32_t>(node.place.x()), static_cast<int32_t>(node.place.y())});
    };
    add(nodes[first]);
    const int32_t width_um = ToUm(nodes[first + 1].MeanWidthNm());
    for (size_t i = first + 1; i < nodes.size() && ToUm(nodes[i].MeanWidthNm()) == width_um; ++i)
      add(nodes[i]);
    size_t at = first;
    for (const CurvePiece& piece : FitArcs(places)) {
      if (piece.is_arc) arcs.push_back({at, first + piece.last});
      at = first + piece.last;
    }
    first = at;
  }
  return arcs;
}

/// Returns true if each edge between the nodes must be a bead. This is so for most solid infill.
bool StayAll(std::span<const Node> nodes) {
  return std::ranges::all_of(nodes.subspan(1, nodes.size() - 2), [](const Node& node) {
    return node.stays && node.outside == node.place;
  });
}

/// Appends the ends of the fewest beads from nodes[first] to nodes[last].
void AppendFewestBeads(std::span<const Node> nodes, size_t first, size_t last,
                       const Tolerance& tolerance, std::vector<BeadStop>& stops) {
  const std::span<const Node> part = nodes.subspan(first, last - first + 1);
  if (StayAll(part)) {
    for (size_t i = first + 1; i <= last; ++i) stops.push_back({i});
    return;
  }
  for (BeadStop stop : FewestBeads(part, tolerance).Stops())
    stops.push_back({first + stop.node, stop.outside});
}

/// Returns the ends of the beads: pieces of the arcs, and as few beads as possible between arcs.
std::vector<BeadStop> StopsOf(std::span<const Node> nodes, std::vector<NodeArc> arcs,
                              const Tolerance& tolerance) {
  std::vector<BeadStop> stops;
  size_t at = 0;
  arcs.push_back({nodes.size() - 1, nodes.size() - 1});
  for (const NodeArc& arc : arcs) {
    if (at < arc.first) AppendFewestBeads(nodes, at, arc.first, tolerance, stops);
    for (size_t i = arc.first + 1; i <= arc.last; ++i) stops.push_back({i, false, true});
    at = arc.last;
  }
  return stops;
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

/// Appends the points and widths of beads from stop to stop. The first bead begins at the first
/// node.
void PutBeads(std::span<const Node> nodes, std::span<const BeadStop> stops,
              SimplifiedPath& simple) {
  Path& path = simple.path;
  const auto put = [&](BeadStop stop, Coord width_nm) {
    const Node& node = nodes[stop.node];
    path.points.push_back(stop.outside ? Point{std::llround(node.outside.x() * kNmPerUm),
                                               std::llround(node.outside.y() * kNmPerUm)}
                                       : node.point);
    path.widths_nm.push_back(width_nm);
    simple.on_arc.push_back(stop.on_arc);
  };
  BeadStop last;
  for (const BeadStop stop : stops) {
    const Node &start = nodes[last.node], &end = nodes[stop.node];
    const Coord width_nm = std::llround((end.area - start.area) / (end.along - start.along));
    if (path.points.empty() || width_nm != path.widths_nm.back()) put(last, width_nm);
    put(stop, width_nm);
    last = stop;
  }
  simple.on_arc.erase(simple.on_arc.begin());
  const bool even = std::ranges::all_of(
      path.widths_nm, [&](Coord width) { return width == path.widths_nm.front(); });
  if (path.closed && path.widths_nm.back() == path.widths_nm.front()) {
    path.points.pop_back();
    path.widths_nm.pop_back();
  } else if (path.closed) {
    simple.on_arc.push_back(false);
  }
  if (even) path.widths_nm.resize(1);
}

SimplifiedPath Whole(const Path& path, bool keep_arcs) {
  return {path, 1, std::vector<bool>(path.points.size() - (path.closed ? 0 : 1), keep_arcs)};
}

}  // namespace

SimplifiedPath Simplified(const Path& path, const SimplifyOptions& options) {
  std::vector<Node> nodes = NodesOf(path);
  const Tolerance tolerance{static_cast<double>(options.tolerance_nm) / kNmPerUm - kSlackUm,
                            options.width_share,
                            options.inside ? kInnerShortBeadShare : kShortBeadShare};
  if (nodes.size() < 3 || tolerance.place_um <= 0) return Whole(path, options.keep_arcs);
  FindStays(tolerance.place_um, nodes);
  FindOutsides(tolerance.place_um, nodes);
  const std::vector<BeadStop> stops =
      StopsOf(nodes, options.keep_arcs ? ArcsOf(nodes) : std::vector<NodeArc>{}, tolerance);
  if (path.closed && stops.size() < 3) return Whole(path, options.keep_arcs);
  SimplifiedPath simple;
  simple.path = {path.feature,    path.settings, path.inset, path.ring, path.closed,
                 path.reversible, path.tool,     {},         {}};
  PutBeads(nodes, stops, simple);
  simple.flow = path.widths_nm.size() == 1 ? nodes.back().along * kNmPerUm / PathLength(simple.path)
                                           : Plastic(path, options.bead_height_nm) /
                                                 Plastic(simple.path, options.bead_height_nm);
  return simple;
}

}  // namespace slicefarm::motion
