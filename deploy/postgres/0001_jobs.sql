-- Jobs, their events, idempotency keys and the index of results. Coordinators bring a database to the present schema
-- themselves, file by file; released files never change. Times are microseconds since 1970.

CREATE TABLE jobs (
  number           BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
  id               TEXT   NOT NULL UNIQUE,
  tenant           TEXT   NOT NULL,
  state            TEXT   NOT NULL,
  priority         BIGINT NOT NULL,
  deadline_us      BIGINT NOT NULL,
  spec             BYTEA  NOT NULL,
  labels           TEXT   NOT NULL,             -- JSON
  settings_digest  TEXT   NOT NULL,
  action_digest    TEXT   NOT NULL,
  build_id         TEXT   NOT NULL,
  traceparent      TEXT   NOT NULL,
  create_us        BIGINT NOT NULL,
  start_us         BIGINT NOT NULL DEFAULT 0,
  end_us           BIGINT NOT NULL DEFAULT 0,
  layers_total     BIGINT NOT NULL DEFAULT 0,
  layers_done      BIGINT NOT NULL DEFAULT 0,
  error            TEXT   NOT NULL DEFAULT '',  -- JSON; '': none
  result           TEXT   NOT NULL DEFAULT '',  -- JSON; '': none
  gcode_sha256     TEXT   NOT NULL DEFAULT '',  -- of result: what refers to a blob
  report_sha256    TEXT   NOT NULL DEFAULT '',
  cancel_requested BIGINT NOT NULL DEFAULT 0,
  retries          BIGINT NOT NULL DEFAULT 0,
  store_failures   BIGINT NOT NULL DEFAULT 0,
  last_sequence    BIGINT NOT NULL DEFAULT 0,
  owner            TEXT   NOT NULL DEFAULT '',
  owner_epoch      BIGINT NOT NULL DEFAULT 0,
  owner_until_us   BIGINT NOT NULL DEFAULT 0
);
CREATE INDEX jobs_open ON jobs (tenant, priority DESC, deadline_us, number) WHERE state IN ('QUEUED', 'RUNNING');
CREATE INDEX jobs_held ON jobs (tenant) WHERE state IN ('QUEUED', 'RUNNING') AND owner <> '';
CREATE INDEX jobs_by_owner ON jobs (owner) WHERE owner <> '';
CREATE INDEX jobs_by_state ON jobs (state, number);
CREATE INDEX jobs_by_tenant ON jobs (tenant, number);
CREATE INDEX jobs_by_end ON jobs (end_us) WHERE end_us > 0;
CREATE INDEX jobs_by_gcode ON jobs (gcode_sha256) WHERE gcode_sha256 <> '';
CREATE INDEX jobs_by_report ON jobs (report_sha256) WHERE report_sha256 <> '';

CREATE TABLE events (
  job          BIGINT NOT NULL REFERENCES jobs (number) ON DELETE CASCADE,
  sequence     BIGINT NOT NULL,
  time_us      BIGINT NOT NULL,
  state        TEXT   NOT NULL,
  layers_total BIGINT NOT NULL,
  layers_done  BIGINT NOT NULL,
  PRIMARY KEY (job, sequence)
);

CREATE TABLE labels (
  job   BIGINT NOT NULL REFERENCES jobs (number) ON DELETE CASCADE,
  key   TEXT   NOT NULL,
  value TEXT   NOT NULL,
  PRIMARY KEY (job, key)
);
CREATE INDEX labels_by_value ON labels (key, value, job);

CREATE TABLE inputs (
  job    BIGINT NOT NULL REFERENCES jobs (number) ON DELETE CASCADE,
  digest TEXT   NOT NULL,
  PRIMARY KEY (job, digest)
);
CREATE INDEX inputs_by_digest ON inputs (digest);

CREATE TABLE requests (
  tenant      TEXT   NOT NULL,
  request_id  TEXT   NOT NULL,
  job_id      TEXT   NOT NULL,
  spec_digest TEXT   NOT NULL,
  create_us   BIGINT NOT NULL,
  PRIMARY KEY (tenant, request_id)
);
CREATE INDEX requests_by_age ON requests (create_us);
CREATE INDEX requests_by_job ON requests (job_id);

CREATE TABLE results (
  action_digest TEXT PRIMARY KEY,
  result        TEXT NOT NULL,  -- JSON
  gcode_sha256  TEXT NOT NULL,
  report_sha256 TEXT NOT NULL
);
CREATE INDEX results_by_gcode ON results (gcode_sha256);
CREATE INDEX results_by_report ON results (report_sha256);

CREATE TABLE tenants (
  tenant     TEXT   PRIMARY KEY,
  claimed_us BIGINT NOT NULL  -- a job of it, last
);
