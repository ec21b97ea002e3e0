#include "common/wire/support/object_names.h"

#include <iterator>

#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm {

absl::Status CheckObjectNames(const google::protobuf::RepeatedPtrField<std::string>& names) {
  if (names.size() > limits::kMaxObjects)
    return LimitError(Reason::kRequestTooLarge, "object_names", limits::kMaxObjects, names.size());
  for (const std::string& name : names)
    if (std::ssize(name) > limits::kMaxNameBytes)
      return LimitError(Reason::kRequestTooLarge, "bytes of object_names", limits::kMaxNameBytes,
                        std::ssize(name));
  return absl::OkStatus();
}

}  // namespace slicefarm
