#include "services/planning/algo/supports/generator/branches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "common/base/portable_math.h"
#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/tips.h"

namespace slicefarm::planning {
namespace {

/// Distance beyond which branches ignore each other.
constexpr Coord kSightNm = 20'000'000;
/// Largest number of neighbours with which a branch may become a pair.
constexpr size_t kNeighbours = 8;
/// Height above the bed below which merging branches saves no plastic.
constexpr Coord kLowestMeetingNm = 600'000;
constexpr double kTipGrowthRad = 6 * std::numbers::pi / 180;
/// Share of diameter_angle_rad by which branches widen. The whole angle would take more plastic
/// than PrusaSlicer's trees, which have fewer trunks.
constexpr double kShareOfAngle = 0.75;
/// Distance that a support may extend beyond the support below it.
constexpr Coord kBeyondNm = 850'000;
/// Free radius that a branch needs while it moves towards another branch, as a share of its radius.
constexpr double kClearanceShare = 0.45;

/// Branch that grows down from one tip, or from several tips that have met.
struct Branch {
  int32_t node = 0;
  Point at;
  Coord z_nm = 0;
  Coord length_nm = 0;  ///< length from its highest tip
  Coord radius_nm = 0;
  bool found = false;  ///< true if the field has a path down from here
};

/// Returns the free radius that a branch needs at a height on its path to the bed. It makes the
/// branch move away from the part early enough to have a foot.
Coord FootClearance(Coord z_nm) {
  constexpr double kSlope = 0.8;
  return kFootRadiusNm - std::llround(z_nm * kSlope);
}

/// Returns the radius of the area that a tip supports: branch_distance beyond the tip's edge. The
/// radius is smaller if the setting requests more contact area than usual.
Coord TipReach(const TreeOptions& tree) {
  constexpr double kUsualRate = 0.15;
  const double radius = tree.tip_diameter_nm / 2.0;
  const double rate = std::clamp(tree.top_rate, 0.01, 1.0);
  const double beyond = tree.branch_distance_nm * std::sqrt(std::min(1.0, kUsualRate / rate));
  return std::llround(radius + std::min<double>(kBeyondNm, beyond));
}

class Grower {
 public:
  Grower(const ReachField& field, const SupportHeights& heights, const SupportOptions& options)
      : field_(field),
        heights_(heights),
        options_(options),
        slow_(Tan(options.tree.slow_angle_rad)),
        fast_(std::max(slow_, Tan(options.tree.angle_rad))),
        tips_(field.grid(), TipReach(options.tree)) {}

  absl::StatusOr<Branches> Run(const std::vector<std::vector<int32_t>>& undersides,
                               const CancelToken& cancel) {
    for (size_t slab = field_.slabs().size(); slab-- > 0;) {
      if (cancel.Cancelled()) return cancel.Check();
      AddTips(slab, undersides);
      if (slab > 0) StepBelow(slab - 1);
    }
    for (const Branch& branch : live_)
      if (branch.found || !EndsOver(0, branch)) End(branch, 0, true);
    DropLost();
    return std::move(result_);
  }

 private:
  Coord TipRadius() const { return options_.tree.tip_diameter_nm / 2; }

  Coord RadiusAt(Coord length_nm) const {
    const Coord tip = TipRadius();
    const Coord full = std::max(tip, options_.tree.branch_diameter_nm / 2);
    const double widens = Tan(options_.tree.diameter_angle_rad) * kShareOfAngle;
    const double grown = tip + length_nm * std::max(widens, Tan(kTipGrowthRad));
    return std::llround(std::min<double>(grown, full + length_nm * widens));
  }

  void AddTips(size_t slab, const std::vector<std::vector<int32_t>>& undersides) {
    const Slab& s = field_.slabs()[slab];
    for (int32_t layer = s.last_layer; layer >= s.first_layer; --layer) {
      const auto& underside = undersides[static_cast<size_t>(layer)];
      if (underside.empty()) continue;
      tips_.Begin(underside);
      for (const Branch& branch : live_) tips_.Cover(branch.at, branch.radius_nm + kBeyondNm);
      const Coord z = heights_.layers[static_cast<size_t>(layer)].bottom_nm;
      for (const Point tip : tips_.Place()) {
        live_.push_back({AddNode(tip, z, TipRadius()), tip, z, 0, TipRadius(), false});
        live_.back().found = Reach(slab, tip, true) >= TipRadius();
      }
    }
  }

  int32_t AddNode(Point at, Coord z_nm, Coord radius_nm) {
    result_.nodes.push_back({at, z_nm, radius_nm, -1, 0, true});
    return static_cast<int32_t>(result_.nodes.size()) - 1;
  }

