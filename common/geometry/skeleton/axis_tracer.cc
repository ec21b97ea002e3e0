#include "common/geometry/skeleton/axis_tracer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/geometry/skeleton/axis_order.h"
#include "common/geometry/skeleton/bisector.h"
#include "common/geometry/skeleton/site_tree.h"

namespace slicefarm {
namespace {

/// Distances that differ by at most this are equal.
constexpr double kEqualNm = 0.02;
/// Largest distance between the positions of one node that is reached along two edges.
constexpr double kSameNodeNm = 20;
/// Discs tried for one edge before the search is given up.
constexpr int kMostDiscs = 64;
/// Number of tested sites, per edge of the boundary, after which tracing gives up. Boost.Polygon's
/// diagram takes about as long as this number of tests.
constexpr int kMostTestsPerEdge = 400;

/// A feature that a disc touches, and the point of contact.
struct Contact {
  BoundaryFeature feature;
  Vector2 at;  ///< relative to the centre of the disc
};

class Tracer {
 public:
  explicit Tracer(const Boundary& boundary) : boundary_(boundary), sites_(boundary) {
    const size_t edges = boundary.edges.size();
    graph_.nodes.reserve(2 * edges);
    graph_.half_edges.reserve(4 * edges);
    int first = static_cast<int>(boundary.rings[0].size());
    for (int hole = 0; hole < boundary.Holes(); ++hole) {
      holes_.push_back(first);
      first += static_cast<int>(boundary.rings[hole + 1].size());
    }
    std::sort(holes_.begin(), holes_.end(), [&](int a, int b) {
      return std::pair(sites_[a].from.x(), a) < std::pair(sites_[b].from.x(), b);
    });
    open_beside_.assign(holes_.empty() ? 0 : 2 * edges, -1);
    tests_left_ = kMostTestsPerEdge * static_cast<int64_t>(edges) + 4'000;
  }

  bool Run() {
    // The leftmost corner of the outer ring is convex, unless the ring runs clockwise.
    const Polygon& outer = boundary_.rings[0];
    const int corner =
        static_cast<int>(std::min_element(outer.begin(), outer.end()) - outer.begin());
    if (!boundary_.StartsConvex(corner)) return false;
    const int start = AddNode(sites_[corner].from, 0);
    const int half = AddEdge(start, {boundary_.edges[corner].previous, false}, {corner, false});
    Link(half ^ 1, half);
    while (!open_.empty()) {
      const int next = open_.back();
      open_.pop_back();
      if (graph_.half_edges[next].from < 0) continue;
      if (!Trace(next)) return false;
    }
    return true;
  }

  /// Returns the graph. The edges that were joined with others start at no node.
  SkeletalGraph Take() { return std::move(graph_); }

 private:
  // --- graph -------------------------------------------------------------------------------------

  int AddNode(const Vector2& place, double radius) {
    graph_.nodes.push_back({place, radius});
    return static_cast<int>(graph_.nodes.size()) - 1;
  }

  /// Adds an edge of which only the start is known. Returns its half-edge that leaves `node`.
  int AddEdge(int node, BoundaryFeature left, BoundaryFeature right) {
    const int half = static_cast<int>(graph_.half_edges.size());
    graph_.half_edges.push_back({node, -1, -1, left.edge, left.is_corner});
    graph_.half_edges.push_back({-1, -1, -1, right.edge, right.is_corner});
    open_.push_back(half);
    return half;
  }

  void Link(int half, int next) {
    graph_.half_edges[half].next = next;
    graph_.half_edges[next].previous = half;
  }

  BoundaryFeature LeftOf(int half) const {
    return {graph_.half_edges[half].feature, graph_.half_edges[half].is_corner};
  }

  // --- features ----------------------------------------------------------------------------------

  /// Returns true if one of the features is an edge and the other is the corner at its end, in the
  /// ring's order.
  bool AreJoined(BoundaryFeature first, BoundaryFeature second) const {
    if (first.is_corner) return !second.is_corner && first.edge == second.edge;
    return second.is_corner && boundary_.edges[first.edge].next == second.edge;
  }

