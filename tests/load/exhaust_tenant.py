"""One tenant takes every place that it can get, uploads that bring next to nothing, downloads and jobs, and another one goes on
beside it: what the other's calls take then, against what they took alone. Needs curl with HTTP/2 for the uploads."""
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
UPLOADS = 80  # more than there are places for
WATCHES = 40
MODEL = sorted(MODELS.glob("*.stl"))[0]


def make_tenants(path):
    tokens, tenants = {}, {}
    for name in ("hog", "calm"):
        made = subprocess.run([BIN / "slicefarm", "token"], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
        tokens[name] = path.with_name(f"{name}.token")
        tokens[name].write_text(made[0])
        tenants[name] = {"tokens": [json.loads(made[1])], "max_open_jobs": 100_000}
    path.write_text(json.dumps({"tenants": tenants}))
    return tokens


def first_chunk(number):
    """UploadMeshRequest of a mesh of 1 GB: sha256 = 1, size = 2, data = 4 with a byte."""
    digest = f"{number:064x}".encode()
    size = 1 << 30
    varint = bytes((size >> shift & 0x7F) | (0x80 if size >> shift + 7 else 0) for shift in range(0, 35, 7))
    message = b"\x0a" + bytes([len(digest)]) + digest + b"\x10" + varint.rstrip(b"\0") + b"\x22\x01x"
    return b"\0" + struct.pack(">I", len(message)) + message


class Trickle(threading.Thread):
    """An upload of a byte now and then, begun anew whenever it ends: how long it held its place, at most."""

    def __init__(self, address, token, number, ended):
        super().__init__()
        self.command = ["curl", "-s", "--http2-prior-knowledge", "-T", "-", "-X", "POST", "-H", "te: trailers",
                        "-H", "content-type: application/grpc", "-H", f"authorization: Bearer {token}",
                        f"http://{address}/slicefarm.v1.Meshes/UploadMesh"]
        self.chunk, self.ended, self.longest_s = first_chunk(number), ended, 0.0
        self.start()

    def run(self):
        while not self.ended.is_set():
            begun = time.monotonic()
            with subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, bufsize=0) as call:
                try:
                    call.stdin.write(self.chunk)
                    while call.poll() is None and not self.ended.wait(1):
                        call.stdin.write(b"\0\0\0\0\x03\x22\x01x")
                except BrokenPipeError:
                    pass
                call.send_signal(signal.SIGKILL)
            self.longest_s = max(self.longest_s, time.monotonic() - begun)
            self.ended.wait(0.5)


def call_s(farm, token, *arguments):
    begun = time.monotonic()
    done = farm.client(*arguments, "--token-file", token)
    return time.monotonic() - begun, done.returncode


def calm_calls(farm, token, seconds):
    """Seconds that each kind of call takes, and how many fail."""
    times, failed = {"submit": [], "list": [], "check": []}, 0
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        for kind, arguments in (("submit", ("submit", MODEL, "-q", "-o", os.devnull)), ("list", ("list", "--limit", "1")),
                                ("check", ("check", MODEL))):
            took, code = call_s(farm, token, *arguments)
            times[kind].append(took)
            failed += code != 0
    return times, failed


def hog(farm, tokens, ended):
    token = tokens["hog"].read_text().strip()
    address = farm.coordinators[0].address
    trickles = [Trickle(address, token, n, ended) for n in range(UPLOADS)]
    flood = subprocess.Popen([BIN / "slicefarm-load", "--server", address, "--token-file", tokens["hog"], "--rate", "50",
                              "--seconds", "3600", "--in-flight", "2048", "--mix", "tiny"], stdout=subprocess.DEVNULL)
    checks = [threading.Thread(target=lambda: [call_s(farm, tokens["hog"], "check", MODEL) for _ in iter(ended.is_set, True)])
              for _ in range(8)]
    for check in checks:
        check.start()
    return trickles, flood, checks


def measure():
    with tempfile.TemporaryDirectory(prefix="slicefarm-exhaust-") as directory:
        file = pathlib.Path(directory) / "tenants.json"
        tokens = make_tenants(file)
        with running_farm(directory=directory, extra=["--tenants", str(file)]) as farm:
            alone, failed_alone = calm_calls(farm, tokens["calm"], SECONDS)
            ended = threading.Event()
            trickles, flood, checks = hog(farm, tokens, ended)
            time.sleep(5)
            beside, failed = calm_calls(farm, tokens["calm"], SECONDS)
            ended.set()
            flood.kill()
            for thread in (*trickles, *checks):
                thread.join()
            for kind, times in beside.items():
                before = percentile(alone[kind], 0.99)
                yield f"tenant_{kind}_alone_p99_ms", 1000 * before, None
                yield f"tenant_{kind}_beside_p99_ms", 1000 * percentile(times, 0.99), 2000 * before
            yield "tenant_calm_calls_failed", failed + failed_alone, 0
            yield "tenant_trickle_held_s", max(t.longest_s for t in trickles), 65
