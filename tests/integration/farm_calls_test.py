#!/usr/bin/env python3
"""Tests the command line's calls for operators on a farm of real processes: events of all jobs, artifacts of a job,
meshes, kept data, changing and cancelling jobs, positions in the queue, and the output formats that scripts rely on.

usage: farm_calls_test.py SLICEFARM
"""
import hashlib
import json
import os
import pathlib
import pty
import signal
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from local_farm import BIN, MODELS, call, running_farm

MODEL = MODELS / "textbox.stl"


def check_artifacts(farm, job, folder):
    program = folder / "part.gcode"
    call(farm, "get", job, "-o", str(program))
    gcode = program.read_bytes()
    listed = {each["artifact"]: each for each in json.loads(call(farm, "artifacts", job))["artifacts"]}
    assert set(listed) == {"ARTIFACT_GCODE", "ARTIFACT_REPORT", "ARTIFACT_LAYERS", "ARTIFACT_THUMBNAIL"}, listed
    assert listed["ARTIFACT_GCODE"]["sha256"] == hashlib.sha256(gcode).hexdigest()
    assert listed["ARTIFACT_GCODE"]["file_name"] == "textbox.gcode", listed["ARTIFACT_GCODE"]
    assert listed["ARTIFACT_THUMBNAIL"]["media_type"] == "image/png"
    for kind in ("report", "layers", "thumbnail"):
        out = folder / kind
        call(farm, "artifacts", job, "--kind", kind, "-o", str(out))
        info = listed[f"ARTIFACT_{kind.upper()}"]
        assert (hashlib.sha256(out.read_bytes()).hexdigest(), out.stat().st_size) == (info["sha256"], int(info["size"])), info
    assert (folder / "thumbnail").read_bytes().startswith(b"\x89PNG")
    layers = json.loads((folder / "layers").read_text())["layers"]
    assert len(layers) == gcode.count(b";LAYER_CHANGE") > 10
    for layer in layers:
        text = gcode[layer["offset"]:].split(b"\n", 3)
        assert text[:3] == [b";LAYER_CHANGE", f";Z:{layer['z_mm']:g}".encode(), f";HEIGHT:{layer['height_mm']:g}".encode()], (layer, text[:3])
        assert layer["moves"] > 0 and layer["time_s"] > 0


def check_events(farm, job):
    lines = [json.loads(line) for line in call(farm, "events", "--from", "2020-01-01T00:00:00Z", "--count", "3", "--json").splitlines()]
    assert [(line["event"]["job"]["id"], line["event"]["sequence"], line["event"]["job"]["state"]) for line in lines] == [
        (job, "1", "JOB_STATE_QUEUED"), (job, "2", "JOB_STATE_RUNNING"), (job, "3", "JOB_STATE_SUCCEEDED")], lines
    again = call(farm, "events", "--cursor", lines[-1]["cursor"], "--count", "1")
    assert job in again, again


def check_scripts(farm, job, folder):
    """Checks the behaviour that scripts of a farm rely on: one JSON object per job, ids and abbreviated ids, profiles
    by the name that `put` prints.
    """
    out = folder / "json.gcode"
    told = [json.loads(line) for line in farm.client("submit", MODEL, "-o", out, "--json").stdout.splitlines()]
    assert len(told) == 1 and told[0]["state"] == "JOB_STATE_SUCCEEDED" and told[0]["output"] == str(out), told
    assert json.loads(call(farm, "get", told[0]["id"][:12]))["id"] == told[0]["id"]
    assert "; job " in farm.client("submit", MODEL, "-o", out).stdout
    detached = json.loads(farm.client("submit", MODEL, "--detach", "--json", "--label", "order=7").stdout)
    assert json.loads(call(farm, "watch", detached["id"], "--json"))["state"] == "JOB_STATE_SUCCEEDED"
    row = next(line for line in call(farm, "list").splitlines() if line.startswith(detached["id"]))
    assert "order=7" in row and "textbox.stl" in row, row
    printer = folder / "printer.ini"
    printer.write_text("bed_shape = 0x0,250x0,250x210,0x210\nnozzle_diameter = 0.4\ngcode_flavor = marlin2\nbinary_gcode = 1\n")
    name = call(farm, "profile", "put", "mk4s", "--config", str(printer)).strip()
    assert "nozzle_diameter = 0.4" in call(farm, "profile", "get", name) and name == "mk4s@1", name
    server = farm.coordinators[0].address
    plain = [BIN / "slicefarm", "submit", MODEL, "--server", server]
    refused = subprocess.run([*plain, "-o", out], capture_output=True, text=True)
    assert refused.returncode == 3 and "--generic" in refused.stderr and "--profile" in refused.stderr, refused.stderr
    before = out.read_bytes()
    wrongly_named = subprocess.run([*plain, "--profile", "mk4s", "-o", out], capture_output=True, text=True)
    assert wrongly_named.returncode == 2 and "bgcode" in wrongly_named.stderr and out.read_bytes() == before, wrongly_named.stderr
    binary = subprocess.run([*plain, "--profile", "mk4s", "-o", folder / "out.bgcode", "--json"], capture_output=True, text=True)
    assert binary.returncode == 0 and (folder / "out.bgcode").read_bytes().startswith(b"GCDE"), binary.stderr
    call(farm, "artifacts", json.loads(binary.stdout)["id"], "--kind", "thumbnail", "-o", str(folder / "binary.png"))
    assert (folder / "binary.png").read_bytes().startswith(b"\x89PNG")
    call(farm, "artifacts", json.loads(binary.stdout)["id"], "--kind", "layers", "-o", str(folder / "binary.json"))
    assert len(json.loads((folder / "binary.json").read_text())["layers"]) == before.count(b";LAYER_CHANGE")


