#include "services/beading/algo/fuzzy_skin.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "common/base/split_mix.h"
#include "common/geometry/measure.h"
#include "common/model/bead_section.h"
#include "common/model/options/beading_options.h"
#include "services/beading/algo/noise/skin_noise.h"

namespace slicefarm::beading {
namespace {

constexpr double kLeastStep = 0.75;  ///< smallest step, as a fraction of the mean distance
constexpr double kStepRange = 0.5;
/// Spacing of the narrowest bead, in nm. A narrower bead would break.
constexpr Coord kLeastSpacing = 50'000;

bool WantsSkin(FuzzySkin skin, const Path& wall) {
  if (!wall.closed || wall.feature == Feature::kGapFill || skin == FuzzySkin::kNone) return false;
  if (skin == FuzzySkin::kEveryWall) return true;
  return wall.inset == 0 && (skin == FuzzySkin::kAllWalls || SignedArea(wall.points) > 0);
}

/// Returns the point at distance `along_nm` on an edge and `beside_nm` to its left.
Point PointBeside(Point from, Point to, double along_nm, double beside_nm) {
  const double length = Distance(from, to);
  const double x = static_cast<double>(to.x - from.x) / length;
  const double y = static_cast<double>(to.y - from.y) / length;
  return {from.x + std::llround(x * along_nm - y * beside_nm),
          from.y + std::llround(y * along_nm + x * beside_nm)};
}

/// Maker of the rough copy of a wall.
class RoughWall {
 public:
  RoughWall(const BeadingOptions& options, const SkinContext& context, const Path& wall)
      : options_(options),
        context_(context),
        wall_(wall),
        thickness_(static_cast<double>(options.fuzzy_thickness_nm)),
        least_width_(WidthForSpacing(kLeastSpacing, context.height_nm)) {
    rough_ = wall;
    rough_.points.clear();
    rough_.widths_nm.clear();
    if (options.texture.noise == FuzzyNoise::kRipple)
      ripples_.emplace(options.texture, wall, context.layer);
  }

  /// Returns the rough wall, or nullopt for a dot, which has no space for roughness.
  std::optional<Path> Make(SplitMix& random) && {
    const auto distance = static_cast<double>(options_.fuzzy_point_distance_nm);
    double along = random.Share() * kLeastStep / 2 * distance;
    double before = 0;
    int32_t new_points = 0;
    const size_t count = wall_.points.size();
    for (size_t i = 0; i < count; ++i) {
      const size_t next = (i + 1) % count;
      const double length = Distance(wall_.points[i], wall_.points[next]);
      if (KeepsCorners()) Add(i, next, 0, before, random);
      for (; along < length; along += (kLeastStep + kStepRange * random.Share()) * distance) {
        Add(i, next, along, before + along, random);
        ++new_points;
      }
      along -= length;
      before += length;
    }
    if (new_points < 3) return std::nullopt;
    if (options_.texture.mode == FuzzyMode::kDisplacement && wall_.widths_nm.size() == 1)
      rough_.widths_nm = wall_.widths_nm;
    return std::move(rough_);
  }

 private:
  bool KeepsCorners() const { return options_.texture.mode == FuzzyMode::kExtrusion; }

  /// Adds the point `along_nm` on the edge from corner `i` to corner `next`. `total_nm`: distance
  /// from the wall's first point.
  void Add(size_t i, size_t next, double along_nm, double total_nm, SplitMix& random) {
    const Point from = wall_.points[i], to = wall_.points[next];
    const Coord width = wall_.WidthAt(next);
    const double change = thickness_ * NoiseAt(from, to, along_nm, total_nm, random);
    if (options_.texture.mode == FuzzyMode::kDisplacement) {
      // Lumps and ridges of the other noises stand out of the part, which is to the left.
      const bool classic = options_.texture.noise == FuzzyNoise::kClassic;
      AddPoint(PointBeside(from, to, along_nm, classic ? change : -change), width);
      return;
    }
    const Coord rough = std::max<Coord>(least_width_, width + std::llround(change));
    // The inner side of the bead stays, so that it holds to the next wall. The part is to the left.
    const double beside =
        options_.texture.mode == FuzzyMode::kCombined ? static_cast<double>(width - rough) / 2 : 0;
    AddPoint(PointBeside(from, to, along_nm, beside), rough);
  }

  double NoiseAt(Point from, Point to, double along_nm, double total_nm, SplitMix& random) const {
    const FuzzyTexture& texture = options_.texture;
    if (texture.noise == FuzzyNoise::kClassic) return 2 * random.Share() - 1;
    if (ripples_) return ripples_->At(total_nm);
    return TextureNoise(texture, PointBeside(from, to, along_nm, 0), context_.z_nm);
  }

  void AddPoint(Point point, Coord width) {
    rough_.points.push_back(point);
    rough_.widths_nm.push_back(width);
  }

  const BeadingOptions& options_;
  const SkinContext& context_;
  const Path& wall_;
  const double thickness_;
  const Coord least_width_;
  std::optional<Ripples> ripples_;
  Path rough_;
};

}  // namespace

void Roughen(const BeadingOptions& options, const SkinContext& context, std::vector<Path>& walls) {
  if (options.fuzzy == FuzzySkin::kNone || (context.layer == 0 && !options.texture.first_layer))
    return;
  for (Path& wall : walls) {
    if (!WantsSkin(options.fuzzy, wall)) continue;
    // The seed contains the wall's own position, so skins do not depend on the rest of the section.
    uint64_t bits = static_cast<uint32_t>(context.object);
    for (const int64_t part : {int64_t{context.layer}, wall.points[0].x, wall.points[0].y})
      bits = (bits ^ static_cast<uint64_t>(part)) * 0x100000001B3;
    SplitMix random(bits);
    if (std::optional<Path> rough = RoughWall(options, context, wall).Make(random))
      wall = *std::move(rough);
  }
}

}  // namespace slicefarm::beading
