#pragma once

#include <optional>

namespace slicefarm::gcode {

/// Value that a machine keeps until a command changes it, such as a feed rate. A program writes the
/// value only where it changes.
template <typename T>
class Modal {
 public:
  Modal() = default;  ///< no value was written yet
  explicit Modal(const T& written) : written_(written) {}

  /// Returns true if `value` must be written, because it differs from the last written value. Then
  /// stores `value` as the last written value.
  bool Changes(const T& value) {
    if (written_ == value) return false;
    written_ = value;
    return true;
  }
  bool Is(const T& value) const { return written_ == value; }

  /// Forces the next value to be written even if it is unchanged.
  void Forget() { written_.reset(); }

 private:
  std::optional<T> written_;
};

}  // namespace slicefarm::gcode
