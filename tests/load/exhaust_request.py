"""Sends requests that need more work than their size suggests, at the limit and beyond. Measures the CPU time and the
memory of the coordinator for each, and checks that a request ends with a job or a typed error. Then sends sixteen of
each at once and measures the largest memory of the services. Needs protoc, and curl with HTTP/2."""
import concurrent.futures
import hashlib
import pathlib
import re
import struct
import subprocess
import tempfile

from local_farm import MODELS, ROOT, running_farm

PROTO = ROOT / "proto"
MODEL = MODELS / "textbox.stl"
# Limits of a refusal: CPU seconds and MiB.
CPU_S, MEMORY_MIB = 0.2, 64
AT_ONCE = 16
SERVICE_MIB = 4096


def setting(key, value):
    return f'{{key: "{key}" value: "{value}"}}'


def field(size):
    """Returns a density field of `size` bytes."""
    text = '{"kind":"constant","density":0.3' + " " * (size - 33) + "}"
    return setting("density_field", text.replace('"', '\\"'))


def ranges(count):
    """Returns height ranges, each with settings of its own."""
    return " ".join(
        f"height_ranges {{from_mm: {0.02 * i:.2f} to_mm: {0.02 * (i + 1):.2f} "
        f"settings {setting('perimeters', 1 + i % 97)} settings {setting('fill_angle', i % 89)}}}"
        for i in range(count)
    )


def job(digest, objects="", settings=()):
    listed = " ".join(f"settings {each}" for each in settings)
    return f'spec {{objects {{mesh_sha256: "{digest}" name: "box" {objects}}} {listed} generic: true}}'


def plates(digest, copies, settings):
    many = " ".join(f'requests {{{job(digest, f"copies: 100", settings)}}}' for _ in range(copies))
    return many + " validate_only: true"


def cases(digest):
    """Yields the name, the method and the request as text."""
    lines = setting("layer_gcode", "; " + "x" * 60_000)
    yield "field_at_limit", "CreateJob", job(digest, ranges(80), [field(450_000)])
    yield "field_beyond", "CreateJob", job(digest, ranges(1_000), [field(450_000)])
    yield "field_far_beyond", "CreateJob", job(digest, ranges(10_000), [field(300_000)])
    yield "plates_beyond", "CreatePlates", plates(digest, 10, [setting("start_gcode", "; " + "x" * 60_000)] * 3)
    yield "layer_gcode", "CreateJob", job(digest, "", [lines])


class Coordinator:
    def __init__(self, service):
        self.service = service

    def call(self, method, text):
        """Returns the gRPC status and the size of the encoded request."""
        request = "CreatePlatesRequest" if method == "CreatePlates" else "CreateJobRequest"
        encoded = subprocess.run(
            ["protoc", f"-I{PROTO}", f"--encode=slicefarm.v1.{request}", "slicefarm/v1/jobs.proto"],
            input=text.encode(), check=True, stdout=subprocess.PIPE,
        ).stdout
        with tempfile.NamedTemporaryFile() as body:
            body.write(b"\0" + struct.pack(">I", len(encoded)) + encoded)
            body.flush()
            done = subprocess.run(
                ["curl", "-s", "-D", "-", "-o", "/dev/null", "--http2-prior-knowledge", "-X", "POST", "-H", "te: trailers",
                 "-H", "content-type: application/grpc", "--data-binary", f"@{body.name}",
                 f"http://{self.service.address}/slicefarm.v1.Jobs/{method}"],
                stdout=subprocess.PIPE, text=True,
            )
        status = re.search(r"^grpc-status: (\d+)", done.stdout, re.MULTILINE | re.IGNORECASE)
        return (int(status[1]) if status else -1), len(encoded)


def most_mib(service):
    found = re.search(r"^VmHWM:\s+(\d+)", service.proc("status"), re.MULTILINE)
    return int(found[1]) / 1024


def forget_most(service):
    pathlib.Path(f"/proc/{service.process.pid}/clear_refs").write_text("5")


def at_once(farm, coordinator, name, method, text):
    for service in farm.services:
        forget_most(service)
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as calls:
        statuses = [call.result()[0] for call in [calls.submit(coordinator.call, method, text) for _ in range(AT_ONCE)]]
    farm.await_end()
    # 3: INVALID_ARGUMENT; 8: RESOURCE_EXHAUSTED
    yield f"request_{name}_at_once_untyped", sum(status not in (0, 3, 8) for status in statuses), 0
    for service in (farm.coordinators[0], farm.services[0]):
        yield f"request_{name}_at_once_{service.name}_mib", most_mib(service), SERVICE_MIB


def measure():
    digest = hashlib.sha256(MODEL.read_bytes()).hexdigest()
    with running_farm() as farm:
        farm.submit(MODEL)
        farm.await_end()
        coordinator = Coordinator(farm.coordinators[0])
        for name, method, text in cases(digest):
            forget_most(farm.coordinators[0])
            memory, cpu = farm.coordinators[0].rss_mib(), farm.coordinators[0].cpu_s()
            status, size = coordinator.call(method, text)
            refused = status == 3  # INVALID_ARGUMENT
            yield f"request_{name}_kib", size / 1024, None
            yield f"request_{name}_untyped", status not in (0, 3), 0
            yield f"request_{name}_cpu_s", farm.coordinators[0].cpu_s() - cpu, CPU_S if refused else None
            yield f"request_{name}_mib", most_mib(farm.coordinators[0]) - memory, MEMORY_MIB if refused else None
            farm.await_end()
            yield from at_once(farm, coordinator, name, method, text)
        farm.submit(MODEL, "--set", "perimeters=3")
        yield "request_jobs_that_fail_after", sum(job["state"] != "JOB_STATE_SUCCEEDED" for job in farm.await_end()[-1:]), 0
