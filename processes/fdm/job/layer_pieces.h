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
/// (LayerProgram::mode_lines). A single program cannot omit them, because it does not have the
/// modes of the layer before it.
class LayerJoin {
 public:
  /// Handles other G-code between layers. Modes that the G-code may change are written again
  /// afterwards.
  void Pass(std::string_view gcode);

  /// Returns the pieces of a program of `size` bytes, with the texts `code` inserted at its
  /// code_at.
  std::vector<LayerPiece> PiecesOf(const LayerProgram& program, int64_t size,
                                   std::span<std::string> code);

 private:
  ModeValues set_;         ///< current modes; an empty value is unknown
  bool retracted_ = true;  ///< state of the filament; other G-code does not change it
};

}  // namespace slicefarm::coordinator
