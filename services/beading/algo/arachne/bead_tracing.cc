#include "services/beading/algo/arachne/bead_tracing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/base/portable_math.h"

namespace slicefarm::beading {
namespace {

/// Distance before a node at which a line along the axis ends, as a fraction of its width. The line
/// ends in a half disc. At this distance, the half disc and the start of the next bead cover the
/// free area between them. The next bead is another line along the axis (Kuipers et al. 2020,
/// section 3.5), or two halves that begin side by side.
constexpr double kRetreatFromMiddle = 0.75;
constexpr double kRetreatFromHalves = 0.62;
/// Extension of a single bead into a flat end, as a fraction of its width. The half disc lacks the
/// corners of the end; this extension has their area: 1/2 - pi/8.
constexpr double kReachIntoEnd = 0.107;
constexpr double kLeastLengthNm = 50'000;
/// Length of the line for a dot, as a fraction of the bead's width.
constexpr double kDotLength = 0.2;

Vector2 Lerp(const Vector2& a, const Vector2& b, double t) { return a + t * (b - a); }

/// Tracer of the beads of one inset beside the axis.
class SideTracer {
 public:
  SideTracer(const SkeletalGraph& graph, const std::vector<NodeBeading>& beadings, int inset)
      : graph_(graph), beadings_(beadings), inset_(inset), visited_(graph.half_edges.size()) {}

  void Trace(std::vector<BeadLine>& lines) {
    for (int half = 0; half < static_cast<int>(graph_.half_edges.size()); ++half) {
      if (visited_[half] || !(HasBead(From(half)) || HasBead(To(half)))) continue;
      BeadLine line = TraceFrom(half);
      if (line.points.size() > 1) lines.push_back(std::move(line));
    }
  }

 private:
  int From(int half) const { return graph_.half_edges[half].from; }
  int To(int half) const { return graph_.To(half); }

  const SideBead* BeadAt(int node) const {
    const auto& sides = beadings_[node].sides;
    return inset_ < static_cast<int>(sides.size()) ? &sides[inset_] : nullptr;
  }
  bool HasBead(int node) const {
    const SideBead* bead = BeadAt(node);
    return bead != nullptr && bead->location <= graph_.nodes[node].radius;
  }

  /// Returns the next half-edge of a line. It is the next one along the ring or, where the bead
  /// ends, the opposite half-edge, which leads back on the other side of the axis.
  int After(int half) const { return HasBead(To(half)) ? graph_.half_edges[half].next : half ^ 1; }

  BeadLine TraceFrom(int start) {
    BeadLine line;
    line.inset = inset_;
    line.closed = true;
    line.is_marker = true;
    int half = start;
    do {
      visited_[half] = true;
      if (HasBead(From(half))) Add(RibPoint(half), line);
      if (HasBead(From(half)) != HasBead(To(half))) Add(Tip(half), line);
      half = After(half);
    } while (half != start);
    while (line.points.size() > 1 && Same(line.points.front(), line.points.back()))
      line.points.pop_back();
    return line;
  }

  static bool Same(const BeadPoint& a, const BeadPoint& b) {
    return std::abs(a.place.x() - b.place.x()) < 0.5 && std::abs(a.place.y() - b.place.y()) < 0.5;
  }

  static void Add(const BeadPoint& point, BeadLine& line) {
    if (point.width > 0) line.is_marker = false;
    std::vector<BeadPoint>& points = line.points;
    if (!points.empty() && Same(points.back(), point)) return;
    const size_t count = points.size();
    if (count > 1 && IsBetween(points[count - 1], points[count - 2], point)) points.pop_back();
    points.push_back(point);
  }

  /// Returns true if a straight line from `a` to `b`, with linearly changing width, passes through
  /// `p`. This holds for most nodes along straight sides.
  static bool IsBetween(const BeadPoint& p, const BeadPoint& a, const BeadPoint& b) {
    constexpr double kNothingNm = 50;
    const double bx = b.place.x() - a.place.x(), by = b.place.y() - a.place.y();
    const double px = p.place.x() - a.place.x(), py = p.place.y() - a.place.y();
    const double squared = bx * bx + by * by, along = bx * px + by * py;
    const double across = bx * py - by * px;
    if (across * across > kNothingNm * kNothingNm * squared || along < 0 || along > squared)
      return false;
    return std::abs(std::lerp(a.width, b.width, along / squared) - p.width) <= kNothingNm;
  }

