"""Transfers large results. Measures the bytes that a download reads from PostgreSQL or a bucket, and its speed. Checks
that downloads in every slot do not cost a job its run. Measures the bytes that a coordinator reads for equal jobs
with a cached result."""
import os
import pathlib
import re
import tempfile
import threading
import time

from exhaust_memory import Most, prism
from exhaust_rows import sql
from local_farm import MODELS, running_farm

RESULT_MB = int(os.environ.get("SLICEFARM_EXHAUST_RESULT_MB", "500"))
CACHED_MB = int(os.environ.get("SLICEFARM_EXHAUST_CACHED_MB", "100"))
CACHED_JOBS = int(os.environ.get("SLICEFARM_EXHAUST_CACHED_JOBS", "1000"))
DOWNLOADS = 48
JOBS_BESIDE = 20
LAYER_BYTES = 120_000
SUBMITTERS = 4
STATISTICS_S = 15  # delay of PostgreSQL's statistics about reads of an idle session
CHUNK_BYTES = 1_996  # size of PostgreSQL's chunks of a large value
CHUNKS_READ = """SELECT idx_tup_fetch FROM pg_stat_all_tables
  WHERE relid = (SELECT reltoastrelid FROM pg_class WHERE oid = 'blob_pieces'::regclass)"""


def long_job(directory, megabytes):
    """Returns arguments of `submit` for a job with so many megabytes of G-code."""
    layers = megabytes * 1_000_000 // LAYER_BYTES
    model = pathlib.Path(directory) / f"tower-{megabytes}.stl"
    prism(model, 12, 4, layers * 0.02)
    text = "; " + "x" * (LAYER_BYTES // 2)
    settings = model.with_suffix(".ini")
    settings.write_text(
        f"layer_height = 0.02\nfirst_layer_height = 0.02\nmax_print_height = 1000\nperimeters = 1\nfill_density = 0\n"
        f"layer_gcode = {text}\nbefore_layer_gcode = {text}\n"
    )
    return model, "--config", settings


def succeeded(farm, *arguments):
    """Submits a job and waits for its end. Returns its id and the size of its G-code."""
    job_id = farm.submit(*arguments)
    assert farm.client("watch", job_id).returncode == 0
    job = next(job for job in farm.jobs() if job["id"] == job_id)
    return job_id, int(job["result"]["gcode_size"])


def bytes_read(farm):
    """Returns the bytes of blobs that all sessions have read from the database."""
    return int(sql(farm, CHUNKS_READ)) * CHUNK_BYTES


def download(farm, job_id, coordinator=None):
    return farm.client("get", job_id, "-o", os.devnull, coordinator=coordinator).returncode


def from_postgres(directory):
    with running_farm("postgres") as farm:
        job_id, size = succeeded(farm, *long_job(directory, RESULT_MB))
        time.sleep(STATISTICS_S)
        coordinator = farm.coordinators[0]
        before, cpu, begun = bytes_read(farm), coordinator.cpu_s(), time.monotonic()
        assert download(farm, job_id, coordinator) == 0
        seconds, cpu = time.monotonic() - begun, coordinator.cpu_s() - cpu
        time.sleep(STATISTICS_S)
        yield "transfers_result_mb", size / 1e6, None
        yield "transfers_read_over_sent", (bytes_read(farm) - before) / size, 1.1
        yield "transfers_coordinator_cpu_s", cpu, None
        yield "transfers_mb_per_s", size / 1e6 / seconds, None
        yield "transfers_slower_than_150_mb_per_s", size / 1e6 / seconds < 150, 0
        yield from beside_downloads(farm, job_id)


def from_s3(directory):
    """Measures downloads from a bucket, as from_postgres does, and the memory of the coordinator meanwhile."""
    with running_farm("s3") as farm:
        job_id, size = succeeded(farm, *long_job(directory, RESULT_MB))
        coordinator = farm.coordinators[0]
        assert download(farm, job_id, coordinator) == 0  # the first download checks the blob
        before, cpu, memory, begun = farm.s3.counts()["sent"], coordinator.cpu_s(), Most(coordinator), time.monotonic()
        assert download(farm, job_id, coordinator) == 0
        seconds, held = time.monotonic() - begun, memory.stop()
        yield "transfers_s3_result_mb", size / 1e6, None
        yield "transfers_s3_read_over_sent", (farm.s3.counts()["sent"] - before) / size, 1.1
        yield "transfers_s3_coordinator_cpu_s", coordinator.cpu_s() - cpu, None
        yield "transfers_s3_coordinator_mib", held, 256
        yield "transfers_s3_mb_per_s", size / 1e6 / seconds, None
        yield from beside_downloads(farm, job_id, "transfers_s3")


def beside_downloads(farm, job_id, name="transfers"):
    codes = []
    threads = [threading.Thread(target=lambda: codes.append(download(farm, job_id))) for _ in range(DOWNLOADS)]
    for thread in threads:
        thread.start()
    jobs = [farm.submit(MODELS / "textbox.stl", "--set", f"infill_speed={40 + i}") for i in range(JOBS_BESIDE)]
    for thread in threads:
        thread.join()
    farm.await_end()
    listed = ",".join(f"'{job}'" for job in jobs)
    ended = sql(farm, f"SELECT count(*) FROM jobs WHERE id IN ({listed}) AND state = 'SUCCEEDED' AND owner_epoch = 1")
    yield f"{name}_downloads_that_failed", sum(code != 0 for code in codes), 0
    yield f"{name}_runs_thrown_away", len(jobs) - int(ended), 0


def read_bytes(farm):
    return int(re.search(r"^rchar: (\d+)", farm.coordinators[0].proc("io"), re.MULTILINE)[1])


def of_equal_jobs(directory):
    with running_farm() as farm:
        arguments = long_job(directory, CACHED_MB)
        size = succeeded(farm, *arguments)[1]
        before = read_bytes(farm)

        def submit():
            for _ in range(CACHED_JOBS // SUBMITTERS):
                farm.submit(*arguments)

        threads = [threading.Thread(target=submit) for _ in range(SUBMITTERS)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        jobs = farm.await_end(3600)
        yield "transfers_cached_jobs", sum(bool(job.get("result", {}).get("cached")) for job in jobs), None
        yield "transfers_cached_result_mb", size / 1e6, None
        yield "transfers_not_cached", 1 + CACHED_JOBS - len(jobs) + sum(not job["result"].get("cached") for job in jobs) - 1, 0
        yield "transfers_read_for_cached_mb", (read_bytes(farm) - before) / 1e6, 1000


def measure():
    with tempfile.TemporaryDirectory(prefix="slicefarm-exhaust-") as directory:
        yield from from_postgres(directory)
        yield from from_s3(directory)
        yield from of_equal_jobs(directory)
