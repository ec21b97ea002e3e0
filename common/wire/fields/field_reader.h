#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "common/base/shared/shared_text.h"
#include "common/geometry/point.h"
#include "common/model/options/cutter.h"

namespace slicefarm::internal {

/// Reads values from the bytes of a FieldWriter. After the first error, the functions read no bytes
/// and change no values.
class FieldReader {
 public:
  explicit FieldReader(std::string_view bytes) : left_(bytes) {}

  bool ok() const { return fault_.ok(); }

  void Read(double* value);
  void Read(bool* value) { *value = Index(2) == 1; }
  template <std::signed_integral Number>
  void Read(Number* value) {
    *value = static_cast<Number>(Integer(std::numeric_limits<Number>::max()));
  }
  /// Reads a point. A coordinate beyond limits::kMaxCoord is an error.
  void Read(Point* point);
  void Read(std::string* text);
  void Read(SharedText* text);
  void Read(Cutter* cutter);

  /// Reads a number from 0 to count - 1, such as the value of an enumerator.
  int64_t Index(int64_t count);
  /// Reads the length of a list. Each item needs at least one byte, so the length is at most the
  /// number of remaining bytes.
  int64_t Count() { return Index(static_cast<int64_t>(left_.size()) + 1); }

  /// Returns the first error. If there is none, returns REQUEST_MALFORMED if bytes remain,
  /// otherwise OK.
  absl::Status Finish();

 private:
  int64_t Integer(int64_t most);
  bool Take(size_t size, std::string_view* bytes);
  void Fail(std::string_view what);

  std::string_view left_;
  int64_t fields_ = 0;  ///< number of values read so far, for error messages
  std::vector<SharedText> texts_;
  absl::Status fault_;
};

}  // namespace slicefarm::internal