  BeadPoint RibPoint(int half) const {
    const SkeletalNode& node = graph_.FromNode(half);
    const SideBead& bead = *BeadAt(From(half));
    const Vector2 foot = graph_.Foot(half, node);
    const double t = node.radius > 0 ? bead.location / node.radius : 0;
    return {Lerp(foot, node.place, t), bead.width};
  }

  /// Returns the point at which a bead crosses to the other side of the axis, on an edge where only
  /// one end has the bead.
  BeadPoint Tip(int half) const {
    const int with = HasBead(From(half)) ? From(half) : To(half);
    const int without = with == From(half) ? To(half) : From(half);
    const NodeBeading& there = beadings_[without];
    return there.has_middle && static_cast<int>(there.sides.size()) == inset_
               ? HalfOfMiddle(half, without)
               : AxisPoint(with, without);
  }

  /// Returns the first point of a bead that starts as one half of a bead along the axis.
  BeadPoint HalfOfMiddle(int half, int node) const {
    const SkeletalNode& at = graph_.nodes[node];
    const double width = beadings_[node].middle_width / 2;
    const double t = at.radius > 0 ? (at.radius - width / 2) / at.radius : 0;
    return {Lerp(graph_.Foot(half, at), at.place, t), width};
  }

  /// Returns the point on the axis where the bead's distance from the boundary equals the radius.
  BeadPoint AxisPoint(int with, int without) const {
    const double room_with = graph_.nodes[with].radius - BeadAt(with)->location;
    const SideBead* other = BeadAt(without);
    const double radius = graph_.nodes[without].radius;
    const double location =
        other != nullptr ? other->location : std::max(BeadAt(with)->location, radius);
    const double lack = location - radius;
    const double t = room_with + lack > 0 ? room_with / (room_with + lack) : 1;
    const double width =
        std::lerp(BeadAt(with)->width, other != nullptr ? other->width : BeadAt(with)->width, t);
    return {Lerp(graph_.nodes[with].place, graph_.nodes[without].place, t), width};
  }

  const SkeletalGraph& graph_;
  const std::vector<NodeBeading>& beadings_;
  const int inset_;
  std::vector<char> visited_;
};

/// Tracer of the beads along the axis.
class MiddleTracer {
 public:
  MiddleTracer(const SkeletalGraph& graph, const std::vector<char>& central,
               const std::vector<NodeBeading>& beadings, const TracingOptions& options)
      : graph_(graph),
        beadings_(beadings),
        options_(options),
        leaving_(graph.Leaving()),
        open_(central.size()),
        mate_(graph.half_edges.size(), -1) {
    for (size_t edge = 0; edge < central.size(); ++edge)
      open_[edge] = central[edge] && HasMiddle(static_cast<int>(2 * edge));
    has_middle_ = open_;
  }

  void Trace(std::vector<BeadLine>& lines) {
    for (int node = 0; node < static_cast<int>(graph_.nodes.size()); ++node) Pair(node);
    for (int pass = 0; pass < 2; ++pass)  // open lines from their ends first, then rings
      for (int half = 0; half < static_cast<int>(graph_.half_edges.size()); ++half)
        if (open_[half / 2] && (pass == 1 || mate_[half ^ 1] < 0)) Follow(half, lines);
    for (int node = 0; node < static_cast<int>(graph_.nodes.size()); ++node) AddDot(node, lines);
  }

 private:
  double Width(int node) const {
    return beadings_[node].has_middle ? beadings_[node].middle_width : 0;
  }
  /// Returns true if the edge has a middle bead. At one end, this bead may have width 0, but may
  /// not be split into two halves.
  bool HasMiddle(int half) const {
    const int a = graph_.half_edges[half].from, b = graph_.To(half);
    return beadings_[a].sides.size() == beadings_[b].sides.size() &&
           std::max(Width(a), Width(b)) > options_.min_middle_width_nm;
  }

