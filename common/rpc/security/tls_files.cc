#include "common/rpc/security/tls_files.h"

#include <fmt/core.h>
#include <openssl/bio.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "common/base/error.h"

namespace slicefarm::rpc {
namespace {

using File = std::unique_ptr<BIO, decltype(&BIO_free_all)>;
using Certificate = std::unique_ptr<X509, decltype(&X509_free)>;
using Key = std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)>;

absl::Status BadFile(const std::string& path, std::string_view why) {
  ERR_clear_error();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("{} {}", path, why), {{"file", path}});
}

/// Password callback that supplies no password, so that encrypted keys fail instead of prompting.
int NoPassword(char*, int, int, void*) { return 0; }

absl::StatusOr<File> Open(const std::string& path) {
  File file(BIO_new_file(path.c_str(), "r"), &BIO_free_all);
  if (file == nullptr) return BadFile(path, "cannot be read");
  return file;
}

absl::StatusOr<Certificate> ReadCertificate(const std::string& path) {
  const auto file = Open(path);
  if (!file.ok()) return file.status();
  Certificate certificate(PEM_read_bio_X509(file->get(), nullptr, &NoPassword, nullptr),
                          &X509_free);
  if (certificate == nullptr) return BadFile(path, "contains no PEM certificate");
  return certificate;
}

absl::StatusOr<Key> ReadKey(const std::string& path) {
  const auto file = Open(path);
  if (!file.ok()) return file.status();
  Key key(PEM_read_bio_PrivateKey(file->get(), nullptr, &NoPassword, nullptr), &EVP_PKEY_free);
  if (key == nullptr) return BadFile(path, "contains no PEM private key without a password");
  return key;
}

std::string TimeText(const ASN1_TIME* time) {
  const File text(BIO_new(BIO_s_mem()), &BIO_free_all);
  ASN1_TIME_print(text.get(), time);
  char* data = nullptr;
  const long size = BIO_get_mem_data(text.get(), &data);
  return {data, static_cast<size_t>(size)};
}

absl::Status CheckTimes(const std::string& path, X509* certificate) {
  const auto invalid = [&](std::string_view what, const ASN1_TIME* time) {
    return MakeError(absl::StatusCode::kUnauthenticated, Reason::kUnauthenticated,
                     fmt::format("the certificate {} {} {}", path, what, TimeText(time)),
                     {{"file", path}});
  };
  const ASN1_TIME* from = X509_get0_notBefore(certificate);
  const ASN1_TIME* until = X509_get0_notAfter(certificate);
  if (X509_cmp_current_time(from) > 0) return invalid("is not valid before", from);
  if (X509_cmp_current_time(until) < 0) return invalid("expired on", until);
  return absl::OkStatus();
}

/// Returns the certificate, if it and its key can be read and match.
absl::StatusOr<Certificate> ReadPair(const TlsFiles& files) {
  auto certificate = ReadCertificate(files.cert);
  if (!certificate.ok()) return certificate;
  const auto key = ReadKey(files.key);
  if (!key.ok()) return key.status();
  if (X509_check_private_key(certificate->get(), key->get()) != 1) {
    return BadFile(files.key, "is not the key of " + files.cert);
  }
  return certificate;
}

}  // namespace

absl::Status CheckTlsFiles(const TlsFiles& files) {
  if (const auto ca = ReadCertificate(files.ca); !ca.ok()) return ca.status();
  if (!files.has_certificate()) return absl::OkStatus();
  const auto certificate = ReadPair(files);
  if (!certificate.ok()) return certificate.status();
  return CheckTimes(files.cert, certificate->get());
}

absl::StatusOr<std::time_t> CertificateExpiry(const TlsFiles& files) {
  const auto certificate = ReadPair(files);
  if (!certificate.ok()) return certificate.status();
  std::tm until = {};
  if (ASN1_TIME_to_tm(X509_get0_notAfter(certificate->get()), &until) != 1) {
    return BadFile(files.cert, "has no expiry time");
  }
  return timegm(&until);
}

}  // namespace slicefarm::rpc
