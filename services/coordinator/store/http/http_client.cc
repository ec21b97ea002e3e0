#include "services/coordinator/store/http/http_client.h"

#include <curl/curl.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <string_view>
#include <utility>

namespace slicefarm::coordinator {
namespace {

constexpr int64_t kBlockBytes = 1 << 20;  ///< bytes of a body that are read at a time
constexpr size_t kMostIdle = 64;
constexpr long kLeastBytesPerSecond = 1024;

/// Body of a request, read block by block.
struct Sending {
  const BodySource& body;
  int64_t next = 0;  ///< offset of the next block
  std::string block = {};
  size_t used = 0;  ///< bytes of the block that were sent
  absl::Status status = {};

  /// Reads the next block if the current one is used up. Returns false at the end of the body or
  /// after an error.
  bool Refill() {
    if (used < block.size()) return true;
    if (next == body.size) return false;
    auto read = body.read(next, std::min(kBlockBytes, body.size - next));
    status = read.ok() && read->empty() ? absl::DataLossError("a body ended early") : read.status();
    if (!status.ok()) return false;
    next += std::ssize(*read);
    block = *std::move(read);
    used = 0;
    return true;
  }
};

struct Receiving {
  std::string bytes;
  int64_t most = 0;
  bool is_cut = false;
};

/// Check of addresses, and whether an address was refused.
struct Reach {
  bool (*may_reach)(const sockaddr& address);
  bool refused = false;
};

size_t Send(char* to, size_t size, size_t count, void* user) {
  auto& sending = *static_cast<Sending*>(user);
  if (!sending.Refill()) return sending.status.ok() ? 0 : CURL_READFUNC_ABORT;
  const size_t taken = std::min(size * count, sending.block.size() - sending.used);
  std::memcpy(to, sending.block.data() + sending.used, taken);
  sending.used += taken;
  return taken;
}

/// Sets the position of the body. libcurl calls it to send the body again over another connection.
int Rewind(void* user, curl_off_t offset, int) {
  auto& sending = *static_cast<Sending*>(user);
  sending.next = offset;
  sending.block.clear();
  sending.used = 0;
  return CURL_SEEKFUNC_OK;
}

size_t Receive(char* from, size_t size, size_t count, void* user) {
  auto& receiving = *static_cast<Receiving*>(user);
  receiving.is_cut = std::ssize(receiving.bytes) + static_cast<int64_t>(count) > receiving.most;
  if (receiving.is_cut) return 0;
  receiving.bytes.append(from, size * count);
  return size * count;
}

curl_socket_t OpenSocket(void* user, curlsocktype, curl_sockaddr* address) {
  auto& reach = *static_cast<Reach*>(user);
  if (reach.may_reach != nullptr && !reach.may_reach(address->addr)) {
    reach.refused = true;
    return CURL_SOCKET_BAD;
  }
  return socket(address->family, address->socktype | SOCK_CLOEXEC, address->protocol);
}

/// Returns a value other than 0 if the transfer must end.
int GoOn(void* user, curl_off_t, curl_off_t, curl_off_t, curl_off_t) {
  return static_cast<const CancelToken*>(user)->Cancelled() ? 1 : 0;
}

using HeaderList = std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)>;

HeaderList ListOf(const std::vector<std::string>& headers) {
  curl_slist* list = nullptr;
  for (const std::string& header : headers) list = curl_slist_append(list, header.c_str());
  return {list, &curl_slist_free_all};
}

void SetRules(CURL* curl, const HttpClientOptions& options) {
  curl_easy_setopt(curl, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(curl, CURLOPT_HTTP_VERSION, static_cast<long>(CURL_HTTP_VERSION_1_1));
  curl_easy_setopt(curl, CURLOPT_FOLLOWLOCATION, 0L);
  curl_easy_setopt(curl, CURLOPT_PATH_AS_IS, 1L);
  curl_easy_setopt(curl, CURLOPT_PROXY, "");
  curl_easy_setopt(curl, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl, CURLOPT_USERAGENT, "slicefarm");
  curl_easy_setopt(curl, CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(options.connect.count()));
  curl_easy_setopt(curl, CURLOPT_TIMEOUT_MS, static_cast<long>(options.total.count()));
  curl_easy_setopt(curl, CURLOPT_LOW_SPEED_LIMIT, kLeastBytesPerSecond);
  curl_easy_setopt(curl, CURLOPT_LOW_SPEED_TIME, static_cast<long>(options.stall.count()));
  curl_easy_setopt(curl, CURLOPT_UPLOAD_BUFFERSIZE, 512L << 10);
  curl_easy_setopt(curl, CURLOPT_BUFFERSIZE, 256L << 10);
  if (!options.ca_file.empty()) curl_easy_setopt(curl, CURLOPT_CAINFO, options.ca_file.c_str());
}

void SetMethod(CURL* curl, const std::string& method, Sending& sending) {
  const auto size = static_cast<curl_off_t>(sending.body.size);
  if (method == "PUT") {
    curl_easy_setopt(curl, CURLOPT_UPLOAD, 1L);
    curl_easy_setopt(curl, CURLOPT_INFILESIZE_LARGE, size);
  } else if (method == "POST") {
    curl_easy_setopt(curl, CURLOPT_POST, 1L);
    curl_easy_setopt(curl, CURLOPT_POSTFIELDSIZE_LARGE, size);
  } else if (method == "HEAD") {
    curl_easy_setopt(curl, CURLOPT_NOBODY, 1L);
  } else if (method != "GET") {
    curl_easy_setopt(curl, CURLOPT_CUSTOMREQUEST, method.c_str());
  }
  curl_easy_setopt(curl, CURLOPT_READFUNCTION, &Send);
  curl_easy_setopt(curl, CURLOPT_READDATA, &sending);
  curl_easy_setopt(curl, CURLOPT_SEEKFUNCTION, &Rewind);
  curl_easy_setopt(curl, CURLOPT_SEEKDATA, &sending);
}

void SetSignature(CURL* curl, const AwsSignature& signature) {
  const std::string scope = fmt::format("aws:amz:{}:s3", signature.region);
  curl_easy_setopt(curl, CURLOPT_AWS_SIGV4, scope.c_str());
  curl_easy_setopt(curl, CURLOPT_USERNAME, signature.access_key.c_str());
  curl_easy_setopt(curl, CURLOPT_PASSWORD, signature.secret_key.c_str());
}

/// Sets the callbacks of a transfer. They write to `receiving` and `reach` until the transfer ends.
void SetCallbacks(CURL* curl, const CancelToken& cancel, Receiving& receiving, Reach& reach) {
  curl_easy_setopt(curl, CURLOPT_WRITEFUNCTION, &Receive);
  curl_easy_setopt(curl, CURLOPT_WRITEDATA, &receiving);
  curl_easy_setopt(curl, CURLOPT_OPENSOCKETFUNCTION, &OpenSocket);
  curl_easy_setopt(curl, CURLOPT_OPENSOCKETDATA, &reach);
  curl_easy_setopt(curl, CURLOPT_NOPROGRESS, 0L);
  curl_easy_setopt(curl, CURLOPT_XFERINFOFUNCTION, &GoOn);
  curl_easy_setopt(curl, CURLOPT_XFERINFODATA, &cancel);
}

HttpAnswer AnswerOf(CURL* curl, Receiving receiving) {
  long status = 0;
  curl_off_t length = 0;
  curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &status);
  curl_easy_getinfo(curl, CURLINFO_CONTENT_LENGTH_DOWNLOAD_T, &length);
  return {static_cast<int>(status), std::move(receiving.bytes), length, receiving.is_cut};
}

}  // namespace

