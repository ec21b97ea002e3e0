#include "services/texture/algo/pattern/computed_heights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "common/base/error.h"
#include "common/base/portable_math.h"
#include "common/base/split_mix.h"
#include "services/texture/algo/pattern/stroke_font.h"

namespace slicefarm::texture {
namespace {

constexpr double kPi = std::numbers::pi;
const double kRoot3 = std::sqrt(3.0);

/// Texture in units of its pitch and its height. `size`: period, in pitches.
struct UnitTexture {
  Eigen::Vector2d size = {1, 1};
  std::function<double(const Eigen::Vector2d&)> height;
};

double Clamp01(double x) { return std::clamp(x, 0.0, 1.0); }

/// Returns the height of a flank at the distance `inside` from its foot: 0 outside, 1 from `slope`
/// on.
double Flank(double inside, double slope) { return Clamp01(inside / slope); }

/// Returns the distance from the nearest integer, 0 to 1/2.
double FromWhole(double x) { return std::abs(x - std::round(x)); }

Eigen::Vector2d FromCentre(const Eigen::Vector2d& p) { return p - Eigen::Vector2d(0.5, 0.5); }

UnitTexture Bumps(const TextureSpec& spec) {
  return {{1, 1}, [radius = spec.size / 2](const Eigen::Vector2d& p) {
            const double share = FromCentre(p).squaredNorm() / (radius * radius);
            return std::sqrt(std::max(0.0, 1 - share));
          }};
}

UnitTexture Cones(const TextureSpec& spec) {
  return {{1, 1}, [radius = spec.size / 2](const Eigen::Vector2d& p) {
            return Clamp01(1 - FromCentre(p).norm() / radius);
          }};
}

UnitTexture Pyramids(const TextureSpec& spec) {
  return {{1, 1}, [half = spec.size / 2](const Eigen::Vector2d& p) {
            return Clamp01(1 - FromCentre(p).cwiseAbs().maxCoeff() / half);
          }};
}

UnitTexture Grooves(const TextureSpec& spec) {
  return {{1, 1}, [=](const Eigen::Vector2d& p) {
            return Flank(spec.size / 2 - std::abs(p.x() - 0.5), spec.slope);
          }};
}

UnitTexture Waves(const TextureSpec& spec) {
  return {{1, 1}, [=](const Eigen::Vector2d& p) {
            const double along = 0.5 - 0.5 * Cos(2 * kPi * p.x());
            const double across = 0.5 - 0.5 * Cos(2 * kPi * p.y());
            return along * (1 - spec.cross * across);
          }};
}

UnitTexture Hexagons(const TextureSpec& spec) {
  return {{1, kRoot3}, [=](const Eigen::Vector2d& p) {
            double nearest = 1;
            for (const auto& centre : {Eigen::Vector2d(0, 0), Eigen::Vector2d(0.5, kRoot3 / 2)}) {
              const Eigen::Vector2d d = p - centre;
              const double x = FromWhole(d.x()), y = kRoot3 * FromWhole(d.y() / kRoot3);
              nearest = std::min(nearest, std::max(x, x / 2 + y * kRoot3 / 2));
            }
            return Flank(spec.size / 2 - nearest, spec.slope);
          }};
}

/// Returns the height of a woven strand that follows a line. It is highest at even values of
/// `along` and lowest at odd ones.
double StrandHeight(double across, double along, double width) {
  const double share = across / (width / 2);
  return std::sqrt(std::max(0.0, 1 - share * share)) * (0.6 + 0.4 * Cos(kPi * along));
}

UnitTexture Weave(const TextureSpec& spec) {
  return {{2, 2}, [width = spec.size](const Eigen::Vector2d& p) {
            const double column = std::floor(p.x()), row = std::floor(p.y());
            const double upright =
                StrandHeight(p.x() - column - 0.5, p.y() - (column + 0.5), width);
            const double level = StrandHeight(p.y() - row - 0.5, p.x() - (row + 1.5), width);
            return std::max(upright, level);
          }};
}

double ToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d path = b - a;
  const double length = path.squaredNorm();
  const double t = length > 0 ? Clamp01((p - a).dot(path) / length) : 0;
  return (p - a - t * path).norm();
}

UnitTexture Letters(const TextureSpec& spec) {
  std::vector<std::vector<Stroke>> glyphs;
  for (const char c : spec.text) glyphs.push_back(GlyphOf(c));
  const auto count = static_cast<int>(glyphs.size());
  // Lengths are in units of the font: a margin of 1 on each side, of 1.5 above and below.
  const auto distance = [glyphs, count](const Eigen::Vector2d& at) {
    double nearest = 2 * kGlyphHeight;
    const int here = static_cast<int>(std::floor(at.x() / kGlyphAdvance));
    for (int letter = here - 1; letter <= here + 1; ++letter) {
      const Eigen::Vector2d p = at - Eigen::Vector2d(letter * kGlyphAdvance + 1, 1.5);
      for (const Stroke& stroke : glyphs[(letter + count) % count])
        for (size_t i = 0; i + 1 < stroke.size(); ++i)
          nearest = std::min(nearest, ToSegment(p, stroke[i], stroke[i + 1]));
    }
    return nearest;
  };
  return {{count * kGlyphAdvance / kGlyphHeight, 1.5}, [=](const Eigen::Vector2d& p) {
            return Flank(spec.size / 2 + spec.slope - distance(kGlyphHeight * p) / kGlyphHeight,
                         spec.slope);
          }};
}

/// Returns a random number in [0, 1) for a node of a lattice.
double RandomAt(int64_t column, int64_t row, int64_t which, double seed) {
  uint64_t bits = static_cast<uint64_t>(seed) * kSplitMixStep;
  for (const int64_t part : {column, row, which})
    bits = MixedBits(bits + static_cast<uint64_t>(part) + kSplitMixStep);
  return ShareOfBits(bits);
}

int64_t Wrapped(int64_t i, int64_t count) { return (i % count + count) % count; }

UnitTexture Cells(const TextureSpec& spec) {
  const auto count = static_cast<int64_t>(spec.count);
  const auto point = [=](int64_t i, int64_t k) {
    const auto offset = [&](int64_t which) {
      return 0.1 + 0.8 * RandomAt(Wrapped(i, count), Wrapped(k, count), which, spec.seed);
    };
    return Eigen::Vector2d(static_cast<double>(i) + offset(0), static_cast<double>(k) + offset(1));
  };
  const auto to_border = [=](const Eigen::Vector2d& p) {
    const auto column = static_cast<int64_t>(std::floor(p.x()));
    const auto row = static_cast<int64_t>(std::floor(p.y()));
    std::array<Eigen::Vector2d, 25> around;
    for (int i = 0; i < 25; ++i) around[i] = point(column - 2 + i % 5, row - 2 + i / 5);
    const auto own = *std::min_element(around.begin(), around.end(), [&](auto& a, auto& b) {
      return (a - p).squaredNorm() < (b - p).squaredNorm();
    });
    double nearest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& other : around) {
      if (other == own) continue;
      nearest = std::min(nearest, ((own + other) / 2 - p).dot((other - own).normalized()));
    }
    return nearest;
  };
  return {{spec.count, spec.count}, [=](const Eigen::Vector2d& p) {
            return Flank(to_border(p) - (1 - spec.size) / 2, spec.slope);
          }};
}

