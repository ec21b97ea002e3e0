#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/shared/shared_text.h"
#include "common/model/process.h"

namespace slicefarm {

/// Surface normal along which points of the texture are displaced.
enum class NormalKind : uint8_t {
  /// Normal of the face; on an edge the mean of both faces, at a vertex the mean of the faces
  /// around it.
  kFaces,
  kInterpolated,  ///< normal interpolated between the normals of the vertices
};

/// Rotary axes of a machine, besides X, Y and Z.
enum class AxisLayout : uint8_t {
  kNone,     ///< no rotary axis: the tool points down
  kTableAb,  ///< table that turns the part by B about Y, then by A about X
  kTableBc,  ///< table that turns the part by C about Z, then by B about Y
  kHeadAb,   ///< head that turns by A about X, then by B about Y
  kHeadBc,   ///< head that turns by B about Y, then by C about Z
};

/// Tool of the machine.
enum class ToolKind : uint8_t {
  kBeam,      ///< beam that M3 switches on and M5 switches off
  kSpindle,   ///< spindle that turns all the time
  kExtruder,  ///< extruder that deposits filament
};

/// Content of a job's output file.
enum class EngraveFormat : uint8_t {
  kCsv,  ///< points with normals
  kGcode,
  kStl,     ///< surface with the texture applied, as binary STL
  kObj,     ///< surface with the texture applied, as Wavefront OBJ
  kPng,     ///< picture of the lines over the surface
  kMapPng,  ///< picture of the map and its distortion
};

/// Returns true if the file is made as a whole. Other files are the texts of the layers, one after
/// the other.
constexpr bool IsWhole(EngraveFormat format) { return format >= EngraveFormat::kStl; }

/// Texture, its height and its position on the surface. Members with several numbers store the
/// user's text; NumbersOf parses them.
struct TextureSettings {
  /// Computed texture with its parameters, or the name of the object used as texture.
  std::string texture = "bumps";
  SharedText image;        ///< `texture_image`: PNG in base64; takes precedence over `texture`
  SharedText mask;         ///< `mask_image`: PNG in base64 that covers the bounding box of the map
  double width_mm = 20;    ///< width of the image on the surface
  double height_mm = 0.5;  ///< height of the texture at white pixels of the image
  /// X,Y distance between repetitions of the object; empty: the size of its bounding box
  std::string pitch;
  std::string anchor;  ///< X,Y,Z of the texture's origin; empty: the middle of the map
  std::string orient;  ///< X,Y,Z direction of the texture's x axis; empty: the x axis of the map
  double turn_deg = 0;
  double scale = 1;
  bool once = false;
  double margin_mm = 0;
  bool engraved = false;
  bool outside = false;

  friend bool operator==(const TextureSettings&, const TextureSettings&) = default;
};

/// Settings of the layers and of the lines in them.
struct EngraveLineSettings {
  double layer_height_mm = 0.05;
  /// line spacing per layer in mm, as a list that repeats from the start
  std::string spacing = "0.1";
  /// Line angle per layer in degrees, as a list that repeats from the start.
  std::string angle = "0";
  bool equidistant = false;
  NormalKind normals = NormalKind::kFaces;
  bool connect = true;
  double clearance_mm = 0;
  double shortest_mm = 0;
  /// True: cuts a surface open that is not a topological disk; false: refuses such a surface.
  bool seam = true;

  friend bool operator==(const EngraveLineSettings&, const EngraveLineSettings&) = default;
};

/// Settings of the machine.
struct EngraveMachineSettings {
  AxisLayout axes = AxisLayout::kTableBc;
  ToolKind tool = ToolKind::kBeam;
  std::string centre;  ///< X,Y,Z of the point where the table's axes meet; empty: the origin
  double pivot_mm = 100;
  double tilt_deg = 110;
  double steepest_deg = 60;
  double power = 1000;
  double feed_mm_min = 1200;
  double link_mm_min = 6000;
  double turn_deg_min = 7200;

  friend bool operator==(const EngraveMachineSettings&, const EngraveMachineSettings&) = default;
};

/// Settings of an engraving job.
struct EngraveSettings {
  static constexpr Process kProcess = Process::kEngrave;

  TextureSettings texture;
  EngraveLineSettings lines;
  EngraveMachineSettings machine;
  EngraveFormat format = EngraveFormat::kCsv;
  double displaced_edge_mm = 0.2;  ///< longest triangle edge of a surface with the texture applied

  friend bool operator==(const EngraveSettings&, const EngraveSettings&) = default;
};

/// Returns the engraving settings of a job (JobSettings, JobRows). Engraving has no settings per
/// object or region. REQUIRES: the job is an engraving job.
template <typename Job>
auto& EngraveOf(Job& job) {
  return job.own.template As<EngraveSettings>();
}

/// Returns the numbers of a comma-separated text; an empty text has no numbers. `count`: required
/// number of numbers; 0: between 1 and 1000. Errors: SETTING_MALFORMED naming `setting`.
absl::StatusOr<std::vector<double>> NumbersOf(std::string_view setting, std::string_view text,
                                              size_t count);

/// Checks that all texts of numbers and all images can be parsed. Errors: SETTING_MALFORMED naming
/// the setting.
absl::Status CheckTexts(const EngraveSettings& settings);

/// Returns the bytes of an image. Errors: SETTING_MALFORMED if the text is not base64.
absl::StatusOr<std::string> ImageBytes(std::string_view setting, std::string_view base64);

}  // namespace slicefarm
