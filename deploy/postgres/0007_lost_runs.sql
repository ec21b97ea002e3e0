-- How often a job's owner ended, or was fenced, in the middle of a run.

ALTER TABLE jobs ADD COLUMN lost_runs BIGINT NOT NULL DEFAULT 0;
