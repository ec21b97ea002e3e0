"""Lets one tenant take every slot that it can get: very slow uploads, downloads that are hardly read, watches of one
job and of all jobs, checks, lists, gets, and more jobs than the farm can make. Measures the calls of another tenant
beside it and alone, and checks that the first tenant is refused. The greedy tenant's hundred client processes have a
low priority, because they represent other machines. Needs curl with HTTP/2."""
import json
import os
import pathlib
import signal
import struct
import subprocess
import tempfile
import threading
import time

from local_farm import BIN, MODELS, percentile, running_farm

SECONDS = int(os.environ.get("SLICEFARM_EXHAUST_SECONDS", "60"))
ALONE_SECONDS = min(SECONDS, 300)
UPLOADS = DOWNLOADS = 80  # more than there are slots
WATCHERS = 1000  # per watched job of the greedy tenant
CHECKS = 8
TENANT_WATCHES = 40
OPEN_JOBS = {"hog": 500, "calm": 10_000}
MODEL = MODELS / "textbox.stl"
# Settings of a program that is too long for a client's buffers, so the server must wait for its
# reads.
LONG = [part for key in ("before_layer_gcode", "layer_gcode") for part in ("--set", f"{key}=; " + "x" * 60_000)]
LONG += ["--set", "layer_height=0.05", "--set", "first_layer_height=0.1"]
# Methods with slots that the greedy tenant takes.
TAKEN = ("UploadMesh", "Download", "CreateJob", "WatchJob", "WatchJobs")
STEPS = ("Upload", "CreateJob", "WatchOpen", "WatchJob", "Download")
# Smallest p99 for the comparison. Below it, a doubling cannot be distinguished from effects of the
# scheduler.
LEAST_S = 0.05
ELSEWHERE = ["nice", "-n", "19"]


def make_tenants(path):
    tokens, tenants = {}, {}
    for name in ("hog", "calm"):
        made = subprocess.run([BIN / "slicefarm", "token"], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
        tokens[name] = path.with_name(f"{name}.token")
        tokens[name].write_text(made[0])
        tenants[name] = {"tokens": [json.loads(made[1])], "max_open_jobs": OPEN_JOBS[name]}
    path.write_text(json.dumps({"tenants": tenants}))
    return tokens


def framed(message):
    return b"\0" + struct.pack(">I", len(message)) + message


def first_chunk(number):
    """Returns an UploadMeshRequest of a mesh of 1 GB: sha256 = 1, size = 2, data = 4 with one byte."""
    digest = f"{number:064x}".encode()
    return framed(b"\x0a" + bytes([len(digest)]) + digest + b"\x10\x80\x80\x80\x80\x04" + b"\x22\x01x")


class Slow(threading.Thread):
    """Makes a very slow call, and repeats it whenever it ends. Measures the longest time that a call has held its slot."""

    def __init__(self, address, token, method, first, more, ended):
        super().__init__()
        self.command = [*ELSEWHERE, "curl", "-s", "--http2-prior-knowledge", "--limit-rate", "1", "-T", "-", "-X", "POST",
                        "-H", "te: trailers", "-H", "content-type: application/grpc", "-H", f"authorization: Bearer {token}",
                        f"http://{address}/slicefarm.v1.{method}"]
        self.first, self.more, self.ended, self.longest_s = first, more, ended, 0.0
        self.start()

    def run(self):
        while not self.ended.is_set():
            begun = time.monotonic()
            with subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, bufsize=0) as call:
                try:
                    call.stdin.write(self.first)
                    if not self.more:
                        call.stdin.close()
                    while call.poll() is None and not self.ended.wait(1):
                        if self.more:
                            call.stdin.write(self.more)
                except BrokenPipeError:
                    pass
                call.send_signal(signal.SIGKILL)
            self.longest_s = max(self.longest_s, time.monotonic() - begun)
            self.ended.wait(0.5)


class Calm(threading.Thread):
    """Makes the other tenant's calls that slicefarm-load does not make, one after another."""

    CALLS = {"List": ("list", "--limit", "1"), "Check": ("submit", MODEL, "--check", "-q")}

    def __init__(self, farm, token):
        super().__init__()
        self.farm, self.token, self.ended = farm, token, threading.Event()
        self.times, self.failed = {kind: [] for kind in self.CALLS}, 0
        self.start()

    def run(self):
        while not self.ended.wait(0.5):
            for kind, arguments in self.CALLS.items():
                begun = time.monotonic()
                done = self.farm.client(*arguments, "--token-file", self.token)
                self.times[kind].append(time.monotonic() - begun)
                self.failed += done.returncode != 0


