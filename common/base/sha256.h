#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace slicefarm {

/// Computes the SHA-256 of bytes that are added in pieces. Stored contents are named by this
/// digest. Source: FIPS 180-4, by libcrypto.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void Add(std::string_view bytes);

  /// Returns the digest as 64 lower-case hex digits. REQUIRES: called once; nothing is added
  /// afterwards.
  std::string Hex();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the digest of `bytes` as 64 hex digits.
std::string Sha256Hex(std::string_view bytes);

/// Returns true if the text has exactly 64 lower-case hex digits. It may then safely be part of a
/// path.
bool IsSha256Hex(std::string_view text);

}  // namespace slicefarm
