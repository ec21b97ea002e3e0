#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace slicefarm {

/// SHA-256 of bytes that come in pieces. Contents are named by it. Source: FIPS 180-4, by libcrypto.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void Add(std::string_view bytes);

  /// 64 lower-case hex digits. REQUIRES: called once, and nothing added afterwards.
  std::string Hex();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The digest of all of `bytes`.
std::string Sha256Hex(std::string_view bytes);

/// True for 64 lower-case hex digits: what may become part of a path.
bool IsSha256Hex(std::string_view text);

}  // namespace slicefarm
