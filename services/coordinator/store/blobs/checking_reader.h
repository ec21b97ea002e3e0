#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/store/blobs/blob_store.h"

namespace slicefarm::coordinator {

/// Opens a blob to be read once, from its beginning to its end: it is checked against its name
/// while it is read, where BlobStore::Open would read all of it before. The read that reaches the
/// end of a damaged blob is an error, BLOB_DIGEST_MISMATCH (DATA_LOSS), and puts the blob aside.
/// Who reads in another order gets bytes that nobody checked. Errors: those of
/// BlobStore::OpenUnchecked.
absl::StatusOr<std::unique_ptr<BlobReader>> OpenToStream(std::shared_ptr<BlobStore> store,
                                                         const std::string& digest);

}  // namespace slicefarm::coordinator