  /// Ends a branch straight down at `foot_nm`, without further nodes.
  void End(const Branch& branch, Coord foot_nm, bool on_bed) {
    BranchNode& node = result_.nodes[static_cast<size_t>(branch.node)];
    node.foot_nm = foot_nm;
    node.on_bed = on_bed;
  }

  Coord Reach(size_t slab, Point p, bool anywhere) const {
    return anywhere ? field_.ToAnywhere(slab, p) : field_.ToBed(slab, p);
  }

  /// Calls visit(p) for the pixels that a branch at `from` can reach in `slab`.
  template <typename Visit>
  void ForEachStep(size_t slab, Point from, Visit visit) const {
    const int32_t squared = field_.slabs()[slab].step_squared;
    const auto reach = static_cast<int32_t>(std::sqrt(squared));
    const PixelGrid& grid = field_.grid();
    const int32_t x0 = grid.Column(from.x), y0 = grid.Row(from.y);
    for (int32_t y = std::max(0, y0 - reach); y <= std::min(grid.height - 1, y0 + reach); ++y)
      for (int32_t x = std::max(0, x0 - reach); x <= std::min(grid.width - 1, x0 + reach); ++x)
        if ((x - x0) * (x - x0) + (y - y0) * (y - y0) <= squared) visit(grid.Centre(x, y));
  }

  /// Returns the point nearest to `wish` that is within one step of all points in `from` and where
  /// a branch with `radius_nm` fits. If there is none, returns the point where the thickest branch
  /// fits; nullopt if not even a tip fits.
  std::optional<Point> Nearest(size_t slab, std::span<const Point> from, Point wish,
                               Coord radius_nm, bool anywhere) const {
    const bool in_reach =
        std::all_of(from.begin(), from.end(), [&](Point p) { return Within(slab, p, wish); });
    if (in_reach && Reach(slab, wish, anywhere) >= radius_nm) return wish;
    std::optional<Point> best;
    std::pair<Coord, double> most{0, 0};  // usable radius, negative squared distance
    ForEachStep(slab, from[0], [&](Point p) {
      const Coord room = std::min(Reach(slab, p, anywhere), radius_nm);
      if (room < TipRadius()) return;
      const std::pair<Coord, double> worth{room, -SquaredNorm(p - wish)};
      if (best && worth <= most) return;
      for (const Point other : from)
        if (!Within(slab, other, p)) return;
      best = p;
      most = worth;
    });
    return best;
  }

  bool Within(size_t slab, Point from, Point to) const {
    const PixelGrid& grid = field_.grid();
    const int32_t dx = grid.Column(from.x) - grid.Column(to.x);
    const int32_t dy = grid.Row(from.y) - grid.Row(to.y);
    return dx * dx + dy * dy <= field_.slabs()[slab].step_squared;
  }

  /// Moves all branches down to the slab. Partners that can reach one point are merged.
  void StepBelow(size_t slab) {
    std::vector<Branch> next;
    const Coord z = field_.slabs()[slab].middle_nm();
    const std::vector<Goal> goals = Goals(slab, z);
    const double meets = 2 * std::sqrt(field_.slabs()[slab].step_squared) *
                         static_cast<double>(field_.grid().pixel_nm);
    std::vector<uint8_t> done(live_.size(), 0);
    for (size_t i = 0; i < live_.size(); ++i) {
      const size_t k = goals[i].partner;
      if (k == kNone || k < i || Distance(live_[i].at, live_[k].at) > meets) continue;
      if (std::optional<Branch> one = Meet(slab, live_[i], live_[k], z)) {
        done[i] = done[k] = 1;
        next.push_back(*one);
      }
    }
    for (size_t i = 0; i < live_.size(); ++i) {
      if (done[i]) continue;
      if (std::optional<Branch> moved = Move(slab, live_[i], goals[i].at, z))
        next.push_back(*moved);
    }
    live_ = std::move(next);
  }

  static constexpr size_t kNone = std::numeric_limits<size_t>::max();

  /// Target of a branch.
  struct Goal {
    Point at;
    size_t partner = kNone;  ///< branch that moves to the same target
  };

  struct Pair {
    double distance_nm = 0;
    size_t a = 0;
    size_t b = 0;

    friend auto operator<=>(const Pair&, const Pair&) = default;
  };

