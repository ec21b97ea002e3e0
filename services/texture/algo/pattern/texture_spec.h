#pragma once

#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::texture {

/// Kind of a computed texture.
enum class TextureKind : uint8_t {
  kBumps,
  kCones,
  kPyramids,
  kGrooves,
  kWaves,
  kHexagons,
  kWeave,
  kLetters,
  kCells,
  kNoise,
  kScales,
  kKnurl,
};

/// Name and description of a kind.
struct TextureKindInfo {
  TextureKind kind;
  std::string_view name;
  std::string_view doc;
};

inline constexpr TextureKindInfo kTextureKinds[] = {
    {TextureKind::kBumps, "bumps", "half ellipsoids, one per pitch"},
    {TextureKind::kCones, "cones", "cones, one per pitch"},
    {TextureKind::kPyramids, "pyramids", "square pyramids, one per pitch"},
    {TextureKind::kGrooves, "grooves", "ridges with flat tops along y, one per pitch"},
    {TextureKind::kWaves, "waves", "sine waves along x, optionally crossed by waves along y"},
    {TextureKind::kHexagons, "hexagons", "flat hexagons with gaps, a pitch apart"},
    {TextureKind::kWeave, "weave", "woven strands, a pitch apart"},
    {TextureKind::kLetters, "letters", "line of text with letters one pitch high"},
    {TextureKind::kCells, "cells", "flat cells around random points, about one pitch wide"},
    {TextureKind::kNoise, "noise", "random hills, the largest about one pitch wide"},
    {TextureKind::kScales, "scales", "fish scales, one pitch wide"},
    {TextureKind::kKnurl, "knurl", "diamonds between two sets of crossing grooves"},
};
inline constexpr size_t kTextureKindCount = std::size(kTextureKinds);

/// Returns the name of a kind.
std::string_view NameOf(TextureKind kind);

/// Computed texture and its parameters; each kind uses some of them (ParametersOf).
struct TextureSpec {
  TextureKind kind = TextureKind::kBumps;
  double height_mm = 0.5;
  double pitch_mm = 4;
  /// Width of the raised part as a share of the pitch; for letters, width of a stroke as a share of
  /// the letter.
  double size = 0.8;
  double slope = 0.1;     ///< share of the pitch over which a flank rises
  double cross = 0;       ///< height of the second sine, as a share of the texture's height
  double angle_deg = 30;  ///< angle of crossing grooves to the y axis
  double count = 4;       ///< number of cells or hills along a side of the tile
  /// Number of octaves of noise, each half as wide and half as high as the previous one.
  double octaves = 3;
  double seed = 1;
  double detail = 40;  ///< number of nodes per pitch
  std::string text = "SLICEFARM";

  friend bool operator==(const TextureSpec&, const TextureSpec&) = default;
};

/// Parameter of a texture, with its range.
struct TextureParameter {
  std::string_view key;
  double TextureSpec::*value;
  double least;
  double most;
  bool whole;  ///< true for an integer
  std::string_view doc;
};

/// Returns the parameters of a kind, without the text of letters.
std::vector<TextureParameter> ParametersOf(TextureKind kind);

/// Parses a kind and parameters in any order: `bumps`, `bumps:pitch=3,height=0.4`. Errors:
/// SETTING_MALFORMED for an unknown kind, a parameter that the kind does not have, or an invalid
/// number; SETTING_OUT_OF_RANGE.
absl::StatusOr<TextureSpec> ParseTextureSpec(std::string_view text);

/// Returns the text of a texture with all its parameters, in the form of ParseTextureSpec.
std::string TextureSpecText(const TextureSpec& spec);

}  // namespace slicefarm::texture
