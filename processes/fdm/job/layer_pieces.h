#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/model/layers/layer.h"

namespace slicefarm::coordinator {

/// A piece of a layer's text in the file: bytes [first, last) of its program, followed by `text`.
struct LayerPiece {
  int64_t first = 0;
  int64_t last = 0;
  std::string text = {};

  friend bool operator==(const LayerPiece&, const LayerPiece&) = default;
};

/// Joins the programs of layers in file order. It omits lines that set a mode to its current value
/// (LayerProgram::mode_lines). The program of one layer cannot omit these lines, because its writer
/// does not know the modes at the end of the layer before.
class LayerJoin {
 public:
  /// Processes other G-code between layers. Modes that this G-code may change are written again
  /// afterwards.
  void Pass(std::string_view gcode);

  /// Returns the pieces of a program of `size` bytes, with the texts `code` inserted at
  /// LayerProgram::code_at.
  std::vector<LayerPiece> PiecesOf(const LayerProgram& program, int64_t size,
                                   std::span<std::string> code);

 private:
  ModeValues set_;         ///< current modes; an empty value is unknown
  bool retracted_ = true;  ///< true if the filament is retracted; other G-code does not change this
};

}  // namespace slicefarm::coordinator
