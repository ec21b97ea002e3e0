#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/shared/shared.h"

namespace slicefarm {

/// Text that many objects share. The text never changes. Copies of this object are cheap references
/// to the same text, and their comparison takes constant time.
class SharedText {
 public:
  SharedText() : SharedText(Empty()) {}
  SharedText(std::string text)  // NOLINT(google-explicit-constructor): as texts are given
      : text_(text.empty() ? Empty().text_ : Shared<std::string>(std::move(text))) {}
  SharedText(std::string_view text) : SharedText(std::string(text)) {}  // NOLINT: the same
  SharedText(const char* text) : SharedText(std::string(text)) {}       // NOLINT: the same

  const std::string& str() const { return *text_; }
  operator std::string_view() const { return *text_; }  // NOLINT: as texts are taken

  bool empty() const { return text_->empty(); }
  size_t size() const { return text_->size(); }
  void clear() { *this = {}; }

  /// Returns the result of `make(const std::string&)`, which is computed once for all copies: see
  /// Shared::Once.
  template <typename Make>
  const auto& Once(const Make& make) const {
    return text_.Once(make);
  }

  friend bool operator==(const SharedText& a, const SharedText& b) {
    return &a.str() == &b.str() || a.str() == b.str();
  }

 private:
  static const SharedText& Empty() {
    static const SharedText empty{Shared<std::string>()};
    return empty;
  }
  explicit SharedText(Shared<std::string> text) : text_(std::move(text)) {}

  Shared<std::string> text_;
};

}  // namespace slicefarm
