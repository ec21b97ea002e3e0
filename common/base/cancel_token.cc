#include "common/base/cancel_token.h"

#include "common/base/error.h"

namespace slicefarm {

absl::Status CancelToken::Check() const {
  if (!Cancelled()) return absl::OkStatus();
  return MakeError(absl::StatusCode::kCancelled, Reason::kCancelled, "cancelled");
}

}  // namespace slicefarm
