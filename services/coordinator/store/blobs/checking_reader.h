#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/store/blobs/blob_store.h"

namespace slicefarm::coordinator {

/// Opens a blob that is read once from beginning to end. The content is checked against its name
/// during the reads, whereas BlobStore::Open first reads the whole blob. If the blob is damaged,
/// the read that reaches its end returns BLOB_DIGEST_MISMATCH (DATA_LOSS) and puts the blob aside.
/// Reads in any other order return unchecked bytes. Errors: errors of BlobStore::OpenUnchecked.
absl::StatusOr<std::unique_ptr<BlobReader>> OpenToStream(std::shared_ptr<BlobStore> store,
                                                         const std::string& digest);

}  // namespace slicefarm::coordinator
