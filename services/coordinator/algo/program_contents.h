#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/gcode/binary/binary_gcode_reader.h"

namespace slicefarm::coordinator {

/// Where a layer is in a program.
struct LayerPlace {
  int64_t offset = 0;  ///< of its first byte; in binary G-code, of the block that it begins in
  double z_mm = 0;
  double height_mm = 0;
  int64_t moves = 0;  ///< G0 to G3

  friend bool operator==(const LayerPlace&, const LayerPlace&) = default;
};

/// Finds the layers of a program that comes in pieces, by the comments that previewers read:
/// `;LAYER_CHANGE`, `;Z:` and `;HEIGHT:`. Reads binary G-code, too; of one that is broken it finds
/// no layer. Cost: O(bytes); holds a line of 256 bytes at most, or a block of binary G-code.
class LayerScan {
 public:
  void Add(std::string_view bytes);
  /// In their order; none: the program tells of no layers.
  std::vector<LayerPlace> Layers() &&;

 private:
  void AddText(std::string_view bytes);
  void Line(std::string_view line, int64_t offset);
  absl::Status TakeBlock(const gcode::BinaryBlock& block);

  bool begun_ = false;
  std::optional<gcode::BinaryGcodeReader> binary_;
  absl::Status read_;      ///< of binary G-code
  int64_t block_at_ = -1;  ///< of the block whose lines come; -1: the program is text
  int64_t offset_ = 0;  ///< of what comes next
  int64_t line_at_ = 0;
  std::string line_;  ///< its beginning, if it is not at its end
  std::vector<LayerPlace> layers_;
};

/// JSON of layers; `times_s`: of each, or of none.
std::string LayersJson(const std::vector<LayerPlace>& layers, const std::vector<double>& times_s);

/// The largest PNG among the thumbnails at a program's beginning, text or binary G-code, as its
/// bytes.
std::optional<std::string> LargestThumbnail(std::string_view beginning);

/// `layers_s` of a report's `times`; none if it has none.
std::vector<double> LayerTimesOf(const std::string& report);

/// What a program is called: by its report, or else by the job's id.
std::string ProgramName(const std::string& report, const std::string& job_id);

/// By the ending of a file's name.
std::string_view MediaTypeOf(std::string_view file_name);

}  // namespace slicefarm::coordinator
