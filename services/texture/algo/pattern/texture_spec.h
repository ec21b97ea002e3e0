#pragma once

#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::texture {

/// Textures that are computed.
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

struct TextureKindInfo {
  TextureKind kind;
  std::string_view name;
  std::string_view doc;
};

inline constexpr TextureKindInfo kTextureKinds[] = {
    {TextureKind::kBumps, "bumps", "half ellipsoids, one a pitch"},
    {TextureKind::kCones, "cones", "cones, one a pitch"},
    {TextureKind::kPyramids, "pyramids", "square pyramids, one a pitch"},
    {TextureKind::kGrooves, "grooves", "ridges with flat tops along y, one a pitch"},
    {TextureKind::kWaves, "waves", "a sine along x; crossed by one along y on request"},
    {TextureKind::kHexagons, "hexagons", "flat hexagons with gaps, a pitch apart"},
    {TextureKind::kWeave, "weave", "strands over and under each other, a pitch apart"},
    {TextureKind::kLetters, "letters", "a line of text whose letters are a pitch high"},
    {TextureKind::kCells, "cells", "flat cells around random points, about a pitch wide"},
    {TextureKind::kNoise, "noise", "random hills, the largest about a pitch wide"},
    {TextureKind::kScales, "scales", "fish scales, a pitch wide"},
    {TextureKind::kKnurl, "knurl", "diamonds between two sets of crossing grooves"},
};
inline constexpr size_t kTextureKindCount = std::size(kTextureKinds);

std::string_view NameOf(TextureKind kind);

/// A computed texture and its parameters; each kind heeds some of them (ParametersOf).
struct TextureSpec {
  TextureKind kind = TextureKind::kBumps;
  double height_mm = 0.5;
  double pitch_mm = 4;
  double size = 0.8;      ///< share of the pitch that is raised, or a stroke's share of the letter
  double slope = 0.1;     ///< share of the pitch over which a flank rises
  double cross = 0;       ///< the second sine's share of the height
  double angle_deg = 30;  ///< of crossing grooves, to the y axis
  double count = 4;       ///< cells or hills along a side of the tile
  double octaves = 3;     ///< of noise, each half as wide and half as high
  double seed = 1;
  double detail = 40;  ///< nodes a pitch
  std::string text = "SLICEFARM";

  friend bool operator==(const TextureSpec&, const TextureSpec&) = default;
};

struct TextureParameter {
  std::string_view key;
  double TextureSpec::*value;
  double least;
  double most;
  bool whole;  ///< a whole number
  std::string_view doc;
};

/// What a kind can be told, besides the text of letters.
std::vector<TextureParameter> ParametersOf(TextureKind kind);

/// `bumps`, `bumps:pitch=3,height=0.4`: a kind, and parameters in any order. Errors:
/// SETTING_MALFORMED for what is no kind, no parameter of it or no number; SETTING_OUT_OF_RANGE.
absl::StatusOr<TextureSpec> ParseTextureSpec(std::string_view text);

/// With all parameters; ParseTextureSpec takes it back.
std::string TextureSpecText(const TextureSpec& spec);

}  // namespace slicefarm::texture
