#pragma once

#include <ctime>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace slicefarm::rpc {

/// Where a program finds what it needs for TLS, as PEM files. Without `ca` it uses none.
struct TlsFiles {
  std::string cert;  ///< of the program itself, followed by those that lead from it to a CA
  std::string key;   ///< of `cert`; not encrypted
  std::string ca;    ///< the CAs whose signatures count

  bool enabled() const { return !ca.empty(); }
  bool has_certificate() const { return !cert.empty(); }
};

/// Looks whether the files can be used now, because gRPC itself takes any and only fails to
/// connect. Errors, naming the file: REQUEST_MALFORMED if one cannot be read or the key is not the
/// certificate's; UNAUTHENTICATED if the certificate is not valid yet, or not any more.
absl::Status CheckTlsFiles(const TlsFiles& files);

/// When the certificate expires. Errors: REQUEST_MALFORMED as above.
/// REQUIRES: files.has_certificate().
absl::StatusOr<std::time_t> CertificateExpiry(const TlsFiles& files);

}  // namespace slicefarm::rpc
