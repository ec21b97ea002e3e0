#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace slicefarm {

/// Serialized value that several calls refer to by its digest.
struct SharedBytes {
  std::string kind;    ///< name of the message type of `bytes`
  std::string digest;  ///< digest of kind and bytes: 64 hex digits
  std::string bytes;
};

/// Serialized values to which one call refers by their digests.
using SharedParts = std::vector<std::shared_ptr<const SharedBytes>>;

/// Returns the SHA-256 of the kind, a zero byte and the bytes. Equal bytes of two kinds have
/// different digests.
std::string SharedDigest(std::string_view kind, std::string_view bytes);

}  // namespace slicefarm
