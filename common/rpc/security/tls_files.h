#pragma once

#include <ctime>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

namespace slicefarm::rpc {

/// Paths of a program's PEM files for TLS. Without `ca`, the program uses no TLS.
struct TlsFiles {
  std::string cert;  ///< file with the program's certificate, followed by the chain up to a CA
  std::string key;   ///< file with the private key of `cert`; not encrypted
  std::string ca;    ///< file with the trusted CAs

  bool enabled() const { return !ca.empty(); }
  bool has_certificate() const { return !cert.empty(); }
};

/// Checks that the files can be used now. Without this check, wrong files would only make gRPC's
/// connections fail. Errors, with the file's name: REQUEST_MALFORMED if a file cannot be read or
/// the key does not match the certificate; UNAUTHENTICATED if the certificate is not yet valid or
/// has expired.
absl::Status CheckTlsFiles(const TlsFiles& files);

/// Returns the expiry time of the certificate. Errors: REQUEST_MALFORMED if the certificate cannot
/// be read. REQUIRES: files.has_certificate().
absl::StatusOr<std::time_t> CertificateExpiry(const TlsFiles& files);

}  // namespace slicefarm::rpc
