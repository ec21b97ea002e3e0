#pragma once

#include <ctime>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace slicefarm::rpc {

/// Paths of a program's PEM files for TLS. Without `ca`, the program uses no TLS.
struct TlsFiles {
  std::string cert;  ///< certificate of the program, followed by the chain to a CA
  std::string key;   ///< private key of `cert`; not encrypted
  std::string ca;    ///< trusted CAs

  bool enabled() const { return !ca.empty(); }
  bool has_certificate() const { return !cert.empty(); }
};

/// Checks that the files can be used now. gRPC itself does not check them; its connections would
/// only fail. Errors, with the file's name: REQUEST_MALFORMED if a file cannot be read or the key
/// does not match the certificate; UNAUTHENTICATED if the certificate is not yet valid or has
/// expired.
absl::Status CheckTlsFiles(const TlsFiles& files);

/// Returns the expiry time of the certificate. Errors: REQUEST_MALFORMED if the certificate cannot
/// be read. REQUIRES: files.has_certificate().
absl::StatusOr<std::time_t> CertificateExpiry(const TlsFiles& files);

}  // namespace slicefarm::rpc