  SidedLine LineOf(int edge, const Vector2& origin) const {
    const Site& site = sites_[edge];
    return {TurnedLeft(site.direction), site.SideOf(origin)};
  }

  /// Returns true if the start of `edge` is an end of the feature.
  bool IsEndOf(BoundaryFeature feature, int edge) const {
    return feature.edge == edge ||
           (!feature.is_corner && boundary_.edges[feature.edge].next == edge);
  }

  std::optional<Bisector> Between(BoundaryFeature left, BoundaryFeature right,
                                  const Vector2& origin) const {
    const auto corner = [&](BoundaryFeature f) -> Vector2 { return sites_[f.edge].from - origin; };
    if (left.is_corner && right.is_corner) return Bisector::OfPoints(corner(left), corner(right));
    if (left.is_corner) return Bisector::OfPointAndLine(corner(left), LineOf(right.edge, origin));
    if (right.is_corner) return Bisector::OfLineAndPoint(LineOf(left.edge, origin), corner(right));
    return Bisector::OfLines(LineOf(left.edge, origin), LineOf(right.edge, origin));
  }

  // --- one edge of the axis ----------------------------------------------------------------------

  /// An edge of the axis from its start to the disc at its end, as far as that is known.
  struct Search {
    BoundaryFeature left, right;
    Vector2 origin;  ///< start of the edge; positions on the curve are relative to it
    Bisector curve;
    double start = 0;  ///< parameter
    double end = 0;
    Disc disc;  ///< disc at the end, relative to the boundary's origin

    void SetEnd(double t) {
      end = t;
      disc = curve.At(t);
      disc.centre += origin;
    }
  };

  bool Trace(int half) {
    const BoundaryFeature left = LeftOf(half), right = LeftOf(half ^ 1);
    const int from = graph_.half_edges[half].from;
    const Vector2 origin = graph_.nodes[from].place;
    std::optional<Bisector> curve = Between(left, right, origin);
    if (!curve) return false;
    Search search{left, right, origin, *std::move(curve), 0, 0, {}};
    search.start = search.curve.ParameterOf(Vector2::Zero());
    if (EndsInCorner(left, right)) {
      search.SetEnd(search.curve.ParameterOf(sites_[left.edge].from - origin));
      search.disc.radius = 0;
      if (!TakeHole(search)) return EndInCorner(half);
    } else {
      StartSearch(search);
    }
    for (int tries = 0; tries < kMostDiscs; ++tries) {
      const Intruder intruder = FindIntruder(search);
      if (tests_left_ < 0) return false;
      if (intruder.edge >= 0) {
        if (!Shrink(intruder, search)) return false;
      } else if (!TakeHole(search)) {
        return EndAtNode(half, search);
      }
    }
    return false;
  }

  bool EndsInCorner(BoundaryFeature left, BoundaryFeature right) const {
    return !left.is_corner && !right.is_corner &&
           boundary_.edges[left.edge].previous == right.edge && boundary_.StartsConvex(left.edge);
  }

  bool EndInCorner(int half) {
    const int edge = graph_.half_edges[half].feature;
    graph_.half_edges[half ^ 1].from = AddNode(sites_[edge].from, 0);
    Link(half, half ^ 1);
    return true;
  }

  /// Returns the parameter at which the contact on `feature` reaches the end of the feature, in the
  /// walk of the left or the right side.
  double EndOf(BoundaryFeature feature, bool left, const Search& search) const {
    const int edge = feature.edge;
    const Site& site = sites_[edge];
    Vector2 end = site.from - search.origin;
    const Site* across = &site;
    bool tests_side = feature.is_corner;
    if (feature.is_corner) {
      if (left) across = &sites_[boundary_.edges[edge].previous];
    } else if (!left) {
      end = site.To() - search.origin;
    }
    double least = kFar;
    for (const double t :
         search.curve.Crossing({across->direction, -Dot(across->direction, end)})) {
      if (t < search.start - kEqualNm || t >= least) continue;
      if (tests_side && Cross(across->direction, search.curve.At(t).centre - end) <= 0) continue;
      least = t;
    }
    return least;
  }

