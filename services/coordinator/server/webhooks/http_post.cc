#include "services/coordinator/server/webhooks/http_post.h"

#include <curl/curl.h>
#include <fmt/core.h>
#include <sys/socket.h>

#include <array>
#include <memory>

#include "services/coordinator/server/webhooks/public_address.h"

namespace slicefarm::coordinator {
namespace {

/// More of an answer than this ends the call: nobody reads it.
constexpr size_t kMaxAnswerBytes = 64 << 10;

struct Reached {
  bool private_addresses = false;
  bool refused = false;
};

curl_socket_t OpenSocket(void* user, curlsocktype, curl_sockaddr* address) {
  auto* reached = static_cast<Reached*>(user);
  if (!reached->private_addresses && !IsPublicAddress(address->addr)) {
    reached->refused = true;
    return CURL_SOCKET_BAD;
  }
  return socket(address->family, address->socktype | SOCK_CLOEXEC, address->protocol);
}

size_t ThrowAway(char*, size_t size, size_t count, void* user) {
  auto* taken = static_cast<size_t*>(user);
  *taken += size * count;
  return *taken > kMaxAnswerBytes ? 0 : size * count;
}

using Handle = std::unique_ptr<CURL, decltype(&curl_easy_cleanup)>;
using HeaderList = std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)>;

HeaderList HeadersOf(const HttpPostOptions& options) {
  curl_slist* list = curl_slist_append(nullptr, "Content-Type: application/json");
  for (const std::string& header : options.headers) list = curl_slist_append(list, header.c_str());
  return {list, &curl_slist_free_all};
}

void SetRules(CURL* curl, const HttpPostOptions& options) {
  curl_easy_setopt(curl, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(curl, CURLOPT_FOLLOWLOCATION, 0L);
  curl_easy_setopt(curl, CURLOPT_PROXY, "");
  curl_easy_setopt(curl, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl, CURLOPT_USERAGENT, "slicefarm");
  curl_easy_setopt(curl, CURLOPT_TIMEOUT_MS, static_cast<long>(options.timeout.count()));
}

}  // namespace

absl::StatusOr<int> HttpPost(const std::string& url, const std::string& body,
                             const HttpPostOptions& options) {
  static const CURLcode initialised = curl_global_init(CURL_GLOBAL_DEFAULT);
  const Handle curl(curl_easy_init(), &curl_easy_cleanup);
  if (initialised != CURLE_OK || curl == nullptr) return absl::UnavailableError("no HTTP client");
  const HeaderList headers = HeadersOf(options);
  Reached reached{options.private_addresses, false};
  size_t taken = 0;
  std::array<char, CURL_ERROR_SIZE> error = {};
  SetRules(curl.get(), options);
  curl_easy_setopt(curl.get(), CURLOPT_URL, url.c_str());
  curl_easy_setopt(curl.get(), CURLOPT_HTTPHEADER, headers.get());
  curl_easy_setopt(curl.get(), CURLOPT_POSTFIELDSIZE, static_cast<long>(body.size()));
  curl_easy_setopt(curl.get(), CURLOPT_POSTFIELDS, body.data());
  curl_easy_setopt(curl.get(), CURLOPT_OPENSOCKETFUNCTION, &OpenSocket);
  curl_easy_setopt(curl.get(), CURLOPT_OPENSOCKETDATA, &reached);
  curl_easy_setopt(curl.get(), CURLOPT_WRITEFUNCTION, &ThrowAway);
  curl_easy_setopt(curl.get(), CURLOPT_WRITEDATA, &taken);
  curl_easy_setopt(curl.get(), CURLOPT_ERRORBUFFER, error.data());
  const CURLcode code = curl_easy_perform(curl.get());
  if (reached.refused) {
    return absl::PermissionDeniedError("the address is not one of the public Internet");
  }
  long status = 0;
  curl_easy_getinfo(curl.get(), CURLINFO_RESPONSE_CODE, &status);
  if (code == CURLE_OK || (code == CURLE_WRITE_ERROR && status > 0))
    return static_cast<int>(status);
  return absl::UnavailableError(error[0] == '\0' ? curl_easy_strerror(code) : error.data());
}

}  // namespace slicefarm::coordinator