HttpClient::~HttpClient() {
  for (void* handle : idle_) curl_easy_cleanup(static_cast<CURL*>(handle));
}

void* HttpClient::Take() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      void* const handle = idle_.back();
      idle_.pop_back();
      return handle;
    }
  }
  static const CURLcode initialised = curl_global_init(CURL_GLOBAL_DEFAULT);
  return initialised == CURLE_OK ? curl_easy_init() : nullptr;
}

void HttpClient::GiveBack(void* handle) {
  curl_easy_reset(static_cast<CURL*>(handle));  // the connections remain open
  {
    const std::lock_guard lock(mutex_);
    if (idle_.size() < kMostIdle) {
      idle_.push_back(handle);
      return;
    }
  }
  curl_easy_cleanup(static_cast<CURL*>(handle));
}

absl::StatusOr<HttpAnswer> HttpClient::Do(const HttpRequest& request) {
  const std::unique_ptr<void, std::function<void(void*)>> handle(
      Take(), [this](void* taken) { GiveBack(taken); });
  if (handle == nullptr) return absl::UnavailableError("no HTTP client");
  auto* const curl = static_cast<CURL*>(handle.get());
  static const BodySource kNoBody = {};
  Sending sending{request.body != nullptr ? *request.body : kNoBody};
  Receiving receiving{.bytes = {}, .most = request.most_bytes};
  Reach reach{options_.may_reach};
  const HeaderList headers = ListOf(request.headers);
  std::array<char, CURL_ERROR_SIZE> error = {};
  SetRules(curl, options_);
  SetMethod(curl, request.method, sending);
  SetCallbacks(curl, request.cancel, receiving, reach);
  if (request.signature) SetSignature(curl, *request.signature);
  curl_easy_setopt(curl, CURLOPT_URL, request.url.c_str());
  curl_easy_setopt(curl, CURLOPT_HTTPHEADER, headers.get());
  curl_easy_setopt(curl, CURLOPT_ERRORBUFFER, error.data());
  const CURLcode code = curl_easy_perform(curl);
  if (!sending.status.ok()) return sending.status;
  if (reach.refused) return absl::PermissionDeniedError("the address may not be reached");
  if (code == CURLE_ABORTED_BY_CALLBACK) return request.cancel.Check();
  if (code == CURLE_OK || receiving.is_cut) return AnswerOf(curl, std::move(receiving));
  return absl::UnavailableError(error[0] == '\0' ? curl_easy_strerror(code) : error.data());
}

}  // namespace slicefarm::coordinator