  /// Adds the middle bead of a node with locally largest radius, if no line leads on from it.
  void AddDot(int node, std::vector<BeadLine>& lines) const {
    const double width = Width(node);
    if (width < options_.min_middle_width_nm) return;
    bool alone = true;
    int flattest = -1;
    double least = std::numeric_limits<double>::infinity();
    graph_.ForEachLeaving(leaving_[node], [&](int half) {
      const double fall = graph_.nodes[node].radius - graph_.ToNode(half).radius;
      alone = alone && !has_middle_[half / 2] && fall >= 0;
      const double slope = fall / std::max(1.0, graph_.Length(half));
      if (slope >= least) return;
      least = slope;
      flattest = half;
    });
    if (!alone || flattest < 0 || graph_.Length(flattest) == 0) return;
    const Vector2 at = graph_.nodes[node].place, to = graph_.ToNode(flattest).place;
    const double t = kDotLength / 2 * width / graph_.Length(flattest);
    BeadLine dot;
    dot.inset = InsetAt(node);
    dot.is_middle = true;
    dot.points = {{Lerp(at, to, -t), width}, {Lerp(at, to, t), width}};
    lines.push_back(std::move(dot));
  }

  /// Connects lines at a node: first the two lines with the smallest bend, then the next two.
  void Pair(int node) {
    std::vector<int> around;
    graph_.ForEachLeaving(leaving_[node], [&](int half) {
      if (open_[half / 2]) around.push_back(half);
    });
    std::sort(around.begin(), around.end());
    while (around.size() >= 2) {
      double straightest = 2;
      size_t a = 0, b = 1;
      for (size_t i = 0; i < around.size(); ++i) {
        for (size_t j = i + 1; j < around.size(); ++j) {
          const double bend = Cosine(around[i], around[j]);
          if (bend >= straightest) continue;
          straightest = bend;
          a = i;
          b = j;
        }
      }
      // mate_[x] is the half-edge that continues from the end of x.
      mate_[around[a] ^ 1] = around[b];
      mate_[around[b] ^ 1] = around[a];
      around.erase(around.begin() + static_cast<std::ptrdiff_t>(b));
      around.erase(around.begin() + static_cast<std::ptrdiff_t>(a));
    }
  }

  double Cosine(int a, int b) const {
    const Vector2 at = graph_.FromNode(a).place, p = graph_.ToNode(a).place,
                  q = graph_.ToNode(b).place;
    const double lengths = graph_.Length(a) * graph_.Length(b);
    return lengths > 0
               ? ((p.x() - at.x()) * (q.x() - at.x()) + (p.y() - at.y()) * (q.y() - at.y())) /
                     lengths
               : 1;
  }

  void Follow(int start, std::vector<BeadLine>& lines) {
    BeadLine line;
    line.is_middle = true;
    int half = start;
    const int first = graph_.half_edges[half].from;
    int last = first;
    line.points.push_back(PointAt(first));
    int inset = InsetAt(graph_.half_edges[half].from);
    while (half >= 0 && open_[half / 2]) {
      open_[half / 2] = false;
      last = graph_.To(half);
      line.points.push_back(PointAt(last));
      inset = std::max(inset, InsetAt(last));
      half = mate_[half];
    }
    line.inset = inset;
    line.closed = half == start;
    if (line.closed) {
      line.points.pop_back();
    } else {
      const double at_start = RetreatAt(first), at_end = RetreatAt(last);
      Retreat(line, at_start, at_end);
      if (line.points.empty()) return;
      if (at_start <= 0 && at_end <= 0) LengthenToDot(line.points);
    }
    Cut(std::move(line), lines);
  }

  /// Returns the distance in nm before its last node at which a line must end, to cover exactly the
  /// free area there; negative if the line must be extended.
  double RetreatAt(int node) const {
    bool meets_middle = false, meets_halves = false;
    int ends = 0;
    graph_.ForEachLeaving(leaving_[node], [&](int half) {
      const int to = graph_.To(half);
      ends += has_middle_[half / 2];
      meets_halves = meets_halves || beadings_[to].sides.size() > beadings_[node].sides.size();
    });
    meets_middle = ends > 1;
    if (meets_halves) return kRetreatFromHalves * Width(node);
    if (meets_middle) return kRetreatFromMiddle * Width(node);
    return beadings_[node].sides.empty() ? -kReachIntoEnd * Width(node) : 0;
  }

  static void Retreat(BeadLine& line, double at_start, double at_end) {
    double length = 0;
    for (size_t i = 1; i < line.points.size(); ++i)
      length += Distance(line.points[i - 1], line.points[i]);
    const double sum = std::max(0.0, at_start) + std::max(0.0, at_end);
    if (length == 0 || length < sum / 2) {
      line.points.clear();
      return;
    }
    const double scale = sum > 0 ? std::clamp((length - kLeastLengthNm) / sum, 0.0, 1.0) : 1;
    for (const double by : {at_start, at_end}) {
      if (by > 0) CutStart(line.points, by * scale);
      if (by < 0) ExtendStart(line.points, -by);
      std::reverse(line.points.begin(), line.points.end());
    }
  }

