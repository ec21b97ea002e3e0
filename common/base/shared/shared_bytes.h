#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace slicefarm {

/// A shared value as it travels.
struct SharedBytes {
  std::string kind;    ///< how the bytes are to be read
  std::string digest;  ///< of both: 64 hex digits
  std::string bytes;
};

/// Values that a call names by their digests.
using SharedParts = std::vector<std::shared_ptr<const SharedBytes>>;  // with what they were made of

/// SHA-256 of the kind, a zero byte and the bytes: equal bytes of two kinds are two values.
std::string SharedDigest(std::string_view kind, std::string_view bytes);

}  // namespace slicefarm
