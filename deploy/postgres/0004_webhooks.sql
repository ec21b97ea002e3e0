-- The outbox: whom to tell of a job's end, and what became of the tries.

CREATE TABLE webhooks (
  job      BIGINT PRIMARY KEY REFERENCES jobs (number) ON DELETE CASCADE,
  url      TEXT   NOT NULL,
  state    TEXT   NOT NULL,  -- WAITING for the job's end, DUE, DELIVERED, GIVEN_UP
  due_us   BIGINT NOT NULL,  -- also: claimed until then
  attempts BIGINT NOT NULL
);
CREATE INDEX webhooks_due ON webhooks (due_us) WHERE state = 'DUE';

CREATE TABLE webhook_attempts (
  job         BIGINT NOT NULL REFERENCES jobs (number) ON DELETE CASCADE,
  attempt     BIGINT NOT NULL,
  time_us     BIGINT NOT NULL,
  http_status BIGINT NOT NULL,  -- 0: no answer
  error       TEXT   NOT NULL,
  PRIMARY KEY (job, attempt)
);
