#include "services/texture/algo/pattern/texture_spec.h"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <optional>

#include "absl/strings/ascii.h"
#include "common/base/error.h"
#include "common/base/text.h"
#include "services/texture/algo/pattern/stroke_font.h"

namespace slicefarm::texture {
namespace {

constexpr size_t kMaxLetters = 64;

using Kinds = std::initializer_list<TextureKind>;

struct ParameterRow {
  TextureParameter parameter;
  std::vector<TextureKind> kinds;  // empty: all kinds
};

const std::vector<ParameterRow>& ParameterRows() {
  using enum TextureKind;
  static const std::vector<ParameterRow> rows = {
      {{"height", &TextureSpec::height_mm, 1e-3, 100, false, "mm"}, {}},
      {{"pitch", &TextureSpec::pitch_mm, 1e-2, 1000, false, "mm"}, {}},
      {{"size", &TextureSpec::size, 0.05, 1, false, "raised share of the pitch"},
       {kBumps, kCones, kPyramids, kGrooves, kHexagons, kWeave, kCells}},
      {{"stroke", &TextureSpec::size, 0.02, 1, false, "width of a stroke as a share of the pitch"},
       {kLetters}},
      {{"slope", &TextureSpec::slope, 0.01, 0.5, false, "width of a flank as a share of the pitch"},
       {kGrooves, kHexagons, kLetters, kCells}},
      {{"cross", &TextureSpec::cross, 0, 1, false, "share of the sine along y"}, {kWaves}},
      {{"angle", &TextureSpec::angle_deg, 10, 80, false, "angle of the grooves to y, in degrees"},
       {kKnurl}},
      {{"count", &TextureSpec::count, 2, 64, true, "number of cells along the tile"},
       {kCells, kNoise}},
      {{"octaves", &TextureSpec::octaves, 1, 8, true, "number of finer and finer layers of hills"},
       {kNoise}},
      {{"seed", &TextureSpec::seed, 0, 1e9, true, "seed of the random values"}, {kCells, kNoise}},
      {{"detail", &TextureSpec::detail, 4, 400, true, "nodes a pitch"}, {}},
  };
  return rows;
}

/// Returns the default parameters of a kind, where they differ from the defaults of TextureSpec.
TextureSpec StandardOf(TextureKind kind) {
  TextureSpec spec{.kind = kind};
  if (kind == TextureKind::kGrooves) spec.size = 0.5;
  if (kind == TextureKind::kLetters) spec.size = 0.16;
  if (kind == TextureKind::kHexagons || kind == TextureKind::kCells) spec.size = 0.85;
  if (kind == TextureKind::kLetters) spec.slope = 0.05;
  return spec;
}

std::optional<TextureKind> KindNamed(std::string_view name) {
  for (const TextureKindInfo& info : kTextureKinds)
    if (info.name == name) return info.kind;
  return std::nullopt;
}

absl::Status MalformedSpec(std::string_view what) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingMalformed,
                   fmt::format("texture: {}", what), {{"setting", "texture"}});
}

absl::Status SetNumber(const TextureParameter& parameter, std::string_view text,
                       TextureSpec* spec) {
  const auto number = ToNumber(text);
  if (!number || (parameter.whole && *number != std::floor(*number)))
    return MalformedSpec(fmt::format("{} is not a {}number: '{}'", parameter.key,
                                     parameter.whole ? "whole " : "", text));
  if (*number < parameter.least || *number > parameter.most)
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                     fmt::format("texture: {} must be from {} to {}, got {}", parameter.key,
                                 parameter.least, parameter.most, *number),
                     {{"setting", "texture"}});
  spec->*parameter.value = *number;
  return absl::OkStatus();
}

absl::Status SetText(std::string_view text, TextureSpec* spec) {
  spec->text = std::string(text);
  absl::AsciiStrToUpper(&spec->text);
  if (spec->text.empty() || spec->text.size() > kMaxLetters)
    return MalformedSpec(fmt::format("text must have 1 to {} letters", kMaxLetters));
  for (const char c : spec->text)
    if (!HasGlyph(c)) return MalformedSpec(fmt::format("the letter '{}' is not available", c));
  return absl::OkStatus();
}

absl::Status SetParameter(std::string_view part, TextureSpec* spec) {
  const size_t equals = part.find('=');
  if (equals == std::string_view::npos)
    return MalformedSpec(fmt::format("'{}' is not key=value", part));
  const std::string_view key = Trim(part.substr(0, equals)), value = part.substr(equals + 1);
  if (key == "text" && spec->kind == TextureKind::kLetters) return SetText(value, spec);
  std::string known;
  for (const TextureParameter& parameter : ParametersOf(spec->kind)) {
    if (parameter.key == key) return SetNumber(parameter, Trim(value), spec);
    known += fmt::format(" {}", parameter.key);
  }
  return MalformedSpec(
      fmt::format("{} has no parameter '{}'; it has{}", NameOf(spec->kind), key, known));
}

}  // namespace

std::string_view NameOf(TextureKind kind) { return kTextureKinds[static_cast<size_t>(kind)].name; }

std::vector<TextureParameter> ParametersOf(TextureKind kind) {
  std::vector<TextureParameter> parameters;
  for (const ParameterRow& row : ParameterRows()) {
    bool of_kind = row.kinds.empty();
    for (const TextureKind other : row.kinds) of_kind |= other == kind;
    if (of_kind) parameters.push_back(row.parameter);
  }
  return parameters;
}

absl::StatusOr<TextureSpec> ParseTextureSpec(std::string_view text) {
  const size_t colon = text.find(':');
  const std::string_view name = Trim(text.substr(0, colon));
  const auto kind = KindNamed(name);
  if (!kind) {
    std::string known;
    for (const TextureKindInfo& info : kTextureKinds) known += fmt::format(" {}", info.name);
    return MalformedSpec(fmt::format("unknown texture '{}'; textures are{}", name, known));
  }
  TextureSpec spec = StandardOf(*kind);
  if (colon == std::string_view::npos) return spec;
  for (const std::string_view part : Split(text.substr(colon + 1), ",")) {
    if (const absl::Status status = SetParameter(part, &spec); !status.ok()) return status;
  }
  return spec;
}

std::string TextureSpecText(const TextureSpec& spec) {
  std::string text(NameOf(spec.kind));
  char separator = ':';
  for (const TextureParameter& parameter : ParametersOf(spec.kind)) {
    text += fmt::format("{}{}={}", separator, parameter.key, spec.*parameter.value);
    separator = ',';
  }
  if (spec.kind == TextureKind::kLetters) text += fmt::format(",text={}", spec.text);
  return text;
}

}  // namespace slicefarm::texture