/// Returns gradient noise on a lattice that repeats after `count`. Source: K. Perlin, "Improving
/// Noise", SIGGRAPH 2002.
double GradientNoise(const Eigen::Vector2d& p, int64_t count, double seed) {
  const double column = std::floor(p.x()), row = std::floor(p.y());
  const auto corner = [&](int dx, int dy) {
    const double turn = 2 * kPi *
                        RandomAt(Wrapped(static_cast<int64_t>(column) + dx, count),
                                 Wrapped(static_cast<int64_t>(row) + dy, count), count, seed);
    return Cos(turn) * (p.x() - column - dx) + Sin(turn) * (p.y() - row - dy);
  };
  const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const double x = fade(p.x() - column), y = fade(p.y() - row);
  const double low = corner(0, 0) + x * (corner(1, 0) - corner(0, 0));
  const double high = corner(0, 1) + x * (corner(1, 1) - corner(0, 1));
  return low + y * (high - low);
}

UnitTexture Noise(const TextureSpec& spec) {
  return {{spec.count, spec.count}, [=](const Eigen::Vector2d& p) {
            double sum = 0, share = 1;
            auto count = static_cast<int64_t>(spec.count);
            Eigen::Vector2d at = p;
            for (int octave = 0; octave < spec.octaves; ++octave) {
              sum += share * GradientNoise(at, count, spec.seed);
              share /= 2;
              count *= 2;
              at *= 2;
            }
            return Clamp01(0.5 + 0.8 * sum);
          }};
}