  /// Pairs the nearest branches first. Partners meet in the middle. A branch without a free
  /// neighbour moves to the target of its nearest neighbour.
  std::vector<Goal> Goals(size_t slab, Coord z_nm) const {
    std::vector<Goal> goals(live_.size());
    for (size_t i = 0; i < live_.size(); ++i) goals[i].at = live_[i].at;
    const std::vector<Pair> pairs = PairsNearby(z_nm);
    for (const auto& [distance, a, b] : pairs) {
      if (goals[a].partner != kNone || goals[b].partner != kNone) continue;
      if (!InSight(slab, live_[a].at, live_[b].at, distance)) continue;
      goals[a] = {Middle(live_[a], live_[b]), b};
      goals[b] = {goals[a].at, a};
    }
    std::vector<uint8_t> follows(live_.size(), 0);
    for (const auto& [distance, a, b] : pairs) {
      for (const auto& [one, other] : {std::pair(a, b), std::pair(b, a)}) {
        if (goals[one].partner != kNone || follows[one] || goals[other].partner == kNone) continue;
        if (!InSight(slab, live_[one].at, live_[other].at, distance)) continue;
        goals[one].at = goals[other].at;
        follows[one] = 1;
      }
    }
    return goals;
  }

  static Point Middle(const Branch& a, const Branch& b) {
    return {a.at.x + (b.at.x - a.at.x) / 2, a.at.y + (b.at.y - a.at.y) / 2};
  }

