#include "services/infill/algo/linking/solid_beads.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/geometry/measure.h"
#include "services/infill/algo/lines/strip_ramps.h"

namespace slicefarm::infill {
namespace {

/// Length, in pitches, of the plain ends of a fitted line that would otherwise leave the region.
constexpr double kPlainEndPitches = 0.75;

/// Returns, for each crossing, true if a link runs from it to the next crossing on its ring.
std::vector<bool> LinkedSpans(const ScanLines& lines, const std::vector<SerpentinePath>& paths) {
  std::vector<bool> linked(lines.crossings.size(), false);
  for (const SerpentinePath& path : paths)
    for (const int32_t from : path.spans) linked[from] = true;
  return linked;
}

FittedStrips StripsOf(const ScanLines& lines, const std::vector<SerpentinePath>& paths,
                      const SolidBeads::Options& options) {
  if (!options.fitted) return FittedStrips(lines);
  return FittedStrips(lines, {.linked = LinkedSpans(lines, paths),
                              .link_nm = options.link_share * lines.pitch,
                              .reach_nm = options.reach_nm});
}

/// Removes `length_nm` from the end of a bead.
void Shorten(double length_nm, std::vector<StripPoint>& bead) {
  while (bead.size() > 2) {
    const double edge = Distance(bead[bead.size() - 2].at, bead.back().at);
    if (edge > length_nm) break;
    length_nm -= edge;
    bead.pop_back();
  }
  const StripPoint before = bead[bead.size() - 2];
  const double edge = Distance(before.at, bead.back().at);
  if (edge > 0) bead.back() = Between(bead.back(), before, std::min(1.0, length_nm / edge));
}

/// Returns `bead` with its ends replaced, over `length_nm` each, by ramps to the end points of
/// `ends`, with their positions and widths.
std::vector<StripPoint> WithEndsOf(const std::vector<StripPoint>& ends,
                                   std::vector<StripPoint> bead, double length_nm) {
  if (Distance(ends.front().at, ends.back().at) < 3 * length_nm) return ends;
  Shorten(length_nm, bead);
  bead.push_back(ends.back());
  std::ranges::reverse(bead);
  Shorten(length_nm, bead);
  bead.push_back(ends.front());
  std::ranges::reverse(bead);
  return bead;
}

}  // namespace

SolidBeads::SolidBeads(const PolygonWithHoles& region, const ScanLines& lines,
                       const std::vector<SerpentinePath>& paths, const Options& options)
    : lines_(lines),
      link_nm_(options.link_share * lines.pitch),
      edges_({region}, std::llround(lines.pitch)),
      fitted_(StripsOf(lines, paths, options)),
      even_(lines) {}

SolidBeads::Bead SolidBeads::BeadOf(const SerpentinePath& path) const {
  Bead bead = LineFrom(path.places[0]);
  for (size_t piece = 0; piece + 1 < path.pieces.size(); ++piece) {
    const Bead next = LineFrom(path.places[piece + 1]);
    bead.push_back({bead.back().at, link_nm_});
    for (int32_t i = path.pieces[piece] + 2; i < path.pieces[piece + 1]; ++i)
      bead.push_back({path.points[i], link_nm_});
    bead.push_back({next.front().at, link_nm_});
    bead.insert(bead.end(), next.begin(), next.end());
  }
  return bead;
}

/// Returns the strip of a piece, from the crossing at `place` to its other end.
SolidBeads::Bead SolidBeads::LineFrom(int32_t place) const {
  const Bead fitted = fitted_.From(place), even = even_.From(place);
  if (fitted == even) return even;
  if (!Leaves(fitted, even)) return EvenRamps(fitted, lines_.pitch);
  const Bead plain_ends = WithEndsOf(even, fitted, kPlainEndPitches * lines_.pitch);
  return Leaves(plain_ends, even) ? even : EvenRamps(plain_ends, lines_.pitch);
}

/// Returns true if the strip of a piece leaves the region, or if the connection between its ends
/// and the ends of the plain strip does.
bool SolidBeads::Leaves(const Bead& bead, const Bead& even) const {
  if (Leaves(even.front().at, bead.front().at) || Leaves(bead.back().at, even.back().at))
    return true;
  for (size_t i = 1; i < bead.size(); ++i)
    if (Leaves(bead[i - 1].at, bead[i].at)) return true;
  return false;
}

}  // namespace slicefarm::infill