  /// Sets the first disc of the search. It is beyond the end of the edge or at it.
  void StartSearch(Search& search) const {
    double end = std::min(EndOf(search.left, true, search), EndOf(search.right, false, search));
    if (end == kFar) end = search.start + 4 * sites_.Diagonal();
    search.SetEnd(std::max(end, search.start));
    // Beside a convex corner, the neighbouring edge is often the next feature.
    for (const bool left : {true, false}) {
      const BoundaryFeature side = left ? search.left : search.right;
      if (side.is_corner) continue;
      const int corner = left ? side.edge : boundary_.edges[side.edge].next;
      if (boundary_.StartsConvex(corner))
        ShrinkToEdge(left ? boundary_.edges[side.edge].previous : corner, search);
    }
  }

  // --- features in a disc ------------------------------------------------------------------------

  /// The edge of the boundary that is nearest to the centre of a disc, if it is in the disc.
  struct Intruder {
    int edge = -1;
    double along = 0;  ///< position of its nearest point on the edge
  };

  /// Returns the nearest edge within the disc of the search. If there is none, sets contacts_ to
  /// the features that the disc touches.
  Intruder FindIntruder(const Search& search) {
    contacts_.clear();
    const Vector2 p = search.disc.centre;
    const double inner = std::max(search.disc.radius - kEqualNm, 0.0);
    const double outer = search.disc.radius + kEqualNm;
    Intruder intruder;
    double limit = outer * outer, nearest = inner * inner;
    sites_.ForEachWithin(p, limit, [&](int edge) {
      --tests_left_;
      const Site& site = sites_[edge];
      const double position = site.Along(p), side = site.SideOf(p);
      const double along = std::clamp(position, 0.0, site.length);
      const double beyond = position - along;
      const double squared = side * side + beyond * beyond;
      if (squared > limit) return;
      if (squared < nearest) {
        nearest = limit = squared;
        intruder = {edge, along};
        return;
      }
      if (intruder.edge < 0) AddContacts(edge, position, p);
    });
    return intruder;
  }

  /// Adds the edge and the corner at its start, as far as a disc around `p` touches them.
  void AddContacts(int edge, double position, const Vector2& p) {
    const Site& site = sites_[edge];
    if (position >= -kEqualNm && position <= site.length + kEqualNm)
      contacts_.push_back(
          {{edge, false}, site.from + std::clamp(position, 0.0, site.length) * site.direction - p});
    if (!site.starts_reflex || position > kEqualNm) return;
    const Site& before = sites_[boundary_.edges[edge].previous];
    if (before.Along(p) >= before.length - kEqualNm)
      contacts_.push_back({{edge, true}, site.from - p});
  }

  // --- smaller discs -----------------------------------------------------------------------------

  /// Moves the end of the search back to the disc that only touches the intruder.
  bool Shrink(const Intruder& intruder, Search& search) const {
    const Site& site = sites_[intruder.edge];
    if (intruder.along > 0 && intruder.along < site.length && site.SideOf(search.disc.centre) > 0 &&
        ShrinkToEdge(intruder.edge, search))
      return true;
    return ShrinkToPoint(site.from + intruder.along * site.direction, search, -kEqualNm);
  }

  /// Moves the end back to the first disc that touches the edge. Returns false if there is none.
  bool ShrinkToEdge(int edge, Search& search) const {
    const Site& site = sites_[edge];
    for (const double t : search.curve.Touching(LineOf(edge, search.origin))) {
      if (t < search.start - kEqualNm || t >= search.end) continue;
      const Disc disc = search.curve.At(t);
      if (!(disc.radius > 0)) continue;
      const double along = site.Along(disc.centre + search.origin);
      if (along < 0 || along > site.length) continue;
      if (!IsAhead(-disc.radius * TurnedLeft(site.direction), disc, search)) continue;
      search.SetEnd(t);
      return true;
    }
    return false;
  }

