#pragma once

#include <concepts>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/shared/shared_text.h"
#include "common/model/options/cutter.h"

namespace slicefarm::internal {

/// Appends values to a byte string: a number as eight bytes, a text as its length and its bytes.
class FieldWriter {
 public:
  void Write(double value);
  template <std::integral Number>
  void Write(Number value) {
    WriteInteger(static_cast<int64_t>(value));
  }
  void Write(const std::string& text);
  /// Writes a shared text. Its first occurrence is written as text, each later occurrence as the
  /// text's number.
  void Write(const SharedText& text);
  void Write(const Cutter& cutter);

  std::string Finish() && { return std::move(bytes_); }

 private:
  void WriteInteger(int64_t value);

  std::string bytes_;
  /// number of each shared text, in the order of first occurrence, from 1
  std::map<std::string_view, int64_t> texts_;
};

}  // namespace slicefarm::internal
