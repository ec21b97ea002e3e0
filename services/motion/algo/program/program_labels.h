#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace slicefarm::motion {

/// Reads from a slicer's comments the current feature (`;TYPE:` of PrusaSlicer, Cura and slicefarm,
/// `; FEATURE:` of Bambu Studio, `;FEATURE:`) and the layer (`;LAYER_CHANGE`, `;LAYER:3`, `;
/// CHANGE_LAYER`).
class ProgramLabels {
 public:
  /// Reads a comment, without its `;`. Returns true if it was a label.
  bool Read(std::string_view comment);

  const std::string& feature() const { return feature_; }
  /// Returns the layer, from 0; -1 before the first one.
  int layer() const { return layer_; }
  /// Returns true in the user's own code: under `;TYPE:Custom`, and in unlabelled code before the
  /// first layer.
  bool Custom() const { return custom_; }

 private:
  std::string feature_ = "None";
  int layer_ = -1;
  bool custom_ = true;
};

/// Returns the value of `; key = value`, the form of settings and sums in PrusaSlicer and its
/// forks. Returns nothing if the comment has another key.
std::optional<std::string_view> QuotedValue(std::string_view comment, std::string_view key);

}  // namespace slicefarm::motion