  /// Moves the end back to the first disc that touches the point. Returns false if there is none,
  /// or if it is nearer to the start or to the end than `margin`.
  bool ShrinkToPoint(const Vector2& point, Search& search, double margin) const {
    const Vector2 place = point - search.origin;
    for (const double t : search.curve.Touching(place)) {
      if (t < search.start + margin || t >= search.end - std::max(margin, 0.0)) continue;
      const Disc disc = search.curve.At(t);
      if (!(disc.radius > 0) || !IsAhead(place - disc.centre, disc, search)) continue;
      search.SetEnd(t);
      return true;
    }
    return false;
  }

  /// Moves the end back if a hole is between the start and the end. Such a hole may touch neither
  /// disc, and then no search near the discs finds it.
  bool TakeHole(Search& search) {
    if (holes_.empty()) return false;
    const Disc start = search.curve.At(search.start);
    Eigen::AlignedBox2d box;
    for (const Disc& disc : {Disc{start.centre + search.origin, start.radius}, search.disc}) {
      box.extend(disc.centre - Vector2::Constant(disc.radius));
      box.extend(disc.centre + Vector2::Constant(disc.radius));
    }
    const double end = search.end;
    const auto first = std::partition_point(holes_.begin(), holes_.end(), [&](int edge) {
      return sites_[edge].from.x() < box.min().x();
    });
    for (auto hole = first; hole != holes_.end(); ++hole) {
      const Vector2& place = sites_[*hole].from;
      if (place.x() > box.max().x()) break;
      --tests_left_;
      if (place.y() < box.min().y() || place.y() > box.max().y()) continue;
      if (IsEndOf(search.left, *hole) || IsEndOf(search.right, *hole)) continue;
      ShrinkToPoint(place, search, kEqualNm);
    }
    return search.end < end;
  }

  // --- contacts of a disc ------------------------------------------------------------------------

  /// Returns the contact of the disc with one of the features of the search, relative to the
  /// disc's centre.
  Vector2 ContactWith(BoundaryFeature feature, const Vector2& centre, const Vector2& origin) const {
    const Site& site = sites_[feature.edge];
    const Vector2 p = centre + origin;
    if (feature.is_corner) return site.from - p;
    return -site.SideOf(p) * TurnedLeft(site.direction);
  }

  /// Returns true if the contact `at` is ahead: from the contact with the right feature counter-
  /// clockwise to the contact with the left one.
  bool IsAhead(const Vector2& at, const Disc& disc, const Search& search) const {
    const Vector2 right = ContactWith(search.right, disc.centre, search.origin);
    const Vector2 left = ContactWith(search.left, disc.centre, search.origin);
    return IsBetween(right, at, left);
  }

  static bool IsBetween(const Vector2& right, const Vector2& at, const Vector2& left) {
    if (Cross(right, left) > 0) return Cross(right, at) >= 0 && Cross(at, left) >= 0;
    return Cross(right, at) >= 0 || Cross(at, left) >= 0;
  }

  /// Leaves in contacts_ the contacts ahead, from the right feature to the left one. Returns false
  /// if the disc does not touch both features of the search and a third one.
  bool SortContacts(const Search& search) {
    const auto find = [&](BoundaryFeature feature) {
      return std::find_if(contacts_.begin(), contacts_.end(),
                          [&](const Contact& c) { return c.feature == feature; });
    };
    const auto right = find(search.right), left = find(search.left);
    if (right == contacts_.end() || left == contacts_.end()) return false;
    const Contact first = *right, last = *left;
    sorted_.clear();
    sorted_.push_back(first);
    for (const Contact& contact : contacts_) {
      if (contact.feature == first.feature || contact.feature == last.feature) continue;
      const bool joined =
          AreJoined(first.feature, contact.feature) || AreJoined(contact.feature, last.feature);
      if (!joined &&
          (AreJoined(contact.feature, first.feature) || AreJoined(last.feature, contact.feature) ||
           !IsBetween(first.at, contact.at, last.at)))
        continue;
      sorted_.push_back(contact);
    }
    std::sort(sorted_.begin() + 1, sorted_.end(),
              [&](const Contact& a, const Contact& b) { return ComesFirst(a, b, first, last); });
    sorted_.push_back(last);
    return sorted_.size() > 2;
  }

