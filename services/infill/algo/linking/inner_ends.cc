#include "services/infill/algo/linking/inner_ends.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "common/base/disjoint_sets.h"
#include "common/geometry/edge_index.h"
#include "common/geometry/measure.h"
#include "services/infill/algo/lines/shortened.h"
#include "services/infill/algo/linking/part_beside.h"
#include "services/infill/algo/linking/taken_edge.h"
#include "services/infill/algo/space_filling/segment_grid.h"

namespace slicefarm::infill {
namespace {

constexpr int32_t kNone = -1;
/// Largest part of a piece that may be cut off at each end.
constexpr double kMostCut = 0.48;
/// Length cut off from ends that face each other, in multiples of their distance.
constexpr double kFacingCut = 2;
/// Weight of the added length relative to the distance.
constexpr double kAddedCost = 4;
/// Difference between distances that count as equal, as a share of the reach. Lines at even
/// distances are therefore joined in their order.
constexpr double kAlike = 1.0 / 64;
constexpr int kHalvings = 24;

/// Joint of two ends. Ends 2i and 2i + 1 belong to piece i.
struct Joint {
  int32_t a = 0;
  int32_t b = 0;
  double cut_nm = 0;  ///< length cut off from each of the two pieces
  int64_t rank = 0;   ///< joints with a lower rank are made first
  Point from, to;

  int32_t Other(int32_t end) const { return end == a ? b : a; }
};

/// Segment of a piece.
struct Line {
  Point a, b;
  int32_t piece = 0;
};

size_t U(int32_t number) { return static_cast<size_t>(number); }

/// Returns true if beads on these segments overlap over a length of more than their width.
bool LieTogether(Point a, Point b, Point c, Point d, double width_nm) {
  const auto part = PartBeside(a, b, c, d, kLeastApart * width_nm);
  return part && part->to_nm - part->from_nm > width_nm;
}

/// Ends of pieces, and indexes of the edges and lines around them.
class Ends {
 public:
  Ends(const MultiPolygon& region, std::span<const Piece> pieces, const InnerJoints& options)
      : pieces_(pieces),
        options_(options),
        edges_(region, std::max<Coord>(1, std::llround(options.reach_nm))),
        lines_(BoxOf(pieces), std::max(options.reach_nm, options.width_nm)) {
    for (const Piece& piece : pieces) {
      lengths_.push_back(Length(piece.points));
      for (size_t i = 1; i < piece.points.size(); ++i) {
        lines_.Add(piece.points[i - 1], piece.points[i], static_cast<int32_t>(segments_.size()));
        segments_.push_back(
            {piece.points[i - 1], piece.points[i], static_cast<int32_t>(lengths_.size()) - 1});
      }
    }
  }

  int32_t size() const { return static_cast<int32_t>(2 * pieces_.size()); }
  const Piece& PieceOf(int32_t end) const { return pieces_[U(end / 2)]; }
  double LengthOf(int32_t end) const { return lengths_[U(end / 2)]; }
  EdgePosition PositionOf(int32_t end) const {
    return end % 2 == 0 ? PieceOf(end).from : PieceOf(end).to;
  }

  /// Returns all possible joints, sorted by rank.
  std::vector<Joint> Joints() const {
    std::vector<int32_t> inner;
    Box box;
    for (int32_t end = 0; end < size(); ++end) {
      if (PieceOf(end).closed || PositionOf(end).ring >= 0) continue;
      inner.push_back(end);
      box.Add(PointOf(end));
    }
    std::vector<Joint> joints;
    if (inner.size() < 2) return joints;
    SegmentGrid grid(box, options_.reach_nm);
    for (const int32_t end : inner) grid.Add(PointOf(end), PointOf(end), end);
    for (const int32_t a : inner) {
      grid.ForEachNear(PointOf(a), PointOf(a), options_.reach_nm, [&](int32_t b) {
        if (b <= a || Distance(PointOf(a), PointOf(b)) > options_.reach_nm) return;
        if (const auto joint = JointOf(a, b)) joints.push_back(*joint);
      });
    }
    const auto order = [](const Joint& joint) { return std::tuple(joint.rank, joint.a, joint.b); };
    std::ranges::sort(joints, {}, order);
    joints.erase(std::unique(joints.begin(), joints.end(),
                             [&](const Joint& a, const Joint& b) { return order(a) == order(b); }),
                 joints.end());
    return joints;
  }

 private:
  static Box BoxOf(std::span<const Piece> pieces) {
    Box box;
    for (const Piece& piece : pieces)
      for (const Point p : piece.points) box.Add(p);
    return box;
  }

