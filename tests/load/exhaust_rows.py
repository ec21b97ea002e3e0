"""Inserts ended jobs directly into the database, a million by default (SLICEFARM_EXHAUST_ROWS). Compares the times of
submits, gets and claims with an empty database. Rounds with and without the rows alternate, so that other load on
the machine affects both."""
import os
import statistics
import subprocess

from local_farm import running_farm

ROWS = int(os.environ.get("SLICEFARM_EXHAUST_ROWS", "1000000"))
SECONDS = os.environ.get("SLICEFARM_EXHAUST_SECONDS", "20")
ROUNDS = 3
BOUNDS_S = ("0.0005", "0.001", "0.0025", "0.005", "0.01", "0.025", "0.05", "0.1", "0.25", "0.5", "1", "5")
# Adds the rows of SUCCEEDED jobs: the job, its events, its inputs and its request.
FILL = """
INSERT INTO jobs (id, tenant, state, priority, deadline_us, spec, labels, settings_digest, action_digest, build_id, traceparent,
                  create_us, start_us, end_us, last_sequence)
  SELECT md5(n::text), '', 'SUCCEEDED', 1, 9223372036854775807, repeat('x', 400)::bytea, '{}', '', md5(n::text), '', '',
         now_us - n, now_us - n, now_us - n, 2
  FROM generate_series(1, %d) AS n, (SELECT (extract(epoch FROM now()) * 1000000)::BIGINT AS now_us) AS clock;
INSERT INTO inputs (job, digest) SELECT number, repeat('0', 32) || id FROM jobs WHERE build_id = '';
INSERT INTO requests (tenant, request_id, job_id, spec_digest, create_us)
  SELECT '', 'filled ' || id, id, '', create_us FROM jobs WHERE build_id = '';
INSERT INTO events SELECT number, sequence, create_us, 'SUCCEEDED', 10, 10 FROM jobs, generate_series(1, 2) AS sequence
  WHERE state = 'SUCCEEDED' AND build_id = '';
"""


class Measured:
    """Latencies (p99) of clients and of the coordinator in ms; each value is the median of some rounds."""

    def __init__(self):
        self.rounds, self.claims = {}, []

    def add(self, key, value):
        self.rounds.setdefault(key, []).append(value)

    def value(self, key):
        return statistics.median(self.rounds[key])


def sql(farm, text):
    done = subprocess.run(["psql", "-At", "-q", "-v", "ON_ERROR_STOP=1", farm.postgres.connection, "-c", text], check=True,
                          stdout=subprocess.PIPE, text=True)
    return done.stdout.strip()


def claims(farm):
    """Returns the total time of all claims in seconds, and the number of claims up to each of BOUNDS_S, over all
    coordinators."""
    labels = [f'bucket{{operation="claim",le="{bound}"}}' for bound in BOUNDS_S]
    names = [f"slicefarm_store_commit_seconds_{label}" for label in ['sum{operation="claim"}', *labels]]
    return [sum(c.metric(name) or 0 for c in farm.coordinators) for name in names]


def quantile_s(counts, part):
    """Returns a quantile of a histogram. Interpolates linearly within a bucket, as Prometheus does."""
    wanted, below, low = part * counts[-1], 0, 0.0
    for bound, count in zip(map(float, BOUNDS_S), counts):
        if count >= wanted:
            return low + (bound - low) * (wanted - below) / (count - below) if count > below else bound
        below, low = count, bound
    return low


def measure_round(farm, measured):
    before = claims(farm)
    report = farm.load("--rate", "4", "--seconds", SECONDS, "--mix", "tiny")
    took = [now - then for now, then in zip(claims(farm), before)]
    measured.add("submit_p99_ms", report["steps"]["CreateJob"]["p99"] / 1e6)
    measured.add("job_p50_ms", report["percentiles"]["p50"] / 1e6)
    measured.add("claim_mean_ms", 1000 * took[0] / max(1, took[-1]))
    measured.claims = [a + b for a, b in zip(measured.claims or [0] * len(BOUNDS_S), took[1:])]
    report = farm.load("--scenario", "get", "--rate", "100", "--seconds", SECONDS, "--mix", "tiny")
    measured.add("get_p99_ms", report["percentiles"]["p99"] / 1e6)
    begun = os.times().elapsed
    assert farm.client("list", "--limit", "50").returncode == 0
    measured.add("list_ms", 1000 * (os.times().elapsed - begun))


def measure():
    with running_farm("postgres") as empty, running_farm("postgres") as full:
        sql(full, FILL % ROWS)
        sql(full, "VACUUM ANALYZE")
        sql(full, "CHECKPOINT")  # writes the pending pages of the fill
        for farm in (empty, full):
            measure_round(farm, Measured())  # warm-up
        before, after = Measured(), Measured()
        for _ in range(ROUNDS):
            measure_round(empty, before)
            measure_round(full, after)
        yield "rows_ended_jobs", int(sql(full, "SELECT count(*) FROM jobs WHERE state = 'SUCCEEDED'")), None
        for key in before.rounds:
            yield f"rows_{key}_empty", before.value(key), None
            yield f"rows_{key}_full", after.value(key), 1.2 * before.value(key)
        # The percentile is over all rounds, because one round has few claims.
        yield "rows_claim_p99_ms_empty", 1000 * quantile_s(before.claims, 0.99), None
        yield "rows_claim_p99_ms_full", 1000 * quantile_s(after.claims, 0.99), 1.2 * 1000 * quantile_s(before.claims, 0.99)
