-- Claims ask which work some coordinator has in hand.

CREATE INDEX CONCURRENTLY IF NOT EXISTS jobs_held_work ON jobs (action_digest) WHERE state IN ('QUEUED', 'RUNNING') AND owner <> '';