def places(farm, jobs):
    """Returns the queue positions of jobs, after checking that GetJob and ListJobs report the same positions."""
    listed = {job["id"]: job for job in farm.jobs()}
    alone = [json.loads(call(farm, "get", job)) for job in jobs]
    assert [job.get("queue_position") for job in alone] == [listed[job].get("queue_position") for job in jobs], (alone, listed)
    return [job.get("queue_position") for job in alone]


def watched_until(farm, job, text):
    """Follows a job on a terminal until the terminal shows the text."""
    terminal, end = pty.openpty()
    watch = subprocess.Popen([BIN / "slicefarm", "watch", job, "--server", farm.coordinators[0].address], stderr=end, stdout=end)
    shown = b""
    while text not in shown:
        shown += os.read(terminal, 4096)
    watch.terminate()
    watch.wait()
    os.close(end)
    os.close(terminal)


def check_queue(farm):
    """Checks the queue positions on a farm whose workers are stopped: by priority and age, and after a change."""
    for worker in farm.workers:
        worker.process.send_signal(signal.SIGSTOP)
    number = iter(range(100, 200))

    def submit(priority="normal"):
        return farm.submit(MODEL, "--priority", priority, "--set", f"layer_height=0.{next(number)}")

    running = [submit(), submit(), submit("interactive")]
    while {json.loads(call(farm, "get", job))["state"] for job in running} != {"JOB_STATE_RUNNING"}:
        continue
    assert places(farm, running) == [None] * 3
    old, bulk, new, urgent = waiting = [submit(), submit("bulk"), submit(), submit("interactive")]
    while None in places(farm, waiting):  # queue positions are cached for some milliseconds
        continue
    assert places(farm, waiting) == [2, 4, 3, 1]
    for job in (json.loads(call(farm, "get", job)) for job in waiting):
        assert ("estimated_end_time" in job) != ("waits_for" in job), job
    call(farm, "update", bulk, "--priority", "interactive")
    while places(farm, waiting) == [2, 4, 3, 1]:
        continue
    assert places(farm, waiting) == [3, 1, 4, 2]
    row = next(line for line in call(farm, "list").splitlines() if line.startswith(new))
    assert row.split()[1:3] == ["queued", "4"], row
    watched_until(farm, new, b"place 4 in the queue")
    for worker in farm.workers:
        worker.process.send_signal(signal.SIGCONT)
    assert {job["state"] for job in farm.await_end() if job["id"] in running + waiting} == {"JOB_STATE_SUCCEEDED"}
    assert places(farm, running + waiting) == [None] * 7


def check_waiting(farm):
    """Checks that jobs wait if all workers of the farm are gone."""
    for worker in farm.workers:
        worker.kill()
    waiting = [farm.submit(MODEL, "--set", f"layer_height=0.{n}") for n in (21, 22, 23)]
    call(farm, "update", waiting[0], "--priority", "interactive", "--label", "order=17", "--deadline", "2100-01-01T00:00:00Z")
    job = json.loads(call(farm, "get", waiting[0]))
    assert (job["priority"], job["labels"], job["deadline"]) == ("JOB_PRIORITY_INTERACTIVE", {"order": "17"}, "2100-01-01T00:00:00Z"), job
    call(farm, "update", waiting[0], "--deadline", "none")
    assert "deadline" not in json.loads(call(farm, "get", waiting[0]))
    done = farm.client("cancel", waiting[0], "none", waiting[1], waiting[2])
    assert done.returncode != 0 and "none" in done.stderr and all(job in done.stdout for job in waiting), (done.stdout, done.stderr)
    assert {job["state"] for job in farm.await_end() if job["id"] in waiting} == {"JOB_STATE_CANCELLED"}


def check_meshes(farm, folder):
    digest = hashlib.sha256(MODEL.read_bytes()).hexdigest()
    assert digest in call(farm, "meshes", "list")
    call(farm, "meshes", "get", digest, "-o", str(folder / "mesh"))
    assert (folder / "mesh").read_bytes() == MODEL.read_bytes()
    assert call(farm, "meshes", "delete", digest).startswith("not deleted: a job uses the mesh")
    usage = json.loads(call(farm, "usage"))
    assert int(usage["kept_jobs"]) == 1 and int(usage["kept_bytes"]) > MODEL.stat().st_size, usage
    assert set(json.loads(call(farm, "caller"))["scopes"]) >= {"submit", "read"}


def main(_):
    with tempfile.TemporaryDirectory(prefix="slicefarm-") as name, running_farm() as farm:
        folder = pathlib.Path(name)
        job = farm.submit(MODEL)
        assert farm.await_end()[0]["state"] == "JOB_STATE_SUCCEEDED"
        check_artifacts(farm, job, folder)
        check_events(farm, job)
        check_meshes(farm, folder)
        check_scripts(farm, job, folder)
        check_queue(farm)
        check_waiting(farm)
    print("artifacts, events, meshes, usage and changes are as they should be")


if __name__ == "__main__":
    main(*sys.argv[1:])
