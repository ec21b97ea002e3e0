-- Lists pass over what they do not want without reading its row.

DROP INDEX jobs_by_tenant;
CREATE INDEX jobs_by_tenant ON jobs (tenant, number, priority, create_us, state);
