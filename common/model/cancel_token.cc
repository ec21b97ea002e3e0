#include "common/model/cancel_token.h"

#include "common/model/error.h"

namespace slicefarm {

absl::Status CancelToken::Check() const {
  if (!Cancelled()) return absl::OkStatus();
  return MakeError(absl::StatusCode::kCancelled, Reason::kCancelled, "cancelled");
}

}  // namespace slicefarm