UnitTexture Scales(const TextureSpec& /*spec*/) {
  // The texture has two rows of discs, half a pitch apart. Each disc rises from its upper end to
  // its lower end.
  return {{1, 1}, [](const Eigen::Vector2d& p) {
            constexpr double kRadius = 0.56, kLowest = 0.29;  // height visible between discs
            double height = 0;
            for (int row = -2; row <= 4; ++row) {
              const double y = p.y() - row * 0.5;
              const double x = FromWhole(p.x() - (row % 2 == 0 ? 0 : 0.5));
              if (x * x + y * y <= kRadius * kRadius)
                height = std::max(height, (kRadius - y) / (2 * kRadius));
            }
            return Clamp01((height - kLowest) / (1 - kLowest));
          }};
}

UnitTexture Knurl(const TextureSpec& spec) {
  const double tangent = Tan(spec.angle_deg * kPi / 180);
  return {{1, 1 / tangent}, [=](const Eigen::Vector2d& p) {
            const double y = p.y() * tangent;
            return 2 * std::min(FromWhole(p.x() + y), FromWhole(p.x() - y));
          }};
}

UnitTexture UnitOf(const TextureSpec& spec) {
  using enum TextureKind;
  switch (spec.kind) {
    case kBumps:
      return Bumps(spec);
    case kCones:
      return Cones(spec);
    case kPyramids:
      return Pyramids(spec);
    case kGrooves:
      return Grooves(spec);
    case kWaves:
      return Waves(spec);
    case kHexagons:
      return Hexagons(spec);
    case kWeave:
      return Weave(spec);
    case kLetters:
      return Letters(spec);
    case kCells:
      return Cells(spec);
    case kNoise:
      return Noise(spec);
    case kScales:
      return Scales(spec);
    case kKnurl:
      return Knurl(spec);
  }
  return {};
}

}  // namespace

absl::StatusOr<HeightGrid> ComputedHeights(const TextureSpec& spec) {
  const UnitTexture unit = UnitOf(spec);
  // The numbers of nodes are even, so that there is a node at the middle of the pitch.
  const auto nodes = [&](double size) {
    return 2 * std::max<int64_t>(2, std::llround(size * spec.detail / 2));
  };
  const int64_t columns = nodes(unit.size.x()), rows = nodes(unit.size.y());
  if (columns * rows > kMaxHeightNodes)
    return LimitError(Reason::kRequestTooLarge, "nodes of the texture", kMaxHeightNodes,
                      columns * rows);
  HeightGrid grid{
      static_cast<int32_t>(columns), static_cast<int32_t>(rows), unit.size * spec.pitch_mm, {}};
  grid.heights_mm.reserve(columns * rows);
  for (int64_t row = 0; row < rows; ++row) {
    for (int64_t column = 0; column < columns; ++column) {
      const Eigen::Vector2d place(
          unit.size.x() * static_cast<double>(column) / static_cast<double>(columns),
          unit.size.y() * static_cast<double>(row) / static_cast<double>(rows));
      grid.heights_mm.push_back(spec.height_mm * unit.height(place));
    }
  }
  return grid;
}

}  // namespace slicefarm::texture
