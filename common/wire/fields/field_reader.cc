#include "common/wire/fields/field_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/model/options/cutter_text.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm::internal {

void FieldReader::Fail(std::string_view what) {
  if (fault_.ok()) fault_ = Malformed(fmt::format("value {}", fields_), what);
  left_ = {};
}

bool FieldReader::Take(size_t size, std::string_view* bytes) {
  if (!ok()) return false;
  ++fields_;
  if (left_.size() < size) {
    Fail("is cut off");
    return false;
  }
  *bytes = left_.substr(0, size);
  left_.remove_prefix(size);
  return true;
}

int64_t FieldReader::Integer(int64_t most) {
  std::string_view bytes;
  int64_t value = 0;
  if (!Take(sizeof value, &bytes)) return 0;
  std::memcpy(&value, bytes.data(), sizeof value);
  const int64_t limit = std::min<int64_t>(most, limits::kMaxPrintHeight);
  if (-limit <= value && value <= limit) return value;
  Fail("is out of range");
  return 0;
}

int64_t FieldReader::Index(int64_t count) {
  const int64_t index = Integer(limits::kMaxPrintHeight);
  if (0 <= index && index < count) return index;
  Fail("is not a value of this version");
  return 0;
}

void FieldReader::Read(double* value) {
  std::string_view bytes;
  double number = 0;
  if (!Take(sizeof number, &bytes)) return;
  std::memcpy(&number, bytes.data(), sizeof number);
  if (!std::isfinite(number)) return Fail("is not finite");
  *value = number;
}

void FieldReader::Read(Point* point) {
  for (Coord* c : {&point->x, &point->y}) *c = Integer(limits::kMaxCoord);
}

void FieldReader::Read(std::string* text) {
  const int64_t size = Count();
  if (size > limits::kMaxFieldBytes && ok()) {
    fault_ = LimitError(Reason::kRequestTooLarge, "bytes of a text", limits::kMaxFieldBytes, size);
    left_ = {};
  }
  std::string_view bytes;
  if (Take(static_cast<size_t>(size), &bytes)) *text = std::string(bytes);
}

void FieldReader::Read(SharedText* text) {
  const int64_t number = Index(std::ssize(texts_) + 2);
  if (!ok()) return;
  if (number == 0) return Fail("is no number of a text");
  if (number > std::ssize(texts_)) {
    std::string own;
    Read(&own);
    texts_.emplace_back(std::move(own));
  }
  if (ok()) *text = texts_[static_cast<size_t>(number - 1)];
}

void FieldReader::Read(Cutter* cutter) {
  std::string name;
  Read(&name);
  if (!ok()) return;
  absl::StatusOr<Cutter> parsed = ParseCutter(name);
  if (!parsed.ok()) return Fail("is no cutter");
  *cutter = *std::move(parsed);
}

absl::Status FieldReader::Finish() {
  if (ok() && !left_.empty()) Fail("is followed by bytes that are too many");
  return fault_;
}

}  // namespace slicefarm::internal
