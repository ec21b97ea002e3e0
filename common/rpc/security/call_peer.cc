#include "common/rpc/security/call_peer.h"

#include <grpc/grpc_security_constants.h>
#include <openssl/bio.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <charconv>
#include <memory>
#include <vector>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/rpc/security/identity.h"

namespace slicefarm::rpc {
namespace {

using X509Pointer = std::unique_ptr<X509, decltype(&X509_free)>;

/// Decodes %XX; invalid codes remain unchanged.
std::string Unescaped(const std::string& text) {
  std::string plain;
  for (size_t i = 0; i < text.size(); ++i) {
    unsigned char byte = 0;
    const char* digits = text.data() + i + 1;
    const bool code = text[i] == '%' && i + 2 < text.size() &&
                      std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    plain += code ? static_cast<char>(byte) : text[i];
    if (code) i += 2;
  }
  return plain;
}

X509Pointer ReadPem(const std::string& pem) {
  const std::unique_ptr<BIO, decltype(&BIO_free)> bytes(
      BIO_new_mem_buf(pem.data(), static_cast<int>(pem.size())), BIO_free);
  return {PEM_read_bio_X509(bytes.get(), nullptr, nullptr, nullptr), X509_free};
}

std::vector<std::string> UrisOf(const X509& certificate) {
  std::vector<std::string> uris;
  const std::unique_ptr<GENERAL_NAMES, decltype(&GENERAL_NAMES_free)> names(
      static_cast<GENERAL_NAMES*>(
          X509_get_ext_d2i(&certificate, NID_subject_alt_name, nullptr, nullptr)),
      GENERAL_NAMES_free);
  for (int i = 0; names && i < sk_GENERAL_NAME_num(names.get()); ++i) {
    const GENERAL_NAME& name = *sk_GENERAL_NAME_value(names.get(), i);
    if (name.type != GEN_URI) continue;
    const ASN1_IA5STRING& uri = *name.d.uniformResourceIdentifier;
    uris.emplace_back(reinterpret_cast<const char*>(ASN1_STRING_get0_data(&uri)),
                      static_cast<size_t>(ASN1_STRING_length(&uri)));
  }
  return uris;
}

std::optional<CallPeer> PeerOf(const X509& certificate) {
  unsigned char* der = nullptr;
  const int size = i2d_X509(&certificate, &der);
  if (size <= 0) return std::nullopt;
  CallPeer peer{.certified = true};
  peer.fingerprint =
      Sha256Hex(std::string_view(reinterpret_cast<const char*>(der), static_cast<size_t>(size)));
  OPENSSL_free(der);
  const std::vector<std::string> uris = UrisOf(certificate);
  if (uris.size() == 1) peer.identity = uris.front();
  return peer;
}

/// Returns the only value of a key of the call's metadata; nullopt if there is none, or several.
std::optional<std::string> Metadata(const grpc::ServerContextBase& context, const char* key) {
  const auto [begin, end] = context.client_metadata().equal_range(key);
  if (begin == end || std::next(begin) != end) return std::nullopt;
  return std::string(begin->second.data(), begin->second.size());
}

/// Returns the peer of the connection itself.
CallPeer DirectPeer(const grpc::ServerContextBase& context) {
  const auto auth = context.auth_context();
  CallPeer peer;
  const auto pem = auth->FindPropertyValues(GRPC_X509_PEM_CERT_PROPERTY_NAME);
  if (pem.size() == 1) {
    const X509Pointer certificate = ReadPem(std::string(pem[0].data(), pem[0].size()));
    if (certificate) peer = PeerOf(*certificate).value_or(CallPeer{});
  }
  peer.identity = PeerIdentity(*auth);
  peer.certified = auth->IsPeerAuthenticated();
  peer.address = context.peer();
  return peer;
}

}  // namespace

std::optional<CallPeer> PeerOfCertificate(const std::string& escaped_pem) {
  const X509Pointer certificate = ReadPem(Unescaped(escaped_pem));
  return certificate ? PeerOf(*certificate) : std::nullopt;
}

absl::StatusOr<CallPeer> PeerOf(const grpc::ServerContextBase& context) {
  const auto& metadata = context.client_metadata();
  const bool named = metadata.count(kProxiedCertificate) + metadata.count(kProxiedAddress) > 0;
  CallPeer direct = DirectPeer(context);
  if (direct.identity != kProxyIdentity) {
    if (!named) return direct;
    return MakeError(absl::StatusCode::kPermissionDenied, Reason::kPermissionDenied,
                     std::string(kProxiedCertificate) + " and " + kProxiedAddress +
                         " may be sent only by the farm's proxy");
  }
  CallPeer client{.address = Metadata(context, kProxiedAddress).value_or(direct.address)};
  if (metadata.count(kProxiedCertificate) == 0) return client;
  const auto certificate = PeerOfCertificate(Metadata(context, kProxiedCertificate).value_or(""));
  if (!certificate) {
    return MakeError(absl::StatusCode::kUnauthenticated, Reason::kUnauthenticated,
                     "the client's certificate cannot be read");
  }
  const std::string address = client.address;
  client = *certificate;
  client.address = address;
  return client;
}

}  // namespace slicefarm::rpc
