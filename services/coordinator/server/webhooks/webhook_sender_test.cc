// Tests of webhooks from a job's request to the receiver.
#include "services/coordinator/server/webhooks/webhook_sender.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "nlohmann/json.hpp"
#include "services/coordinator/server/main/coordinator_fixture_test.h"
#include "services/coordinator/server/webhooks/http_post.h"
#include "services/coordinator/server/webhooks/http_receiver_test.h"
#include "services/coordinator/server/webhooks/webhook_message.h"

namespace slicefarm::coordinator::webhook_sender_test {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

constexpr char kSecret[] = "0123456789abcdef";

class WebhookSenderTest : public CoordinatorTest {
 protected:
  WebhookSenderTest() {
    Close();
    UseRules(/*private_addresses=*/true);
    Open();
  }

  void UseRules(bool private_addresses) {
    const nlohmann::json rules = {{"",
                                   {{"allow", {receiver_.Url("/farm")}},
                                    {"secret", kSecret},
                                    {"private", private_addresses}}}};
    webhooks_ = std::make_shared<const WebhookPolicy>(*WebhookPolicy::Parse(rules.dump()));
  }

  absl::StatusOr<v1::Job> CreateWith(const std::string& url) {
    EXPECT_TRUE(Upload("xxx").ok());
    v1::CreateJobRequest request = RequestFor("xxx");
    request.set_webhook_url(url);
    return Create(request);
  }

  v1::Webhook GetWebhook(const std::string& id) {
    grpc::ClientContext context;
    v1::GetWebhookRequest request;
    request.set_job_id(id);
    v1::Webhook webhook;
    EXPECT_TRUE(jobs_->GetWebhook(&context, request, &webhook).ok());
    return webhook;
  }

  /// Waits until the webhook has this state, because the receiver gets a try before the outbox
  /// records it.
  v1::Webhook AwaitState(const std::string& id, v1::Webhook::State state) {
    v1::Webhook webhook;
    while (webhook.state() != state) webhook = GetWebhook(id);
    return webhook;
  }

  double Tries(const std::string& outcome) {
    return prometheus::BuildCounter()
        .Name("slicefarm_webhook_tries_total")
        .Register(registry_)
        .Add({{"outcome", outcome}})
        .Value();
  }