  /// Returns true if `a` comes before `b` from the contact `first` to `last`.
  bool ComesFirst(const Contact& a, const Contact& b, const Contact& first,
                  const Contact& last) const {
    if (a.feature == b.feature) return false;
    if (AreJoined(a.feature, b.feature)) return true;
    if (AreJoined(b.feature, a.feature)) return false;
    if (AreJoined(first.feature, a.feature) || AreJoined(b.feature, last.feature)) return true;
    if (AreJoined(first.feature, b.feature) || AreJoined(a.feature, last.feature)) return false;
    const bool a_beyond = Cross(first.at, a.at) < 0, b_beyond = Cross(first.at, b.at) < 0;
    if (a_beyond != b_beyond) return b_beyond;
    return Cross(a.at, b.at) > 0;
  }

  // --- nodes -------------------------------------------------------------------------------------

  bool EndAtNode(int half, const Search& search) {
    if (!SortContacts(search)) return false;
    if (JoinOpenEdge(half, search)) return true;
    if (graph_.nodes.size() > 8 * boundary_.edges.size()) return false;
    const int node = AddNode(search.disc.centre, search.disc.radius);
    graph_.half_edges[half ^ 1].from = node;
    int last = half ^ 1;
    for (size_t i = 0; i + 1 < sorted_.size(); ++i) {
      const BoundaryFeature right = sorted_[i].feature, left = sorted_[i + 1].feature;
      if (AreJoined(right, left)) continue;
      const int leaving = AddEdge(node, left, right);
      Link(leaving ^ 1, last);
      last = leaving;
      Remember(leaving, left);
    }
    Link(half, last);
    return last != (half ^ 1);
  }

  static size_t IndexOf(BoundaryFeature feature) { return 2 * feature.edge + feature.is_corner; }

  /// Adds an open half-edge to the list of its left feature.
  void Remember(int half, BoundaryFeature left) {
    if (holes_.empty()) return;
    next_open_.resize(graph_.half_edges.size(), -1);
    int& head = open_beside_[IndexOf(left)];
    next_open_[half] = head;
    head = half;
  }

  /// If the end of `half` is a node from which an edge between the same features is still open,
  /// makes one edge of the two. This closes a cycle around a hole.
  bool JoinOpenEdge(int half, const Search& search) {
    if (holes_.empty()) return false;
    int* link = &open_beside_[IndexOf(search.right)];
    while (*link >= 0) {
      const int open = *link;
      const HalfEdge& other = graph_.half_edges[open];
      const bool is_open = other.from >= 0 && graph_.half_edges[open ^ 1].from < 0;
      if (is_open && (LeftOf(open ^ 1) != search.left || !IsAtEnd(other.from, search))) {
        link = &next_open_[open];
        continue;
      }
      *link = next_open_[open];
      if (is_open) return Join(half, open), true;
    }
    return false;
  }

  bool IsAtEnd(int node, const Search& search) const {
    return Norm(graph_.nodes[node].place - search.disc.centre) <= kSameNodeNm;
  }

  /// Gives the end of `half` the node from which `open` leaves, and removes `open`.
  void Join(int half, int open) {
    HalfEdge &out = graph_.half_edges[open], &back = graph_.half_edges[open ^ 1];
    graph_.half_edges[half ^ 1].from = out.from;
    Link(half, back.next);
    Link(out.previous, half ^ 1);
    out.from = back.from = -1;
  }

  static constexpr double kFar = std::numeric_limits<double>::infinity();

  const Boundary& boundary_;
  const SiteTree sites_;
  SkeletalGraph graph_;
  std::vector<int> open_;   ///< half-edges of which the end is not known
  std::vector<int> holes_;  ///< first edge of each hole, by the x of its start
  // Lists of open half-edges by their left feature, if there are holes.
  std::vector<int> open_beside_;  ///< first of the list
  std::vector<int> next_open_;    ///< next half-edge in the list, by half-edge
  std::vector<Contact> contacts_, sorted_;
  int64_t tests_left_ = 0;
};

}  // namespace

std::optional<SkeletalGraph> TraceAxis(const Boundary& boundary) {
  Tracer tracer(boundary);
  if (!tracer.Run()) return std::nullopt;
  return InSweepOrder(tracer.Take());
}

}  // namespace slicefarm
