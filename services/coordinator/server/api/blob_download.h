#pragma once

#include <grpcpp/grpcpp.h>

#include <cstdint>
#include <string_view>

#include "absl/status/status.h"
#include "services/coordinator/server/api/transfers.h"
#include "services/coordinator/store/blobs/blob_store.h"
#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::coordinator {

/// Checks the requested part of a blob. Errors: REQUEST_MALFORMED for an `offset` outside the blob,
/// or a negative `limit`.
absl::Status CheckPart(const BlobReader& blob, int64_t offset, int64_t limit);

/// Sends bytes in chunks of 64 KiB. Calls `moved` for each chunk. Returns false if the client left.
bool SendBytes(std::string_view bytes, const Transfers::Moved& moved,
               grpc::ServerWriter<v1::DownloadResponse>& stream);

/// Sends a blob from `offset` on, at most `limit` bytes (0: all), in chunks of 64 KiB. Stops when
/// the client leaves. REQUIRES: CheckPart accepts `offset` and `limit`. Errors: see
/// BlobReader::Read.
absl::Status SendBlob(BlobReader& blob, int64_t offset, int64_t limit,
                      const Transfers::Moved& moved,
                      grpc::ServerWriter<v1::DownloadResponse>& stream);

}  // namespace slicefarm::coordinator
