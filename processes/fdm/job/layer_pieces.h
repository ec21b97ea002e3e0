#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/model/layers/layer.h"

namespace slicefarm::coordinator {

/// A piece of a layer's text in the file: bytes [first, last) of its program, then a text.
struct LayerPiece {
  int64_t first = 0;
  int64_t last = 0;
  std::string text = {};

  friend bool operator==(const LayerPiece&, const LayerPiece&) = default;
};

/// Takes the programs of layers in the order of the file, and leaves out their lines that set what
/// is set already (LayerProgram::mode_lines): a program alone cannot know.
class LayerJoin {
 public:
  /// Other G-code comes next. What it may change is told anew.
  void Pass(std::string_view gcode);

  /// Returns what stands in the file of a program of `size` bytes: `code` at its code_at.
  std::vector<LayerPiece> PiecesOf(const LayerProgram& program, int64_t size,
                                   std::span<std::string> code);

 private:
  ModeValues set_;         ///< empty values: not known
  bool retracted_ = true;  ///< the filament, whatever other G-code does
};

}  // namespace slicefarm::coordinator
