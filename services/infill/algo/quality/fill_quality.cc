#include "services/infill/algo/quality/fill_quality.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/geometry/measure.h"
#include "services/infill/algo/quality/bead_cover.h"
#include "services/infill/algo/quality/fill_plastic.h"

namespace slicefarm::infill {
namespace {

template <class Visit>
void ForEachSegment(const Path& path, const Visit& visit) {
  const size_t count = path.points.size();
  for (size_t i = 1; i < count + (path.closed ? 1 : 0); ++i) visit(i - 1, i % count);
}

double TravelMm(std::span<const Path> paths) {
  std::vector<char> done(paths.size(), 0);
  double travel = 0;
  Point at;
  for (size_t step = 0; step < paths.size(); ++step) {
    size_t best = 0;
    bool backwards = false;
    double nearest = -1;
    for (size_t i = 0; i < paths.size(); ++i) {
      if (done[i]) continue;
      const double to_start = Distance(at, StartOf(paths[i])),
                   to_end = Distance(at, EndOf(paths[i]));
      if (const double route = std::min(to_start, to_end); nearest < 0 || route < nearest) {
        nearest = route;
        best = i;
        backwards = to_end < to_start;
      }
    }
    done[best] = 1;
    if (step > 0) travel += nearest;
    at = backwards ? StartOf(paths[best]) : EndOf(paths[best]);
  }
  return ToMm(travel);
}

double Isotropy(std::span<const Path> paths) {
  double xx = 0, yy = 0, xy = 0;
  for (const Path& path : paths) {
    ForEachSegment(path, [&](size_t from, size_t to) {
      const Point route = path.points[to] - path.points[from];
      const double length = Norm(route);
      if (length == 0) return;
      const auto x = static_cast<double>(route.x), y = static_cast<double>(route.y);
      xx += x * x / length;
      yy += y * y / length;
      xy += x * y / length;
    });
  }
  const double mean = (xx + yy) / 2, apart = std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy) / 2;
  return mean <= 0 ? 0 : std::max(0.0, mean - apart) / (mean + apart);
}

/// Returns points along a path, `step_nm` apart.
std::vector<Point> PlacesAlong(const Path& path, double step_nm) {
  std::vector<Point> places;
  double next = 0, passed = 0;
  ForEachSegment(path, [&](size_t from, size_t to) {
    const Point a = path.points[from], route = path.points[to] - a;
    const double length = Norm(route);
    for (; next <= passed + length && length > 0; next += step_nm) {
      const double share = (next - passed) / length;
      places.push_back(a + Point{std::llround(share * static_cast<double>(route.x)),
                                 std::llround(share * static_cast<double>(route.y))});
    }
    passed += length;
  });
  return places;
}

double Locality(const Path& path, double spacing_nm) {
  const double step =
      std::max(spacing_nm, PathLength(path) / static_cast<double>(kMostLocalityPlaces));
  const std::vector<Point> places = PlacesAlong(path, step);
  double worst = 0;
  for (size_t i = 0; i < places.size(); ++i)
    for (size_t j = i + 1; j < places.size(); ++j)
      worst = std::max(worst, SquaredNorm(places[j] - places[i]) / static_cast<double>(j - i));
  return worst / step / spacing_nm;
}

}  // namespace

FillQuality QualityOf(const MultiPolygon& region, std::span<const Path> paths, Coord height_nm,
                      Coord spacing_nm) {
  FillQuality quality;
  quality.paths = std::ssize(paths);
  const double area = Area(region) / kNmPerMm / kNmPerMm;
  const Path* longest = nullptr;
  double volume = 0;
  for (const Path& path : paths) {
    const double length = ToMm(PathLength(path));
    quality.length_mm += length;
    if (longest == nullptr || length > quality.longest_mm) longest = &path;
    quality.longest_mm = std::max(quality.longest_mm, length);
    volume += PlasticMm3(path, height_nm);
  }
  if (area <= 0 || longest == nullptr) return quality;
  quality.got = volume / (area * ToMm(static_cast<double>(height_nm)));
  quality.covered = CoveredShare(region, paths, height_nm, spacing_nm);
  quality.travel_mm = TravelMm(paths);
  quality.isotropy = Isotropy(paths);
  quality.locality = Locality(*longest, static_cast<double>(spacing_nm));
  return quality;
}

PropertyBounds StiffnessBounds(double density) { return {density * density, density}; }

PropertyBounds ConductivityBounds(double density, double material, double air) {
  return {1 / (density / material + (1 - density) / air), density * material + (1 - density) * air};
}

}  // namespace slicefarm::infill