  /// Returns the pairs of branches that are near enough to meet, the nearest first.
  std::vector<Pair> PairsNearby(Coord z_nm) const {
    const BucketMap buckets = Buckets();
    const double farthest = std::min<double>(kSightNm, 2 * fast_ * (z_nm - kLowestMeetingNm));
    std::vector<Pair> pairs, own;
    for (size_t i = 0; i < live_.size(); ++i) {
      if (!live_[i].found) continue;
      own.clear();
      ForEachNear(buckets, live_[i].at, [&](size_t k) {
        const double distance = Distance(live_[i].at, live_[k].at);
        if (k != i && distance <= farthest)
          own.push_back({distance, std::min(i, k), std::max(i, k)});
      });
      const size_t count = std::min(own.size(), kNeighbours);
      std::partial_sort(own.begin(), own.begin() + static_cast<ptrdiff_t>(count), own.end());
      pairs.insert(pairs.end(), own.begin(), own.begin() + static_cast<ptrdiff_t>(count));
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  using BucketMap = std::map<std::pair<Coord, Coord>, std::vector<size_t>>;

  BucketMap Buckets() const {
    BucketMap buckets;
    for (size_t i = 0; i < live_.size(); ++i)
      if (live_[i].found) buckets[BucketOf(live_[i].at)].push_back(i);
    return buckets;
  }

  static std::pair<Coord, Coord> BucketOf(Point p) {
    const auto of = [](Coord x) { return (x - (x < 0 ? kSightNm - 1 : 0)) / kSightNm; };
    return {of(p.x), of(p.y)};
  }

  template <typename Visit>
  void ForEachNear(const BucketMap& buckets, Point p, Visit visit) const {
    const auto [column, row] = BucketOf(p);
    for (Coord y = row - 1; y <= row + 1; ++y)
      for (Coord x = column - 1; x <= column + 1; ++x)
        if (const auto bucket = buckets.find({x, y}); bucket != buckets.end())
          for (const size_t i : bucket->second) visit(i);
  }

  std::optional<Branch> Meet(size_t slab, const Branch& a, const Branch& b, Coord z_nm) {
    Branch one;
    one.z_nm = z_nm;
    one.length_nm = std::max(a.length_nm + a.z_nm, b.length_nm + b.z_nm) - z_nm;
    one.radius_nm = std::max({RadiusAt(one.length_nm), a.radius_nm, b.radius_nm});
    const double weight_a = static_cast<double>(a.radius_nm) * a.radius_nm;
    const double weight_b = static_cast<double>(b.radius_nm) * b.radius_nm;
    const double part = weight_b / (weight_a + weight_b);
    const Point middle = {a.at.x + std::llround((b.at.x - a.at.x) * part),
                          a.at.y + std::llround((b.at.y - a.at.y) * part)};
    const Point from[] = {a.at, b.at};
    const bool anywhere = field_.ToBed(slab, middle) < TipRadius();
    const std::optional<Point> at = Nearest(slab, from, middle, one.radius_nm, anywhere);
    if (!at) return std::nullopt;
    one.at = *at;
    one.found = true;
    one.radius_nm = ClearRadius(slab, one.at, one.radius_nm, anywhere);
    one.node = AddNode(one.at, z_nm, one.radius_nm);
    result_.nodes[static_cast<size_t>(a.node)].below = one.node;
    result_.nodes[static_cast<size_t>(b.node)].below = one.node;
    return one;
  }

  Coord ClearRadius(size_t slab, Point at, Coord radius_nm, bool anywhere) const {
    return std::max(TipRadius(), std::min(radius_nm, Reach(slab, at, anywhere)));
  }

  /// Returns the next point on the path to the target. The step has the largest allowed lean while
  /// the branch is thin, or if the branch would arrive too late otherwise.
  Point Towards(Point goal, const Branch& branch, Coord z_nm) const {
    const double path = Distance(branch.at, goal);
    if (path == 0) return goal;
    const bool hurry = z_nm - path / slow_ < kLowestMeetingNm;
    const bool thin = 2 * branch.radius_nm < options_.tree.branch_diameter_nm;
    const double step = (branch.z_nm - z_nm) * (hurry || thin ? fast_ : slow_);
    const double share = std::min(1.0, step / path);
    return {branch.at.x + std::llround((goal.x - branch.at.x) * share),
            branch.at.y + std::llround((goal.y - branch.at.y) * share)};
  }

  bool InSight(size_t slab, Point a, Point b, double distance) const {
    const int points = static_cast<int>(distance / (2.0 * field_.grid().pixel_nm));
    for (int i = 1; i < points; ++i) {
      const Point p = {a.x + (b.x - a.x) * i / points, a.y + (b.y - a.y) * i / points};
      if (field_.ToAnywhere(slab, p) < TipRadius()) return false;
    }
    return true;
  }

  std::optional<Branch> Move(size_t slab, const Branch& branch, Point goal, Coord z_nm) {
    Branch moved = branch;
    moved.z_nm = z_nm;
    moved.length_nm += branch.z_nm - z_nm;
    const Coord radius = RadiusAt(moved.length_nm);
    const bool goes = branch.found && goal != branch.at;
    const Point wish = goes ? Towards(goal, branch, z_nm) : branch.at;
    const Coord wanted = goes ? std::max<Coord>(TipRadius(), std::llround(radius * kClearanceShare))
                              : std::max(radius, FootClearance(z_nm));
    const Point from[] = {branch.at};
    for (const bool anywhere : {false, true}) {
      const std::optional<Point> at = Nearest(slab, from, wish, wanted, anywhere);
      if (!at) continue;
      moved.at = *at;
      moved.found = true;
      moved.radius_nm = ClearRadius(slab, *at, radius, anywhere);
      return Joined(branch, moved);
    }
    if (EndsOver(slab, branch)) return std::nullopt;
    moved.at = branch.at;
    moved.radius_nm = TipRadius();
    return Joined(branch, moved);
  }

  /// Ends a branch on the surface right below it, if the field has no path for it. Returns false if
  /// there is no such surface.
  bool EndsOver(size_t slab, const Branch& branch) {
    const bool on_other = field_.OnOther(slab, branch.at);
    if (!branch.found && !on_other && !field_.OnPart(slab, branch.at)) return false;
    if (on_other || options_.bed_only)
      lost_.push_back(branch.node);
    else
      End(branch, field_.slabs()[slab].bottom_nm, false);
    return true;
  }

  Branch Joined(const Branch& branch, Branch moved) {
    moved.node = AddNode(moved.at, moved.z_nm, moved.radius_nm);
    result_.nodes[static_cast<size_t>(branch.node)].below = moved.node;
    return moved;
  }

  /// Removes the lost nodes and all nodes above them.
  void DropLost() {
    if (lost_.empty()) return;
    std::vector<BranchNode>& nodes = result_.nodes;
    std::vector<uint8_t> drop(nodes.size(), 0), has_above(nodes.size(), 0);
    for (const int32_t i : lost_) drop[static_cast<size_t>(i)] = 1;
    std::vector<int32_t> number(nodes.size(), -1);
    for (size_t i = nodes.size(); i-- > 0;) {
      if (nodes[i].below < 0) continue;
      drop[i] |= drop[static_cast<size_t>(nodes[i].below)];
      has_above[static_cast<size_t>(nodes[i].below)] = 1;
    }
    std::vector<BranchNode> kept;
    for (size_t i = 0; i < nodes.size(); ++i) {
      if (drop[i]) {
        result_.lost += has_above[i] ? 0 : 1;
        continue;
      }
      number[i] = static_cast<int32_t>(kept.size());
      kept.push_back(nodes[i]);
    }
    for (BranchNode& node : kept)
      if (node.below >= 0) node.below = number[static_cast<size_t>(node.below)];
    nodes = std::move(kept);
  }

  const ReachField& field_;
  const SupportHeights& heights_;
  const SupportOptions& options_;
  const double slow_;
  const double fast_;
  TipFinder tips_;
  std::vector<Branch> live_;
  std::vector<int32_t> lost_;  ///< indices of nodes
  Branches result_;
};

}  // namespace

absl::StatusOr<Branches> GrowBranches(const ReachField& field, const SupportHeights& heights,
                                      const std::vector<std::vector<int32_t>>& undersides,
                                      const SupportOptions& options, const CancelToken& cancel) {
  return Grower(field, heights, options).Run(undersides, cancel);
}

}  // namespace slicefarm::planning
