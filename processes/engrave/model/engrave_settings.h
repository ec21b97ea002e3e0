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

enum class NormalKind : uint8_t {
  kFaces,  ///< the face's; on an edge the mean of its two faces', at a vertex that of its ring
  kInterpolated,  ///< between the vertices' normals
};

/// Which axes a machine has besides X, Y and Z.
enum class AxisLayout : uint8_t {
  kNone,     ///< the tool points down
  kTableAb,  ///< the part turns by B about Y, then by A about X
  kTableBc,  ///< the part turns by C about Z, then by B about Y
  kHeadAb,   ///< the head turns by A about X, then by B about Y
  kHeadBc,   ///< the head turns by B about Y, then by C about Z
};

enum class ToolKind : uint8_t {
  kBeam,      ///< on and off by M3 and M5
  kSpindle,   ///< turns all the time
  kExtruder,  ///< lays down filament
};

/// What a job's file holds.
enum class EngraveFormat : uint8_t {
  kCsv,  ///< points with normals
  kGcode,
  kStl,     ///< the surface with the texture in it, as binary STL
  kObj,     ///< the same as Wavefront OBJ
  kPng,     ///< a picture of the lines over the surface
  kMapPng,  ///< a picture of the map and its distortion
};

/// Returns true if the file is made at once; else it consists of the texts of its layers.
constexpr bool IsWhole(EngraveFormat format) { return format >= EngraveFormat::kStl; }

/// Which texture, how high, and where on the surface. Texts of numbers are as users write them:
/// NumbersOf reads them.
struct TextureSettings {
  std::string texture = "bumps";  ///< a computed kind with parameters, or the object that is it
  SharedText image;               ///< texture_image: a PNG in base64; wins over `texture`
  SharedText mask;                ///< mask_image: likewise, over the map's box
  double width_mm = 20;           ///< of an image
  double height_mm = 0.5;         ///< of an image's white
  std::string pitch;              ///< X,Y: of an object's repetitions; empty: its box
  std::string anchor;             ///< X,Y,Z; empty: the map's middle
  std::string orient;             ///< X,Y,Z; empty: the map's x
  double turn_deg = 0;
  double scale = 1;
  bool once = false;
  double margin_mm = 0;
  bool engraved = false;
  bool outside = false;

  friend bool operator==(const TextureSettings&, const TextureSettings&) = default;
};

/// Layers and the lines in them.
struct EngraveLineSettings {
  double layer_height_mm = 0.05;
  std::string spacing = "0.1";  ///< of the first layer, the next one, ...; over again
  std::string angle = "0";      ///< likewise, in degrees
  bool equidistant = false;
  NormalKind normals = NormalKind::kFaces;
  bool connect = true;
  double clearance_mm = 0;
  double shortest_mm = 0;
  bool seam = true;  ///< a surface that is no disk is cut open; else it is refused

  friend bool operator==(const EngraveLineSettings&, const EngraveLineSettings&) = default;
};

/// The machine.
struct EngraveMachineSettings {
  AxisLayout axes = AxisLayout::kTableBc;
  ToolKind tool = ToolKind::kBeam;
  std::string centre;  ///< X,Y,Z: where a table's axes meet; empty: the origin
  double pivot_mm = 100;
  double tilt_deg = 110;
  double steepest_deg = 60;
  double power = 1000;
  double feed_mm_min = 1200;
  double link_mm_min = 6000;
  double turn_deg_min = 7200;

  friend bool operator==(const EngraveMachineSettings&, const EngraveMachineSettings&) = default;
};

/// What engraving a job is made with.
struct EngraveSettings {
  static constexpr Process kProcess = Process::kEngrave;

  TextureSettings texture;
  EngraveLineSettings lines;
  EngraveMachineSettings machine;
  EngraveFormat format = EngraveFormat::kCsv;
  double displaced_edge_mm = 0.2;  ///< longest edge of a surface with the texture in it

  friend bool operator==(const EngraveSettings&, const EngraveSettings&) = default;
};

/// Returns the settings of a job (JobSettings, JobRows), which has none by object or region.
/// REQUIRES: the job is of that process.
template <typename Job>
auto& EngraveOf(Job& job) {
  return job.own.template As<EngraveSettings>();
}

/// Numbers between commas. `count`: how many there must be; 0: one at least, and no more than 1000.
/// Nothing for an empty text. Errors: SETTING_MALFORMED naming `setting`.
absl::StatusOr<std::vector<double>> NumbersOf(std::string_view setting, std::string_view text,
                                              size_t count);

/// Whether all texts of numbers, and images, can be read. Errors: SETTING_MALFORMED naming the
/// setting.
absl::Status CheckTexts(const EngraveSettings& settings);

/// The bytes of an image. Errors: SETTING_MALFORMED for what is no base64.
absl::StatusOr<std::string> ImageBytes(std::string_view setting, std::string_view base64);

}  // namespace slicefarm