  HttpReceiver receiver_;
};

std::string Header(const std::string& request, const std::string& name) {
  const size_t begin = request.find(name + ": ") + name.size() + 2;
  return request.substr(begin, request.find("\r\n", begin) - begin);
}

TEST_F(WebhookSenderTest, TellsOfTheEndSigned) {
  const auto job = CreateWith(receiver_.Url("/farm/jobs?key=1"));
  ASSERT_TRUE(job.ok()) << job.status();
  const std::string request = receiver_.Await(1)[0];
  EXPECT_THAT(request, testing::StartsWith("POST /farm/jobs?key=1 HTTP/1.1\r\n"));
  EXPECT_EQ(Header(request, "Content-Type"), "application/json");
  EXPECT_EQ(Header(request, "Slicefarm-Delivery"), job->id());
  const std::string body = request.substr(request.find("\r\n\r\n") + 4);
  const std::string signature = Header(request, "Slicefarm-Signature");
  const int64_t time_s = std::stoll(signature.substr(2));
  EXPECT_EQ(signature, WebhookSignature({kSecret}, time_s, body));
  const auto json = nlohmann::json::parse(body);
  EXPECT_EQ(json["job"]["id"], job->id());
  EXPECT_EQ(json["job"]["state"], "JOB_STATE_SUCCEEDED");
  const v1::Webhook webhook = AwaitState(job->id(), v1::Webhook::STATE_DELIVERED);
  ASSERT_EQ(webhook.attempts_size(), 1);
  EXPECT_EQ(webhook.attempts(0).http_status(), 200);
}

TEST_F(WebhookSenderTest, TriesAgainUntilItIsTaken) {
  receiver_.Answer({"HTTP/1.1 503 Later\r\nContent-Length: 0\r\n\r\n", "nonsense"});
  const auto job = CreateWith(receiver_.Url("/farm"));
  EXPECT_THAT(receiver_.Await(3), SizeIs(3));
  const v1::Webhook webhook = AwaitState(job->id(), v1::Webhook::STATE_DELIVERED);
  ASSERT_EQ(webhook.attempts_size(), 3);
  EXPECT_EQ(webhook.attempts(0).http_status(), 503);
  EXPECT_EQ(webhook.attempts(1).http_status(), 0);
  EXPECT_NE(webhook.attempts(1).error(), "");
}

TEST_F(WebhookSenderTest, GivesUpInTheEnd) {
  const std::string no = "HTTP/1.1 410 Gone\r\nContent-Length: 0\r\n\r\n";
  receiver_.Answer({no, no, no, no});
  const auto job = CreateWith(receiver_.Url("/farm"));
  EXPECT_EQ(AwaitState(job->id(), v1::Webhook::STATE_GIVEN_UP).attempts_size(), 3);
  EXPECT_THAT(receiver_.Await(3), SizeIs(3));
  Close();  // Close waits until the tries are counted
  EXPECT_EQ(Tries("failed"), 2);
  EXPECT_EQ(Tries("given_up"), 1);
  EXPECT_EQ(Tries("delivered"), 0);
}

TEST_F(WebhookSenderTest, FollowsNoRedirect) {
  receiver_.Answer({"HTTP/1.1 302 There\r\nLocation: " + receiver_.Url("/elsewhere") +
                    "\r\nContent-Length: 0\r\n\r\n"});
  const auto job = CreateWith(receiver_.Url("/farm"));
  const v1::Webhook webhook = AwaitState(job->id(), v1::Webhook::STATE_DELIVERED);
  EXPECT_EQ(webhook.attempts(0).http_status(), 302);
  for (const std::string& request : receiver_.Await(2))
    EXPECT_THAT(request, testing::StartsWith("POST /farm "));
}

TEST_F(WebhookSenderTest, OutlivesTheCoordinator) {
  ranges_->Hold();
  const auto job = CreateWith(receiver_.Url("/farm"));
  ranges_->AwaitCall();
  EXPECT_EQ(GetWebhook(job->id()).state(), v1::Webhook::STATE_WAITING);
  Close();
  ranges_->LetGo();
  Open();
  EXPECT_EQ(Header(receiver_.Await(1)[0], "Slicefarm-Delivery"), job->id());
}

TEST_F(WebhookSenderTest, RefusesWhatIsNotOnTheList) {
  const absl::Status refused = CreateWith(receiver_.Url("/other")).status();
  EXPECT_EQ(DetailOf(refused).reason, Reason::kWebhookRefused);
  EXPECT_EQ(GetWebhook(Submit("xxx")).url(), "") << "a job without";
}

TEST_F(WebhookSenderTest, GoesToNoPrivateAddressUnlessItMay) {
  Close();
  UseRules(/*private_addresses=*/false);
  Open();
  const auto job = CreateWith(receiver_.Url("/farm"));
  const v1::Webhook webhook = AwaitState(job->id(), v1::Webhook::STATE_GIVEN_UP);
  EXPECT_THAT(webhook.attempts(0).error(), HasSubstr("public"));
}

TEST(HttpPost, LooksAtTheAddressThatANameLedTo) {
  const auto status = HttpPost("http://localhost:1/", "{}", {});
  EXPECT_TRUE(absl::IsPermissionDenied(status.status())) << status.status();
  const auto nobody = HttpPost("http://127.0.0.1:1/", "{}", {.private_addresses = true});
  EXPECT_TRUE(absl::IsUnavailable(nobody.status())) << nobody.status();
}

TEST(HttpPost, AnAnswerWithoutEndIsCutOff) {
  HttpReceiver receiver;
  receiver.Answer({"HTTP/1.1 200 OK\r\n\r\n" + std::string(1 << 20, 'x')});
  EXPECT_EQ(*HttpPost(receiver.Url("/"), "{}", {.private_addresses = true}), 200);
}

}  // namespace
}  // namespace slicefarm::coordinator::webhook_sender_test
