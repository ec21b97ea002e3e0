#!/usr/bin/python3
"""Measures the effect of attacks through the farm's door on other clients: times of honest calls alone and beside each
attack, memory of the door and the coordinator, and the time of a job after the attack. Run it with Debian's python3,
which has Debian's grpc.

usage: door.py [--tls] [--seconds S] [ATTACK...]
"""
import argparse
import pathlib
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "door"))
import grpc
from door_farm import MODELS, MemoryGrowth, door_farm
from http2_attacks import Door, endless_headers, endless_integers, idle, rapid_reset, slow_uploads

LIST = "/slicefarm.v1.Jobs/ListJobs"


def held(take):
    def attack(door, ended):
        connections = take(door)
        ended.wait()
        for connection in connections if isinstance(connections, list) else [connections]:
            connection.close()
        return len(connections) if isinstance(connections, list) else 1
    return attack


def again(take):
    def attack(door, ended):
        connections = 0
        while not ended.is_set():
            connections += take(door)
        return connections
    return attack


ATTACKS = {
    "rapid reset": again(lambda door: rapid_reset(door, 20_000)),
    "endless headers": again(lambda door: endless_headers(door, 20)),
    "endless integers": again(lambda door: endless_integers(door, 20)),
    "5,000 idle": held(lambda door: idle(door, 5000)),
    "2,000 idle after their handshake": held(lambda door: idle(door, 2000, greet=True)),
    "120 slow uploads": held(lambda door: slow_uploads(door, 120)),
}


def channel_to(farm):
    address = f"127.0.0.1:{farm.port}"
    if not farm.tls:
        return grpc.insecure_channel(address)
    ca, key, cert = ((farm.files / f"{name}.pem").read_bytes() for name in ("ca", "key", "cert"))
    credentials = grpc.ssl_channel_credentials(ca, key, cert)
    return grpc.secure_channel(address, credentials, [("grpc.ssl_target_name_override", "localhost")])


def call_times(call, seconds):
    """Makes calls one after another, at most 50 per second; returns the sorted times of the successful calls and the
    errors of the failed calls.
    """
    times, failed, until = [], [], time.monotonic() + seconds
    while time.monotonic() < until:
        begin = time.monotonic()
        try:
            call(b"", timeout=30)
            times.append(time.monotonic() - begin)
        except grpc.RpcError as error:
            failed.append(f"{error.code().name}: {error.details()}")
        time.sleep(0.02)
    return sorted(times), failed


def row(name, times, failed, *more):
    p50, p99 = (1000 * times[min(len(times) - 1, int(part * len(times)))] for part in (0.5, 0.99))
    print(f"| {name} | {len(times)} | {p50:.1f} | {p99:.1f} | {len(failed)} | {' | '.join(more)} |", flush=True)
    for failure in failed[:2]:
        print(f"  {failure}")
    return p50, p99


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tls", action="store_true")
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("attacks", nargs="*")
    options = parser.parse_args()
    with door_farm(options.tls) as farm, tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.gcode"
        call = channel_to(farm).unary_unary(LIST)
        call_times(call, 2)
        print("| beside | calls | p50 ms | p99 ms | failed | + MiB | connections | job after, s |\n|---|---|---|---|---|---|---|---|")
        row("nothing", *call_times(call, options.seconds), "", "", "")
        for number, name in enumerate(options.attacks or ATTACKS):
            growth, ended, used = MemoryGrowth(farm.pids()), threading.Event(), []
            door = Door(farm.port, files=farm.of_attacker)
            attacker = threading.Thread(target=lambda name=name: used.append(ATTACKS[name](door, ended)))
            attacker.start()
            times, failed = call_times(call, options.seconds)
            ended.set()
            attacker.join()
            begin = time.monotonic()
            done = farm.client("submit", str(MODELS / "textbox.stl"), "--generic", "-q", "-o", str(out), "--set", f"fill_density={10 + number}")
            after = f"{time.monotonic() - begin:.1f}" if done.returncode == 0 else done.stderr.strip()
            row(name, times, failed, f"{growth.mib():.0f}", str(used[0]), after)


if __name__ == "__main__":
    main()
