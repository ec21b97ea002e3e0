#include "services/coordinator/server/main/s3_flags.h"

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "absl/strings/str_cat.h"

namespace slicefarm::coordinator {
namespace {

std::string OfEnvironment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

}  // namespace

void AddS3Flags(CLI::App& app, S3Flags* flags) {
  auto* const url =
      app.add_option("--s3", flags->url,
                     "Bucket for meshes and results, http[s]://HOST[:PORT]/BUCKET[/PREFIX]; jobs "
                     "and uploads remain in --state-dir or --postgres")
          ->envname("SLICEFARM_S3");
  app.add_flag("--s3-bucket-in-host", flags->bucket_in_host,
               "Use the address form http[s]://BUCKET.HOST[/PREFIX] in --s3")
      ->needs(url);
  app.add_option("--s3-region", flags->region, "Region of the bucket")
      ->envname("AWS_REGION")
      ->capture_default_str();
  app.add_option(
         "--s3-ca", flags->ca_file,
         "PEM file of CA certificates that sign the bucket's certificate; default: the system's")
      ->check(CLI::ExistingFile);
  app.add_option("--s3-credentials", flags->credentials_file,
                 "JSON file with `access_key` and `secret_key`; default: AWS_ACCESS_KEY_ID and "
                 "AWS_SECRET_ACCESS_KEY of the environment")
      ->check(CLI::ExistingFile);
}

absl::StatusOr<S3Credentials> ParseS3Credentials(const std::string& text) {
  const auto json = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return absl::InvalidArgumentError("S3: a JSON object is needed");
  S3Credentials credentials;
  for (const auto& [key, value] : json.items()) {
    if (!value.is_string())
      return absl::InvalidArgumentError(absl::StrCat("S3: ", key, ": a text is needed"));
    if (key == "access_key") {
      credentials.access_key = value.get<std::string>();
    } else if (key == "secret_key") {
      credentials.secret_key = value.get<std::string>();
    } else if (key == "session_token") {
      credentials.session_token = value.get<std::string>();
    } else {
      return absl::InvalidArgumentError(absl::StrCat("S3: ", key, ": unknown key"));
    }
  }
  if (credentials.access_key.empty() || credentials.secret_key.empty())
    return absl::InvalidArgumentError("S3: access_key and secret_key are needed");
  return credentials;
}

absl::StatusOr<S3Credentials> ReadS3Credentials(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  if (!file || !(text << file.rdbuf()))
    return absl::InvalidArgumentError(absl::StrCat("S3: ", path, " cannot be read"));
  return ParseS3Credentials(text.str());
}

absl::StatusOr<S3Credentials> S3CredentialsOfEnvironment() {
  S3Credentials credentials{OfEnvironment("AWS_ACCESS_KEY_ID"),
                            OfEnvironment("AWS_SECRET_ACCESS_KEY"),
                            OfEnvironment("AWS_SESSION_TOKEN")};
  if (!credentials.access_key.empty() && !credentials.secret_key.empty()) return credentials;
  return absl::InvalidArgumentError(
      "S3: give --s3-credentials, or set AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY");
}

absl::StatusOr<std::shared_ptr<S3Client>> MakeS3Client(const S3Flags& flags,
                                                       S3CredentialsNow credentials) {
  auto address = ParseS3Address(flags.url, flags.bucket_in_host);
  if (!address.ok()) return address.status();
  return std::make_shared<S3Client>(S3Options{.address = *std::move(address),
                                              .region = flags.region,
                                              .credentials = std::move(credentials),
                                              .http = {.ca_file = flags.ca_file}});
}

}  // namespace slicefarm::coordinator
