"""Ended jobs, a million unless SLICEFARM_EXHAUST_ROWS says otherwise, are put into the database behind the farm's back: what
submits, gets and claims take then, against what they took in an empty one."""
import os
import subprocess

from local_farm import running_farm

ROWS = int(os.environ.get("SLICEFARM_EXHAUST_ROWS", "1000000"))
SECONDS = "30"
FILL = """
INSERT INTO jobs (id, tenant, state, priority, deadline_us, spec, labels, settings_digest, action_digest, build_id, traceparent,
                  create_us, start_us, end_us, last_sequence)
  SELECT md5(n::text), '', 'SUCCEEDED', 1, 9223372036854775807, repeat('x', 400)::bytea, '{}', '', md5(n::text), '', '',
         now_us - n, now_us - n, now_us - n, 2
  FROM generate_series(1, %d) AS n, (SELECT (extract(epoch FROM now()) * 1000000)::BIGINT AS now_us) AS clock;
INSERT INTO events SELECT number, sequence, create_us, 'SUCCEEDED', 10, 10 FROM jobs, generate_series(1, 2) AS sequence
  WHERE state = 'SUCCEEDED' AND build_id = '';
ANALYZE;
"""


def sql(farm, text):
    done = subprocess.run(["psql", "-At", "-q", "-v", "ON_ERROR_STOP=1", farm.postgres.connection, "-c", text], check=True,
                          stdout=subprocess.PIPE, text=True)
    return done.stdout.strip()


def p99_ms(farm):
    report = farm.load("--rate", "4", "--seconds", SECONDS, "--mix", "tiny")
    return report["percentiles"]["p99"] / 1e6


def listed_s(farm):
    begun = os.times().elapsed
    assert farm.client("list", "--limit", "50").returncode == 0
    return os.times().elapsed - begun


def measure():
    with running_farm("postgres") as farm:
        p99_ms(farm)  # everything has been reached once
        job, listed = p99_ms(farm), min(listed_s(farm) for _ in range(5))
        sql(farm, FILL % ROWS)
        yield "rows_ended_jobs", int(sql(farm, "SELECT count(*) FROM jobs WHERE state = 'SUCCEEDED'")), None
        yield "rows_job_empty_p99_ms", job, None
        yield "rows_job_full_p99_ms", p99_ms(farm), 1.2 * job + 20
        yield "rows_list_empty_ms", 1000 * listed, None
        yield "rows_list_full_ms", 1000 * min(listed_s(farm) for _ in range(5)), 1.2 * 1000 * listed + 20
