"""Farm behind its door, as `deploy/local.sh up --proxy` starts it, for the programs that attack it."""
import contextlib
import os
import pathlib
import resource
import socket
import subprocess
import sys
import tempfile
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from local_farm import BIN, MODELS, ROOT

# Attacks open thousands of connections.
resource.setrlimit(resource.RLIMIT_NOFILE, (resource.getrlimit(resource.RLIMIT_NOFILE)[1],) * 2)

SERVICES = 16  # ports above the door's port that the farm may use


def free_range():
    """Returns the first port of a range of free ports."""
    for base in range(21000, 32000, 2 * SERVICES):
        with contextlib.ExitStack() as probes:
            try:
                for port in range(base, base + SERVICES):
                    probes.enter_context(socket.socket()).bind(("127.0.0.1", port))
                return base
            except OSError:
                continue
    raise RuntimeError("no free ports")


def status_kib(pid, field):
    """Returns VmRSS, or VmHWM (the peak of VmRSS), of a process in KiB; 0 if the process has ended."""
    try:
        lines = pathlib.Path(f"/proc/{pid}/status").read_text().splitlines()
    except (OSError, ProcessLookupError):
        return 0
    return next((int(line.split()[1]) for line in lines if line.startswith(field + ":")), 0)


class DoorFarm:
    def __init__(self, folder, tls, *arguments):
        self.state, self.port, self.tls = pathlib.Path(folder), free_range(), tls
        self.environment = os.environ | {"SLICEFARM_STATE": str(self.state), "SLICEFARM_BIN": str(BIN)}
        self.environment.pop("SLICEFARM_POSTGRES", None)
        self.local("up", "--proxy", "--port", str(self.port), "--workers", "1", *(["--tls"] if tls else []), *arguments)
        if tls:
            subprocess.run([ROOT / "deploy/dev-certs.sh", self.state / "certs", "tenant/evil"], check=True)
            self.files, self.of_attacker = self.state / "certs/tenant-dev", self.state / "certs/tenant-evil"
            self.environment |= {"SLICEFARM_TLS_CERT": f"{self.files}/cert.pem", "SLICEFARM_TLS_KEY": f"{self.files}/key.pem",
                                 "SLICEFARM_TLS_CA": f"{self.files}/ca.pem", "SLICEFARM_TLS_SERVER_NAME": "localhost"}
        else:
            self.of_attacker = None

    def local(self, *arguments):
        run = subprocess.run([ROOT / "deploy/local.sh", *arguments], env=self.environment, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT, text=True)
        if run.returncode != 0:
            logs = "\n".join(f"{log}: {log.read_text()[-2000:]}" for log in (self.state / "log").glob("*.log"))
            raise RuntimeError(f"local.sh {arguments}: {run.stdout}\n{logs}")

    def client(self, *arguments, port=None):
        command = [BIN / "slicefarm", *arguments, "--server", f"127.0.0.1:{port or self.port}"]
        return subprocess.run(command, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def pid(self, name):
        return int((self.state / f"pid/{name}.pid").read_text())

    def door_pids(self):
        """Returns the pids of nginx and its workers."""
        master = int((self.state / "proxy/nginx.pid").read_text())
        return [master, *map(int, pathlib.Path(f"/proc/{master}/task/{master}/children").read_text().split())]

    def pids(self):
        """Returns the pids of the processes whose memory an attack may fill: the door and the coordinator."""
        return [*self.door_pids(), self.pid("coordinator-1")]

    def down(self):
        self.local("down")


@contextlib.contextmanager
def door_farm(tls, *arguments):
    with tempfile.TemporaryDirectory(prefix="slicefarm-") as folder:
        pathlib.Path(folder).chmod(0o755)
        farm = DoorFarm(folder, tls, *arguments)
        try:
            yield farm
        finally:
            farm.down()


class MemoryGrowth:
    """Sum of the peak memory growth of some processes since construction, in MiB."""

    def __init__(self, pids):
        self.before = {pid: status_kib(pid, "VmRSS") for pid in pids}
        for pid in pids:
            pathlib.Path(f"/proc/{pid}/clear_refs").write_text("5")  # resets the peak to the current value

    def mib(self):
        return sum(max(0, status_kib(pid, "VmHWM") - before) for pid, before in self.before.items()) / 1024


class Honest:
    """Client that repeats a call until it is stopped; `failures` contains the error output of its failed calls."""

    def __init__(self, call):
        self.call, self.calls, self.failures, self.ended = call, 0, [], threading.Event()
        self.thread = threading.Thread(target=self.run)
        self.thread.start()

    def run(self):
        while not self.ended.is_set() or not self.calls:
            done = self.call()
            self.calls += 1
            if done.returncode != 0:
                self.failures.append(done.stderr)

    def stop(self):
        self.ended.set()
        self.thread.join()