  Point PointOf(int32_t end) const {
    return end % 2 == 0 ? PieceOf(end).points.front() : PieceOf(end).points.back();
  }

  /// Returns the joint of two ends, or nothing if there is no space for it.
  std::optional<Joint> JointOf(int32_t a, int32_t b) const {
    const double apart = Distance(PointOf(a), PointOf(b));
    const auto added = [&](double cut) {
      return Distance(Before(a, cut), Before(b, cut)) - 2 * cut;
    };
    double cut = std::min({kMostCut * LengthOf(a), kMostCut * LengthOf(b), kFacingCut * apart});
    const double least = std::max(0.0, added(cut));
    if (least > options_.most_added * apart) return std::nullopt;
    if (least == 0) {
      double low = 0;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = (low + cut) / 2;
        (added(middle) > 0 ? low : cut) = middle;
      }
    }
    const Point from = Before(a, cut), to = Before(b, cut);
    if (edges_.Meets(from, to) || LiesOnOthers(from, to, a / 2, b / 2)) return std::nullopt;
    const double rank = (apart + kAddedCost * least) / (kAlike * options_.reach_nm);
    return Joint{a, b, cut, std::llround(rank), from, to};
  }

  /// Returns true if a joint would overlap another bead over a length of more than its width. A
  /// joint between two pieces is compared with all other pieces, a joint between the ends of the
  /// same piece also with this piece.
  bool LiesOnOthers(Point from, Point to, int32_t piece, int32_t other) const {
    bool lies = false;
    lines_.ForEachNear(from, to, options_.width_nm, [&](int32_t number) {
      const Line& line = segments_[U(number)];
      if (piece != other && (line.piece == piece || line.piece == other)) return;
      lies = lies || LieTogether(from, to, line.a, line.b, options_.width_nm);
    });
    return lies;
  }

  /// Returns the point of a piece that is `distance_nm` before its end.
  Point Before(int32_t end, double distance_nm) const {
    const Polyline& points = PieceOf(end).points;
    const size_t count = points.size();
    const auto at = [&](size_t i) { return end % 2 == 0 ? points[i] : points[count - 1 - i]; };
    for (size_t i = 0; i + 1 < count; ++i) {
      const Point from = at(i), to = at(i + 1);
      const double length = Distance(from, to);
      if (distance_nm < length) {
        const double share = distance_nm / length;
        return {from.x + std::llround(share * static_cast<double>(to.x - from.x)),
                from.y + std::llround(share * static_cast<double>(to.y - from.y))};
      }
      distance_nm -= length;
    }
    return at(count - 1);
  }

  std::span<const Piece> pieces_;
  const InnerJoints& options_;
  EdgeIndex edges_;
  SegmentGrid lines_;
  std::vector<double> lengths_;  ///< length of each piece
  std::vector<Line> segments_;   ///< segments of all pieces
};

/// Choice of the possible joints that are made.
class Matching {
 public:
  Matching(const Ends& ends, const std::vector<Joint>& joints, const InnerJoints& options)
      : joints_(joints),
        width_nm_(options.width_nm),
        lines_(BoxOf(joints), std::max(options.reach_nm, options.width_nm)),
        made_(U(ends.size()), kNone),
        of_(U(ends.size())),
        chains_(ends.size() / 2) {
    for (size_t i = 0; i < joints.size(); ++i) {
      of_[U(joints[i].a)].push_back(static_cast<int32_t>(i));
      of_[U(joints[i].b)].push_back(static_cast<int32_t>(i));
    }
    for (const bool rings : {false, true})  // rings last: a path may still include them
      for (size_t i = 0; i < joints.size(); ++i)
        if (CanMake(joints[i], rings)) Make(static_cast<int32_t>(i));
    for (int32_t end = 0; end < ends.size(); ++end)
      if (made_[U(end)] == kNone) MakeRoomFor(end);
  }

  /// Returns the joint of an end, or null if there is none.
  const Joint* Of(int32_t end) const {
    return made_[U(end)] == kNone ? nullptr : &joints_[U(made_[U(end)])];
  }

 private:
  bool CanMake(const Joint& joint, bool may_close) {
    return made_[U(joint.a)] == kNone && made_[U(joint.b)] == kNone &&
           (may_close || !chains_.AreJoined(joint.a / 2, joint.b / 2)) && IsFree(joint);
  }

  static Box BoxOf(const std::vector<Joint>& joints) {
    Box box;
    for (const Joint& joint : joints) box.Add(joint.from), box.Add(joint.to);
    return box;
  }

