#pragma once

#include <optional>

namespace slicefarm::gcode {

/// A value that holds on, such as a feed rate: a program tells it where it changes.
template <typename T>
class Modal {
 public:
  Modal() = default;  ///< nothing is told
  explicit Modal(const T& told) : told_(told) {}

  /// Whether `value` is to be told now, as it is not the one that was told last.
  bool Changes(const T& value) {
    if (told_ == value) return false;
    told_ = value;
    return true;
  }
  bool Is(const T& value) const { return told_ == value; }

  /// The next one is told whatever it is.
  void Forget() { told_.reset(); }

 private:
  std::optional<T> told_;
};

}  // namespace slicefarm::gcode
