-- What was done for a job, and when: the name of a blob.

ALTER TABLE jobs ADD COLUMN trace_sha256 TEXT NOT NULL DEFAULT '';
CREATE INDEX jobs_by_trace ON jobs (trace_sha256) WHERE trace_sha256 <> '';