  static double Distance(const BeadPoint& a, const BeadPoint& b) {
    return Hypot(b.place.x() - a.place.x(), b.place.y() - a.place.y());
  }

  /// Extends a line that is shorter than a dot, because it would cover less than a dot.
  static void LengthenToDot(std::vector<BeadPoint>& points) {
    double length = 0;
    for (size_t i = 1; i < points.size(); ++i) length += Distance(points[i - 1], points[i]);
    const double lack = kDotLength * points.front().width - length;
    if (lack <= 0 || Distance(points.front(), points.back()) < 1) return;
    points = {points.front(), points.back()};
    for (int end = 0; end < 2; ++end) {
      ExtendStart(points, lack / 2);
      std::reverse(points.begin(), points.end());
    }
  }

  static void ExtendStart(std::vector<BeadPoint>& points, double by) {
    const BeadPoint &start = points[0], &next = points[1];
    const double length = Distance(start, next);
    if (length == 0) return;
    points.insert(points.begin(), {Lerp(start.place, next.place, -by / length), start.width});
  }

  static void CutStart(std::vector<BeadPoint>& points, double by) {
    size_t i = 0;
    while (i + 2 < points.size() && Distance(points[i], points[i + 1]) <= by)
      by -= Distance(points[i], points[i + 1]), ++i;
    const double length = Distance(points[i], points[i + 1]);
    const double t = length > 0 ? std::clamp(by / length, 0.0, 1.0) : 0;
    points[i] = {Lerp(points[i].place, points[i + 1].place, t),
                 std::lerp(points[i].width, points[i + 1].width, t)};
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(i));
  }

  BeadPoint PointAt(int node) const { return {graph_.nodes[node].place, Width(node)}; }
  int InsetAt(int node) const { return static_cast<int>(beadings_[node].sides.size()); }

  /// Adds the parts of the line that are not narrower than the smallest width.
  void Cut(BeadLine line, std::vector<BeadLine>& lines) const {
    const double least = options_.min_middle_width_nm;
    if (std::ranges::all_of(line.points, [&](const BeadPoint& p) { return p.width >= least; })) {
      lines.push_back(std::move(line));
      return;
    }
    if (line.closed) {
      const auto narrow =
          std::ranges::find_if(line.points, [&](const BeadPoint& p) { return p.width < least; });
      std::rotate(line.points.begin(), narrow, line.points.end());
      line.points.push_back(line.points.front());
      line.closed = false;
    }
    BeadLine piece;
    piece.inset = line.inset;
    piece.is_middle = true;
    for (size_t i = 0; i < line.points.size(); ++i) {
      const BeadPoint& at = line.points[i];
      if (i > 0 && (line.points[i - 1].width < least) != (at.width < least)) {
        const BeadPoint& before = line.points[i - 1];
        const double t = (least - before.width) / (at.width - before.width);
        piece.points.push_back({Lerp(before.place, at.place, t), least});
      }
      if (at.width >= least) piece.points.push_back(at);
      if ((at.width < least || i + 1 == line.points.size()) && !piece.points.empty()) {
        if (piece.points.size() > 1) lines.push_back(piece);
        piece.points.clear();
      }
    }
  }

  const SkeletalGraph& graph_;
  const std::vector<NodeBeading>& beadings_;
  const TracingOptions& options_;
  const std::vector<int> leaving_;
  std::vector<char> open_;        ///< 1 for each edge with a bead that is not part of a line yet
  std::vector<char> has_middle_;  ///< 1 for each edge with a middle bead
  std::vector<int> mate_;         ///< half-edge that continues the line of each half-edge
};

}  // namespace

std::vector<BeadLine> TraceBeads(const SkeletalGraph& graph, const std::vector<char>& central,
                                 const std::vector<NodeBeading>& beadings,
                                 const TracingOptions& options) {
  std::vector<BeadLine> lines;
  size_t insets = 0;
  for (const NodeBeading& beading : beadings) insets = std::max(insets, beading.sides.size());
  for (size_t inset = 0; inset < insets; ++inset)
    SideTracer(graph, beadings, static_cast<int>(inset)).Trace(lines);
  MiddleTracer(graph, central, beadings, options).Trace(lines);
  return lines;
}

}  // namespace slicefarm::beading
