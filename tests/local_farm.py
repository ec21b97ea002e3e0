"""Farm of real processes on this machine, for programs that load it or kill parts of it."""
import contextlib
import http.client
import json
import os
import pathlib
import random
import signal
import socket
import subprocess
import tempfile
import threading
import time
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parent.parent
BIN = pathlib.Path(os.environ.get("SLICEFARM_BIN", ROOT / "build/bin"))
MODELS = ROOT / "tests/corpus/models"
OPEN = ("JOB_STATE_QUEUED", "JOB_STATE_RUNNING")


PORTS = set()  # ports that were returned


def free_port():
    """Returns a free port, a different one at each call, because an earlier caller may not listen on its port yet."""
    while True:
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        if port not in PORTS:
            PORTS.add(port)
            return port


class Service:
    """Program that keeps its address when it is restarted."""

    def __init__(self, name, log, *arguments, programs=BIN):
        self.name, self.log, self.port, self.metrics_port = name, log, free_port(), free_port()
        self.address = f"127.0.0.1:{self.port}"
        program = programs / f"slicefarm-{name.split('-')[0]}"
        self.command = [program, "--listen", self.address, "--metrics-port", str(self.metrics_port), *arguments]
        self.process = None

    def start(self):
        with open(self.log / f"{self.name}.log", "ab") as log:
            self.process = subprocess.Popen(self.command, stdout=log, stderr=log, stdin=subprocess.DEVNULL)

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()

    def pause(self, seconds):
        """Stops the process for some seconds, like a swapping machine or a debugger, and continues it."""
        self.process.send_signal(signal.SIGSTOP)
        time.sleep(seconds)
        self.process.send_signal(signal.SIGCONT)

    def stop(self):
        self.process.terminate()
        self.process.wait()

    def cpu_s(self):
        """Returns the CPU seconds of the current process."""
        fields = self.proc("stat").rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def rss_mib(self):
        return int(self.proc("statm").split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20

    def descriptors(self):
        return len(os.listdir(f"/proc/{self.process.pid}/fd"))

    def proc(self, name):
        return pathlib.Path(f"/proc/{self.process.pid}/{name}").read_text()

    def metric(self, name):
        """Returns the sum of a metric over its labels; None while the service does not answer."""
        try:
            with urllib.request.urlopen(f"http://127.0.0.1:{self.metrics_port}/metrics", timeout=2) as page:
                lines = page.read().decode().splitlines()
        except (OSError, http.client.HTTPException):  # the service may be killed while it answers
            return None
        return sum(float(line.split()[-1]) for line in lines if line.startswith(name))


class Postgres:
    name = "postgres"

    def __init__(self, directory):
        self.directory = directory
        self.start()

    def run(self, command):
        script = ROOT / "deploy/postgres/server.sh"
        return subprocess.run([script, command, self.directory], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()

    def start(self):
        self.connection = self.run("start")

    def kill(self):
        self.run("kill")

    def stop(self):
        self.run("stop")


class FakeS3:
    """Bucket of fake_s3.py, whose objects survive a kill. `rate`: share of its answers that are faults."""

    name = "s3"

    def __init__(self, directory, rate=0.0, seed=1):
        self.port = free_port()
        self.command = ["python3", ROOT / "tests/fake_s3.py", "--dir", directory, "--port", str(self.port), "--rate", str(rate), "--seed", str(seed)]
        self.url = f"http://127.0.0.1:{self.port}/farm"
        self.environment = {"AWS_ACCESS_KEY_ID": "access", "AWS_SECRET_ACCESS_KEY": "secret"}
        self.start()

    def start(self):
        self.process = subprocess.Popen(self.command, stdout=subprocess.PIPE, stdin=subprocess.DEVNULL)
        self.process.stdout.readline()  # waits until it listens

    def counts(self):
        with urllib.request.urlopen(f"http://127.0.0.1:{self.port}/counts") as answer:
            return json.loads(answer.read())

    def kill(self):
        self.process.kill()
        self.process.wait()

    stop = kill


class Farm:
    """Farm with workers of one slot each. It has one coordinator with SQLite, two with PostgreSQL, or two with
    PostgreSQL and a bucket (`s3`), of whose answers the share `s3_faults` are faults. `split`: starts `workers`
    replicas of each layer stage instead of workers. `extra`: arguments of the coordinators. `postgres`: a running
    server that several farms share. `programs`: folder of the farm's programs.
    """

    def __init__(self, store, directory, workers=2, split=False, extra=(), postgres=None, programs=BIN, s3_faults=0.0):
        directory = pathlib.Path(directory)
        directory.chmod(0o755)  # PostgreSQL's user must be able to enter it
        self.log = directory / "log"
        self.log.mkdir()
        name_of = f"{directory.name}-" if postgres else ""
        singles = [Service(name, self.log, programs=programs) for name in ("slicing", "planning", "motion", "exposure", "milling", "texture")]
        stages = ("beading", "infill", "ordering") if split else ("worker",)
        slots = [] if split else ["--slots", "1"]
        self.workers = [Service(f"{name}-{i + 1}", self.log, *slots, programs=programs) for name in stages for i in range(workers)]
        arguments = [part for service in singles for part in (f"--{service.name}", service.address)]
        for name in stages if workers else ():
            addresses = [service.address for service in self.workers if service.name.startswith(name)]
            arguments += ["--workers" if name == "worker" else f"--{name}", ",".join(addresses)]
        self.postgres = postgres or (Postgres(directory / "postgres") if store in ("postgres", "s3") else None)
        self.owns_postgres = postgres is None
        if self.postgres:
            state = ["--postgres", self.postgres.connection]
        else:
            state = ["--state-dir", str(directory / "state")]
        self.s3 = FakeS3(directory / "s3", s3_faults) if store == "s3" else None
        if self.s3:
            os.environ.update(self.s3.environment)  # environment of the coordinators
            state += ["--s3", self.s3.url]
        self.coordinators = [
            Service(f"coordinator-{i}", self.log, "--name", f"{name_of}coordinator-{i}", *state, *arguments, *extra, programs=programs)
            for i in range(1, 3 if self.postgres else 2)
        ]
        self.services = [*singles, *self.workers, *self.coordinators]
        for service in self.services:
            service.start()
        self.victims = [*self.services, *(store for store in (self.postgres, self.s3) if store)]

    def await_serving(self):
        """Waits until each service answers. A service that has ended is an error with the beginning of its log,
        since its clients would wait for it forever.
        """
        for service in self.services:
            while service.metric("slicefarm_") is None:
                if service.process.poll() is not None:
                    raise RuntimeError(f"{service.name} ended: {(self.log / f'{service.name}.log').read_text()[:1000]}")
                time.sleep(0.05)

    def client(self, *arguments, coordinator=None):
        coordinator = coordinator or random.choice(self.coordinators)
        generic = ["--generic"] if arguments[0] == "submit" else []
        command = [BIN / "slicefarm", *arguments, *generic, "--server", coordinator.address, "--patience", "120"]
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def submit(self, model, *arguments, coordinator=None):
        """Submits a job and returns its id when it is acknowledged."""
        done = self.client("submit", model, "--detach", "-q", *arguments, coordinator=coordinator)
        assert done.returncode == 0, done.stderr
        return done.stdout.strip()

    def load(self, *arguments, coordinator=None):
        """Returns the report of one run of slicefarm-load."""
        coordinator = coordinator or self.coordinators[0]
        report = self.log / f"load-{time.monotonic_ns()}.json"
        command = [BIN / "slicefarm-load", "--server", coordinator.address, "--json", report, *arguments]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return json.loads(report.read_text())

    def await_end(self, patience_s=600):
        """Waits until no job is open any more or the patience ends; returns all jobs."""
        until = time.monotonic() + patience_s
        while time.monotonic() < until:
            jobs = self.jobs()
            if jobs is not None and all(job["state"] not in OPEN for job in jobs):
                return jobs
            time.sleep(0.2)
        return self.jobs() or []

    def has_work(self):
        open_jobs = [
            (c.metric('slicefarm_jobs{state="QUEUED"}') or 0) + (c.metric('slicefarm_jobs{state="RUNNING"}') or 0)
            for c in self.coordinators
        ]
        return max(open_jobs) > 0

    def jobs(self):
        listed = self.client("list", "--json", "--limit", "100000")
        if listed.returncode != 0:
            return None
        jobs = json.loads(listed.stdout)
        return jobs.get("jobs", []) if isinstance(jobs, dict) else jobs

    def stop(self):
        for service in reversed(self.services):
            service.stop()
        if self.postgres and self.owns_postgres:
            self.postgres.stop()
        if self.s3:
            self.s3.stop()


def call(farm, *arguments):
    """Returns the output of a client, which must succeed."""
    done = farm.client(*arguments)
    assert done.returncode == 0, (arguments, done.stderr)
    return done.stdout


@contextlib.contextmanager
def running_farm(store="sqlite", directory=None, **options):
    """Provides a running Farm and stops it at the end. Without `directory` it uses a temporary directory, which is
    deleted at the end.
    """
    with contextlib.ExitStack() as ending:
        directory = directory or ending.enter_context(tempfile.TemporaryDirectory(prefix="slicefarm-"))
        farm = Farm(store, directory, **options)
        ending.callback(farm.stop)
        farm.await_serving()
        yield farm


class Progress:
    """Times at which ranges were finished, found by polling."""

    def __init__(self, coordinators):
        self.coordinators, self.times, self.ended = coordinators, [], threading.Event()
        self.thread = threading.Thread(target=self.run)
        self.thread.start()

    def run(self):
        last = {}
        while not self.ended.wait(0.02):
            for coordinator in self.coordinators:
                finished = coordinator.metric('slicefarm_ranges_total{outcome="ok"}') or 0
                if finished > last.get(coordinator.name, 0):
                    self.times.append(time.monotonic())
                last[coordinator.name] = finished

    def stop(self):
        self.ended.set()
        self.thread.join()

    def recovery_s(self, since):
        return next((t - since for t in self.times if t > since), None)


def percentile(values, part):
    values = sorted(values)
    return values[min(len(values) - 1, int(part * len(values)))] if values else 0.0
