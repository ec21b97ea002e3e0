#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/slicing/sandbox/fd.h"
#include "services/slicing/sandbox/reader_protocol.h"

namespace slicefarm::slicing {

/// Returns the request as an in-memory file that is sealed against changes. Errors: Unavailable if
/// the system provides no memory; Cancelled.
absl::StatusOr<Fd> MakeRequestFile(const RequestHead& head, std::string_view bytes,
                                   const CancelToken& cancel);

}  // namespace slicefarm::slicing