def calm_calls(farm, token, seconds):
    """Returns the p99 of each kind of call in seconds, and the number of failures."""
    others = Calm(farm, token)
    report = farm.load("--token-file", token, "--rate", "2", "--seconds", str(seconds), "--mix", "tiny")
    others.ended.set()
    others.join()
    p99 = {step: report["steps"][step]["p99"] / 1e9 for step in STEPS}
    p99 |= {kind: percentile(times, 0.99) for kind, times in others.times.items()}
    return p99, others.failed + report["arrivals"] - report["succeeded"]


class Hog:
    def __init__(self, farm, token):
        self.farm, self.token_file, self.ended = farm, token, threading.Event()
        text, address = token.read_text().strip(), farm.coordinators[0].address
        job = farm.submit(MODEL, *LONG, "--token-file", token)
        farm.client("watch", job, "--token-file", token)
        download = framed(b"\x0a" + bytes([len(job)]) + job.encode() + b"\x10\x01")  # id = 1, artifact = 2
        self.loads = [
            self.load("--scenario", "submit", "--rate", "100", "--in-flight", "2048"),
            self.load("--scenario", "watch", "--rate", "0.5", "--watchers", str(WATCHERS)),
            self.load("--scenario", "get", "--rate", "200"),
        ]
        self.await_uploads()
        self.uploads = [Slow(address, text, "Meshes/UploadMesh", first_chunk(n), framed(b"\x22\x01x"), self.ended) for n in range(UPLOADS)]
        self.downloads = [Slow(address, text, "Jobs/Download", download, b"", self.ended) for _ in range(DOWNLOADS)]
        of_all = ("events", "--json")
        calls = [self.check] * CHECKS + [lambda: self.again("list", "--limit", "1000")] + [lambda: self.again(*of_all)] * TENANT_WATCHES
        self.clients = [threading.Thread(target=call) for call in calls]
        for client in self.clients:
            client.start()

    def await_uploads(self):
        """Waits until the first jobs are refused. The jobs need uploads, and afterwards all slots for uploads are
        taken."""
        while not refused(self.farm.coordinators[0], "CreateJob"):
            time.sleep(0.1)

    def load(self, *arguments):
        command = [*ELSEWHERE, BIN / "slicefarm-load", "--server", self.farm.coordinators[0].address, "--token-file", self.token_file]
        return subprocess.Popen([*command, "--seconds", "7200", "--mix", "tiny", *arguments], stdout=subprocess.DEVNULL)

    def check(self):
        self.again("submit", MODEL, "--check", "-q", "--generic")

    def again(self, *arguments):
        """Runs a command of the client, and repeats it whenever it ends."""
        command = [*ELSEWHERE, BIN / "slicefarm", *arguments, "--token-file", self.token_file,
                   "--server", self.farm.coordinators[0].address, "--patience", "10"]
        while not self.ended.is_set():
            with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as call:
                while call.poll() is None and not self.ended.wait(0.1):
                    continue
                call.kill()

    def stop(self):
        self.ended.set()
        for load in self.loads:
            load.kill()
            load.wait()
        for thread in (*self.uploads, *self.downloads, *self.clients):
            thread.join()
        # For downloads the time is not checked, because unread bytes may be in buffers of the
        # client.
        return max(upload.longest_s for upload in self.uploads)


def refused(coordinator, method):
    return coordinator.metric(f'grpc_server_handled_total{{grpc_code="RESOURCE_EXHAUSTED",grpc_method="{method}"') or 0


def measure():
    with tempfile.TemporaryDirectory(prefix="slicefarm-exhaust-") as directory:
        file = pathlib.Path(directory) / "tenants.json"
        tokens = make_tenants(file)
        with running_farm(directory=directory, extra=["--tenants", str(file), "--jobs", "8"]) as farm:
            alone, failed_alone = calm_calls(farm, tokens["calm"], ALONE_SECONDS)
            hog = Hog(farm, tokens["hog"])
            time.sleep(5)
            beside, failed = calm_calls(farm, tokens["calm"], SECONDS)
            held_s = hog.stop()
            for kind, before in alone.items():
                yield f"tenant_{kind}_alone_p99_ms", 1000 * before, None
                yield f"tenant_{kind}_beside_p99_ms", 1000 * beside[kind], 2000 * max(before, LEAST_S)
            yield "tenant_calm_calls_failed", failed + failed_alone, 0
            yield "tenant_slow_upload_held_s", held_s, 65
            for method in TAKEN:
                count = refused(farm.coordinators[0], method)
                yield f"tenant_{method}_refused", count, None
                yield f"tenant_{method}_never_refused", count == 0, 0
