CREATE INDEX CONCURRENTLY IF NOT EXISTS events_by_time ON events (time_us, job, sequence);
