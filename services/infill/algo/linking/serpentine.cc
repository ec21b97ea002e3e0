#include "services/infill/algo/linking/serpentine.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include "common/geometry/measure.h"
#include "services/infill/algo/lines/ring_path.h"

namespace slicefarm::infill {
namespace {

/// Number of pieces that are compared as start of the next path: the lowest ones. The nearest of
/// them is used.
constexpr int kChoices = 64;

/// Path along the boundary from one crossing to the next or the previous one.
struct Link {
  int32_t to = 0;
  bool forward = true;
};

/// Returns the rank of a link; the link with the highest rank is used. `rise`: number of lines up.
/// An upward link has the highest rank, a link to the same line the lowest.
int Rank(int32_t rise) { return rise == 0 ? -2 : rise; }

class Walker {
 public:
  Walker(const ScanLines& lines, const SerpentineOptions& options)
      : lines_(lines), options_(options), done_(lines.PieceCount(), false) {
    if (options.monotonic) CountSupports();
  }

  std::vector<SerpentinePath> Run() {
    std::vector<SerpentinePath> paths;
    while (const std::optional<int32_t> start = NextStart()) {
      SerpentinePath path = Walk(*start);
      at_ = path.points.back();
      if (Length(path.points) >= options_.min_length_nm) paths.push_back(std::move(path));
    }
    return paths;
  }

 private:
  const Crossing& At(int32_t place) const { return lines_.crossings[lines_.order[place]]; }
  Point PointAt(int32_t place) const { return lines_.PointOf(At(place)); }
  bool IsReady(int32_t piece) const {
    return !done_[piece] && (!options_.monotonic || waiting_for_[piece] == 0);
  }

  /// Calls visit(lower piece, upper piece) for all pieces on adjacent lines that are beside each
  /// other.
  template <typename Visit>
  void ForEachNeighbours(int32_t line, Visit visit) const {
    int32_t low = lines_.line_begin[line], high = lines_.line_begin[line + 1];
    const int32_t low_end = high, high_end = lines_.line_begin[line + 2];
    while (low < low_end && high < high_end) {
      if (LieBeside(low / 2, high / 2)) visit(low / 2, high / 2);
      (At(low + 1).u < At(high + 1).u ? low : high) += 2;
    }
  }

  void CountSupports() {
    waiting_for_.assign(lines_.PieceCount(), 0);
    for (int32_t line = 0; line + 1 < lines_.LineCount(); ++line)
      ForEachNeighbours(line, [&](int32_t, int32_t upper) { ++waiting_for_[upper]; });
    for (int32_t piece = 0; piece < lines_.PieceCount(); ++piece)
      ForEachSlantedLink(piece, [&](int32_t upper) { ++waiting_for_[upper]; });
    for (int32_t piece = 0; piece < lines_.PieceCount(); ++piece)
      if (waiting_for_[piece] == 0) ready_.insert(piece);
  }

  /// Calls visit(upper piece) for all links of a piece to pieces on the line above that are not
  /// beside the piece, for example in a slanted tip. Without these links the tip would begin
  /// separately.
  template <typename Visit>
  void ForEachSlantedLink(int32_t piece, Visit visit) const {
    for (const int32_t place : {2 * piece, 2 * piece + 1}) {
      const int32_t from = lines_.order[place];
      for (const Link link : LinksOf(from)) {
        const Crossing& to = lines_.crossings[link.to];
        const int32_t upper = to.place / 2;
        if (to.line != At(place).line + 1 || LieBeside(piece, upper)) continue;
        if (LinkLength(from, link) <= options_.max_link_nm) visit(upper);
      }
    }
  }

  bool LieBeside(int32_t a, int32_t b) const {
    return At(2 * a).u < At(2 * b + 1).u && At(2 * b).u < At(2 * a + 1).u;
  }

  void Release(int32_t upper) {
    if (--waiting_for_[upper] == 0) ready_.insert(upper);
  }

  /// Marks a piece as printed. Pieces above it may then be ready.
  void Finish(int32_t piece) {
    done_[piece] = true;
    if (!options_.monotonic) return;
    ready_.erase(piece);
    ForEachSlantedLink(piece, [&](int32_t upper) { Release(upper); });
    const int32_t line = At(2 * piece).line;
    if (line + 1 >= lines_.LineCount()) return;
    const double from = At(2 * piece).u, to = At(2 * piece + 1).u;
    const auto begin = lines_.order.begin() + lines_.line_begin[line + 1];
    const auto end = lines_.order.begin() + lines_.line_begin[line + 2];
    auto above = std::partition_point(
        begin, end, [&](int32_t crossing) { return lines_.crossings[crossing].u <= from; });
    auto place = static_cast<int32_t>(above - lines_.order.begin()) & ~1;
    for (; place < lines_.line_begin[line + 2] && At(place).u < to; place += 2) {
      if (At(place + 1).u > from) Release(place / 2);
    }
  }

