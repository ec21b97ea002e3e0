#include "services/beading/algo/fuzzy_skin.h"

#include <cmath>

#include "common/geometry/measure.h"
#include "common/model/options/beading_options.h"

namespace slicefarm::beading {
namespace {

constexpr double kLeastStep = 0.75;  ///< smallest step, as a fraction of the mean distance
constexpr double kStepRange = 0.5;

/// SplitMix64 random generator (G. L. Steele, D. Lea, C. H. Flood, 2014): short, and equal on all
/// machines.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  /// Returns a number in [0, 1).
  double Next() {
    uint64_t bits = state_ += 0x9E3779B97F4A7C15;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EB;
    bits ^= bits >> 31;
    return static_cast<double>(bits >> 11) * 0x1.0p-53;
  }

 private:
  uint64_t state_;
};

bool WantsSkin(FuzzySkin skin, const Path& wall) {
  const bool outermost = wall.closed && wall.inset == 0 && wall.feature != Feature::kGapFill;
  if (!outermost || skin == FuzzySkin::kNone) return false;
  return skin == FuzzySkin::kAllWalls || SignedArea(wall.points) > 0;
}

/// Returns the point at distance `along_nm` on an edge and `beside_nm` to its left.
Point PlaceBeside(Point from, Point to, double along_nm, double beside_nm) {
  const double length = Distance(from, to);
  const double x = static_cast<double>(to.x - from.x) / length;
  const double y = static_cast<double>(to.y - from.y) / length;
  return {from.x + std::llround(x * along_nm - y * beside_nm),
          from.y + std::llround(y * along_nm + x * beside_nm)};
}

void RoughenWall(const BeadingOptions& options, Random& random, Path& wall) {
  const auto distance = static_cast<double>(options.fuzzy_point_distance_nm);
  const auto thickness = static_cast<double>(options.fuzzy_thickness_nm);
  Path rough = wall;
  rough.points.clear();
  rough.widths_nm.clear();
  double along = random.Next() * kLeastStep / 2 * distance;
  const size_t count = wall.points.size();
  for (size_t i = 0; i < count; ++i) {
    const size_t next = (i + 1) % count;
    const double length = Distance(wall.points[i], wall.points[next]);
    for (; along < length; along += (kLeastStep + kStepRange * random.Next()) * distance) {
      const double beside = (2 * random.Next() - 1) * thickness;
      rough.points.push_back(PlaceBeside(wall.points[i], wall.points[next], along, beside));
      rough.widths_nm.push_back(wall.WidthAt(next));
    }
    along -= length;
  }
  if (rough.points.size() < 3) return;  // a dot is not roughened
  if (wall.widths_nm.size() == 1) rough.widths_nm = wall.widths_nm;
  wall = std::move(rough);
}

}  // namespace

void Roughen(const BeadingOptions& options, SkinSeed seed, std::vector<Path>& walls) {
  if (options.fuzzy == FuzzySkin::kNone) return;
  for (Path& wall : walls) {
    if (!WantsSkin(options.fuzzy, wall)) continue;
    // The seed contains the wall's own position, so skins do not depend on the rest of the section.
    uint64_t bits = static_cast<uint32_t>(seed.object);
    for (const int64_t part : {int64_t{seed.layer}, wall.points[0].x, wall.points[0].y})
      bits = (bits ^ static_cast<uint64_t>(part)) * 0x100000001B3;
    Random random(bits);
    RoughenWall(options, random, wall);
  }
}

}  // namespace slicefarm::beading
