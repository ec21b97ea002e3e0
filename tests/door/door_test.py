#!/usr/bin/env python3
"""Attacks a farm through its door (`deploy/local.sh up --proxy`). The farm must keep serving other clients, keep its
memory bounded, and work afterwards. tests/bench/door.py measures how long calls take during an attack.

usage: door_test.py [--tls] [ATTACK...]
"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile

from door_farm import BIN, MODELS, ROOT, Honest, MemoryGrowth, door_farm
from http2_attacks import Door, endless_headers, endless_integers, idle, rapid_reset, slow_uploads

MAX_GROWTH_MIB = 100
MODEL = MODELS / "textbox.stl"


def close_all(held):
    for connection in held:
        connection.close()


class Held:
    """Connections that stay open while honest calls are made."""

    def __init__(self, connections):
        self.connections = connections if isinstance(connections, list) else [connections]


ATTACKS = {
    "rapid-reset": lambda door: rapid_reset(door, 100_000),
    "endless-headers": lambda door: endless_headers(door, 200),
    "endless-integers": lambda door: endless_integers(door, 200),
    "idle": lambda door: Held(idle(door, 5000)),
    "idle-greeted": lambda door: Held(idle(door, 2000, greet=True)),
    "slow-uploads": lambda door: Held(slow_uploads(door, 120)),
}


def submit(farm, out, *settings):
    done = farm.client("submit", str(MODEL), "--generic", "-q", "-o", str(out), *settings)
    assert done.returncode == 0, done.stderr
    assert out.stat().st_size > 10_000
    out.unlink()


def check_attack(farm, name, folder):
    door = Door(farm.port, files=farm.of_attacker)
    growth, honest = MemoryGrowth(farm.pids()), Honest(lambda: farm.client("list"))
    try:
        held = ATTACKS[name](door)
        if isinstance(held, Held):  # uploads must still be possible beside the attack
            submit(farm, folder / f"{name}.gcode", "--set", f"fill_density={len(name)}")
    finally:
        honest.stop()
    if isinstance(held, Held):
        close_all(held.connections)
    assert not honest.failures, (name, honest.failures[:3])
    mib = growth.mib()
    print(f"{name}: {honest.calls} calls beside it, +{mib:.0f} MiB")
    assert mib <= MAX_GROWTH_MIB, (name, mib)
    submit(farm, folder / "after.gcode", "--set", f"fill_density={20 + len(name)}")


def check_descriptors(farm, folder):
    """Checks that a door without free file descriptors closes idle connections and accepts other clients."""
    with tempfile.TemporaryDirectory() as directory:
        port = farm.port + 15
        command = ["prlimit", "--nofile=400", ROOT / "deploy/proxy/proxy.sh", "--listen", f"127.0.0.1:{port}", "--coordinators",
                   f"127.0.0.1:{coordinator_port(farm)}", "--coordinator-name", "localhost", "--dir", directory]
        certs = farm.state / "certs/proxy"
        environment = farm.environment | ({f"SLICEFARM_TLS_{name.upper()}": f"{certs}/{name}.pem" for name in ("cert", "key", "ca")}
                                          if farm.tls else {})
        narrow = subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)
        assert narrow.stdout.readline().startswith("listening on ")
        held = idle(Door(port, files=farm.of_attacker), 1500)
        for _ in range(5):
            done = farm.client("list", port=port)
            assert done.returncode == 0, done.stderr
        close_all(held)
        assert farm.client("list", port=port).returncode == 0
        narrow.terminate()
        narrow.wait()
    print("descriptors: exhausted, and served")


def check_restart(farm, folder):
    """Checks that a coordinator that was killed by a signal is restarted, and that the door reaches it again."""
    killed = farm.pid("coordinator-1")
    os.kill(killed, signal.SIGKILL)
    submit(farm, folder / "restarted.gcode", "--set", "fill_density=77", "--patience", "120")
    assert farm.pid("coordinator-1") != killed
    print("restart: found again")


def coordinator_port(farm):
    line = next(line for line in (farm.state / "log/coordinator-1.log").read_text().splitlines() if line.startswith("listening on "))
    return int(line.rsplit(":", 1)[1])


CHECKS = {"descriptors": check_descriptors, "restart": check_restart}


def main():
    tls = "--tls" in sys.argv
    wanted = [argument for argument in sys.argv[1:] if argument != "--tls"] or [*ATTACKS, *CHECKS]
    with door_farm(tls) as farm, tempfile.TemporaryDirectory() as folder:
        submit(farm, pathlib.Path(folder) / "before.gcode")
        for name in wanted:
            if name in CHECKS:
                CHECKS[name](farm, pathlib.Path(folder))
            else:
                check_attack(farm, name, pathlib.Path(folder))


if __name__ == "__main__":
    main()