  /// Returns the end of a piece at which the next path begins.
  std::optional<int32_t> NextStart() {
    if (!options_.monotonic) {
      while (next_ < lines_.PieceCount() && done_[next_]) ++next_;
      if (next_ == lines_.PieceCount()) return std::nullopt;
      return 2 * next_;
    }
    if (ready_.empty()) return std::nullopt;
    if (!at_) return 2 * *ready_.begin();
    double nearest = std::numeric_limits<double>::infinity();
    int32_t best = 0;
    int tried = 0;
    for (auto it = ready_.begin(); it != ready_.end() && tried < kChoices; ++it, ++tried) {
      for (const int32_t place : {2 * *it, 2 * *it + 1}) {
        const double distance = SquaredNorm(PointAt(place) - *at_);
        if (distance < nearest) nearest = distance, best = place;
      }
    }
    return best;
  }

  /// Returns the path that begins with a piece at `place`. It begins at the piece's other end if
  /// the path can only continue in that direction.
  SerpentinePath Walk(int32_t place) {
    SerpentinePath path;
    Finish(place / 2);
    if (!BestLink(lines_.order[place ^ 1]) && BestLink(lines_.order[place])) place ^= 1;
    while (true) {
      path.pieces.push_back(static_cast<int32_t>(path.points.size()));
      path.places.push_back(place);
      path.points.push_back(PointAt(place));
      path.points.push_back(PointAt(place ^ 1));
      const int32_t from = lines_.order[place ^ 1];
      const std::optional<Link> link = BestLink(from);
      if (!link) return path;
      AppendLink(from, *link, path.points);
      path.spans.push_back(link->forward ? from : link->to);
      place = lines_.crossings[link->to].place;
      Finish(place / 2);
    }
  }

  std::array<Link, 2> LinksOf(int32_t from) const {
    const Crossing& crossing = lines_.crossings[from];
    return {Link{crossing.next, true}, Link{crossing.previous, false}};
  }

  /// Returns the link to a piece that may be printed next: of the links with the highest Rank, the
  /// shortest.
  std::optional<Link> BestLink(int32_t from) const {
    std::optional<Link> best;
    int best_rank = 0;
    double best_length = 0;
    for (const Link link : LinksOf(from)) {
      const Crossing& to = lines_.crossings[link.to];
      const int32_t rise = to.line - lines_.crossings[from].line;
      if (!IsReady(to.place / 2) || (options_.monotonic && rise < 0)) continue;
      const double length = LinkLength(from, link);
      if (length > options_.max_link_nm) continue;
      const int rank = Rank(rise);
      if (best && (rank < best_rank || (rank == best_rank && length >= best_length))) continue;
      best = link, best_rank = rank, best_length = length;
    }
    return best;
  }

  /// Calls visit for the corners of the boundary that a link passes. A link never passes a whole
  /// ring, which meets each line twice.
  template <typename Visit>
  void ForEachLinkCorner(int32_t from, const Link& link, Visit visit) const {
    const Crossing& a = lines_.crossings[from];
    const Crossing& b = lines_.crossings[link.to];
    ForEachCorner(*lines_.rings[a.ring], {a.edge, b.edge, link.forward}, visit);
  }

  double LinkLength(int32_t from, const Link& link) const {
    Point at = lines_.PointOf(lines_.crossings[from]);
    double length = 0;
    ForEachLinkCorner(from, link, [&](Point p) { length += Distance(at, p), at = p; });
    return length + Distance(at, lines_.PointOf(lines_.crossings[link.to]));
  }

  void AppendLink(int32_t from, const Link& link, Polyline& path) const {
    ForEachLinkCorner(from, link, [&](Point p) { path.push_back(p); });
  }

  const ScanLines& lines_;
  const SerpentineOptions& options_;
  std::vector<bool> done_;
  std::optional<Point> at_;  ///< end of the last path
  int32_t next_ = 0;         ///< not monotonic: all pieces below this one are done
  std::vector<int32_t>
      waiting_for_;          ///< monotonic: number of undone pieces on the line below each piece
  std::set<int32_t> ready_;  ///< monotonic: undone pieces that wait for no other piece
};

}  // namespace

std::vector<SerpentinePath> Serpentine(const ScanLines& lines, const SerpentineOptions& options) {
  return Walker(lines, options).Run();
}

}  // namespace slicefarm::infill
