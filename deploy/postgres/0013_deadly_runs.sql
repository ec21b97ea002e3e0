-- Runs of a job that ended because workers or stages died of them, as it seems.

ALTER TABLE jobs ADD COLUMN deadly_runs BIGINT NOT NULL DEFAULT 0;
