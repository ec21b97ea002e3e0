-- Runs of a job that began and came to no end: its coordinators may die of it.

ALTER TABLE jobs ADD COLUMN lost_runs BIGINT NOT NULL DEFAULT 0;
