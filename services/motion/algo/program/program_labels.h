#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace slicefarm::motion {

/// Reads the current feature and layer from a slicer's comments. Features: `;TYPE:` of PrusaSlicer,
/// Cura and slicefarm, `; FEATURE:` of Bambu Studio, `;FEATURE:`. Layers: `;LAYER_CHANGE`,
/// `;LAYER:3`, `; CHANGE_LAYER`.
class ProgramLabels {
 public:
  /// Reads a comment, without its `;`. Returns true if it was a label.
  bool Read(std::string_view comment);

  const std::string& feature() const { return feature_; }
  /// Returns the layer, from 0; -1 before the first one.
  int layer() const { return layer_; }
  /// Returns true if the current code is custom G-code: code under `;TYPE:Custom`, or code without
  /// a label before the first layer.
  bool Custom() const { return custom_; }

 private:
  std::string feature_ = "None";
  int layer_ = -1;
  bool custom_ = true;
};

/// Returns the value in a comment `; key = value`. PrusaSlicer and its forks write settings and
/// sums in this form. Returns nothing if the comment has another key.
std::optional<std::string_view> QuotedValue(std::string_view comment, std::string_view key);

}  // namespace slicefarm::motion