  /// Returns true if the joint would overlap no joint that is already made.
  bool IsFree(const Joint& joint) const {
    bool is_free = true;
    lines_.ForEachNear(joint.from, joint.to, width_nm_, [&](int32_t number) {
      const Joint& other = joints_[U(number)];
      is_free = is_free && !LieTogether(joint.from, joint.to, other.from, other.to, width_nm_);
    });
    return is_free;
  }

  /// Returns true if both joints can be made: they overlap neither an existing joint nor each
  /// other.
  bool AreFree(const Joint& one, const Joint& other) const {
    return IsFree(one) && IsFree(other) &&
           !LieTogether(one.from, one.to, other.from, other.to, width_nm_);
  }

  void Make(int32_t number) {
    const Joint& joint = joints_[U(number)];
    made_[U(joint.a)] = made_[U(joint.b)] = number;
    chains_.Join(joint.a / 2, joint.b / 2);
    lines_.Add(joint.from, joint.to, number);
  }

  /// Makes a joint for a loose end: the end takes over the partner of another end, if that other
  /// end can be joined to a further end.
  void MakeRoomFor(int32_t end) {
    for (const int32_t wanted : of_[U(end)]) {
      const int32_t partner = joints_[U(wanted)].Other(end);
      if (made_[U(partner)] == kNone) continue;  // the joint would overlap another
      const int32_t left = joints_[U(made_[U(partner)])].Other(partner);
      for (const int32_t other : of_[U(left)]) {
        const int32_t last = joints_[U(other)].Other(left);
        if (made_[U(last)] != kNone || last == end) continue;
        if (!AreFree(joints_[U(wanted)], joints_[U(other)])) continue;
        Make(wanted);
        Make(other);
        return;
      }
    }
  }

  const std::vector<Joint>& joints_;
  double width_nm_;
  SegmentGrid lines_;                     ///< joints that are made
  std::vector<int32_t> made_;             ///< joint made at each end, or kNone
  std::vector<std::vector<int32_t>> of_;  ///< possible joints of each end
  DisjointSets chains_;                   ///< sets of joined pieces
};

/// Assembly of the joined pieces.
class Chains {
 public:
  Chains(const Ends& ends, const Matching& matching)
      : ends_(ends), matching_(matching), done_(U(ends.size() / 2), false) {}

  std::vector<Piece> Run() {
    std::vector<Piece> chains;
    for (const bool rings : {false, true})
      for (int32_t end = 0; end < ends_.size(); ++end)
        if (!done_[U(end / 2)] && (rings || matching_.Of(end) == nullptr))
          chains.push_back(ends_.PieceOf(end).closed ? Keep(end) : Follow(end));
    return chains;
  }

 private:
  Piece Keep(int32_t end) {
    done_[U(end / 2)] = true;
    return ends_.PieceOf(end);
  }

  double CutAt(int32_t end) const {
    const Joint* joint = matching_.Of(end);
    return joint == nullptr ? 0 : joint->cut_nm;
  }

  /// Returns the chain of pieces that begins at an end.
  Piece Follow(int32_t first) {
    Piece chain;
    chain.from = ends_.PositionOf(first);
    int32_t end = first;
    while (end != kNone && !done_[U(end / 2)]) {
      done_[U(end / 2)] = true;
      Polyline run = Shortened(ends_.PieceOf(end).points, ends_.LengthOf(end), CutAt(end & ~1),
                               CutAt(end | 1));
      if (end % 2 != 0) std::ranges::reverse(run);
      for (const Point p : run)
        if (chain.points.empty() || chain.points.back() != p) chain.points.push_back(p);
      const int32_t out = end ^ 1;
      chain.to = ends_.PositionOf(out);
      const Joint* joint = matching_.Of(out);
      end = joint == nullptr ? kNone : joint->Other(out);
    }
    chain.closed = end != kNone;
    if (chain.closed && chain.points.front() == chain.points.back()) chain.points.pop_back();
    return chain;
  }

  const Ends& ends_;
  const Matching& matching_;
  std::vector<bool> done_;  ///< true for pieces already in a chain, indexed by piece
};

}  // namespace

std::vector<Piece> JoinInnerEnds(const MultiPolygon& region, std::span<const Piece> pieces,
                                 const InnerJoints& joints) {
  if (pieces.empty()) return {};
  const Ends ends(region, pieces, joints);
  const std::vector<Joint> possible = ends.Joints();
  if (possible.empty()) return {pieces.begin(), pieces.end()};
  return Chains(ends, Matching(ends, possible, joints)).Run();
}

}  // namespace slicefarm::infill
