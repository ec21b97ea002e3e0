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
  /// Writes a shared text. Only its first occurrence contains the text; later occurrences contain
  /// its number.
  void Write(const SharedText& text);
  void Write(const Cutter& cutter);

  std::string Finish() && { return std::move(bytes_); }

 private:
  void WriteInteger(int64_t value);

  std::string bytes_;
  std::map<std::string_view, int64_t> texts_;  ///< number of each shared text, from 1
};

}  // namespace slicefarm::internal
