#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace slicefarm::motion {

/// What a slicer's comments say of where a program is: the feature (`;TYPE:` of PrusaSlicer, Cura
/// and us, `; FEATURE:` of Bambu Studio, `;FEATURE:`) and the layer (`;LAYER_CHANGE`, `;LAYER:3`,
/// `; CHANGE_LAYER`).
class ProgramLabels {
 public:
  /// `comment`: what stands behind `;`. Whether it changed something.
  bool Read(std::string_view comment);

  const std::string& feature() const { return feature_; }
  /// From 0; -1 before the first.
  int layer() const { return layer_; }
  /// Whether what is printed is the user's own code: `;TYPE:Custom`, and what no comment names
  /// before the first layer.
  bool Custom() const { return custom_; }

 private:
  std::string feature_ = "None";
  int layer_ = -1;
  bool custom_ = true;
};

/// The value of `; key = value`, as PrusaSlicer and its heirs quote settings and sums; nothing if
/// the comment does not say that key.
std::optional<std::string_view> QuotedValue(std::string_view comment, std::string_view key);

}  // namespace slicefarm::motion
