#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/store/blobs/blob_store.h"

namespace slicefarm::coordinator {

/// Opens a blob that is read once from beginning to end. The reads check the content against the
/// blob's name, whereas BlobStore::Open first reads the whole blob. If the blob is damaged, the
/// read of its last bytes returns BLOB_DIGEST_MISMATCH (DATA_LOSS) and puts the blob aside. If the
/// reads are not in order, their bytes are unchecked. Errors: see BlobStore::OpenUnchecked.
absl::StatusOr<std::unique_ptr<BlobReader>> OpenToStream(std::shared_ptr<BlobStore> store,
                                                         const std::string& digest);

}  // namespace slicefarm::coordinator
