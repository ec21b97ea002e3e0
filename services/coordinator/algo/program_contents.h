#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/gcode/binary/binary_gcode_reader.h"

namespace slicefarm::coordinator {

/// Layer of a program: position in the file, height and number of moves.
struct ProgramLayer {
  /// Byte offset of the layer's first byte. In binary G-code: offset of the block with this byte.
  int64_t offset = 0;
  double z_mm = 0;
  double height_mm = 0;
  int64_t moves = 0;  ///< number of G0 to G3 commands

  friend bool operator==(const ProgramLayer&, const ProgramLayer&) = default;
};

/// Finds the layers of a program that arrives in pieces. Uses the comments that previewers read:
/// `;LAYER_CHANGE`, `;Z:` and `;HEIGHT:`. Reads binary G-code, too; if it is damaged, finds no
/// layers. Cost: O(bytes); stores at most a line of 256 bytes, or a block of binary G-code.
class LayerScan {
 public:
  /// Scans the next piece of the program.
  void Add(std::string_view bytes);
  /// Returns the layers in their order in the program. Empty if the program has no layer comments.
  std::vector<ProgramLayer> Layers() &&;

 private:
  void AddText(std::string_view bytes);
  void Line(std::string_view line, int64_t offset);
  absl::Status TakeBlock(const gcode::BinaryBlock& block);

  bool begun_ = false;
  std::optional<gcode::BinaryGcodeReader> binary_;
  absl::Status read_;  ///< first error of reading binary G-code
  /// Offset of the binary block that is being read; -1 if the program is text.
  int64_t block_at_ = -1;
  int64_t offset_ = 0;  ///< offset of the next byte
  int64_t line_at_ = 0;
  std::string line_;  ///< beginning of the current line, if the line is incomplete
  std::vector<ProgramLayer> layers_;
};

/// Returns the layers as JSON. `times_s`: one time per layer, or empty.
std::string LayersJson(const std::vector<ProgramLayer>& layers, const std::vector<double>& times_s);

/// Returns the bytes of the largest PNG thumbnail at the beginning of a program: text, binary
/// G-code or a .gcode.3mf archive.
std::optional<std::string> LargestThumbnail(std::string_view beginning);

/// Returns the time of each layer from the key `times`.`layers_s` of a report; empty if the report
/// has none.
std::vector<double> LayerTimesOf(const std::string& report);

/// Returns the file name of a program: the name in its report, or else the job's id with ".gcode".
std::string ProgramName(const std::string& report, const std::string& job_id);

/// Returns the media type for the extension of a file name.
std::string_view MediaTypeOf(std::string_view file_name);

}  // namespace slicefarm::coordinator
