"""Lets a tenant upload until its budget is reached. Measures the stored data and checks that further uploads are
refused. A client waits as long as a refusal requests, so each client gets some seconds."""
import json
import pathlib
import subprocess
import tempfile
import time

from local_farm import BIN, running_farm

BUDGET = 8 << 20
MESH = 1 << 20
UPLOADS = 16
PATIENCE_S = 10


def meshes(directory):
    """Writes different files of about MESH bytes each."""
    facet = "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 1\nendloop\nendfacet\n"
    for number in range(UPLOADS):
        path = pathlib.Path(directory) / f"{number}.stl"
        path.write_text(f"solid {number}\n" + facet * (MESH // len(facet)) + "endsolid\n")
        yield path


def uploading(farm, token, mesh):
    command = [BIN / "slicefarm", "submit", mesh, "--detach", "-q", "--generic", "--token-file", token, "--server", farm.coordinators[0].address]
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def measure():
    with tempfile.TemporaryDirectory(prefix="slicefarm-exhaust-") as directory:
        made = subprocess.run([BIN / "slicefarm", "token"], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
        token, file = pathlib.Path(directory) / "token", pathlib.Path(directory) / "tenants.json"
        token.write_text(made[0])
        file.write_text(json.dumps({"tenants": {"hog": {"tokens": [json.loads(made[1])], "max_kept_bytes": BUDGET}}}))
        with running_farm("postgres", directory, extra=["--tenants", str(file)]) as farm:
            while farm.coordinators[0].metric("slicefarm_workers") is None:
                time.sleep(0.2)
            clients = [uploading(farm, token, mesh) for mesh in meshes(directory)]
            until = time.monotonic() + PATIENCE_S
            while any(client.poll() is None for client in clients) and time.monotonic() < until:
                time.sleep(0.2)
            taken = sum(client.poll() == 0 for client in clients)
            for client in clients:
                client.kill()
                client.wait()
            kept = subprocess.run(["psql", "-At", farm.postgres.connection, "-c",
                                   "SELECT coalesce(sum(size), 0) FROM blobs WHERE digest IN (SELECT digest FROM inputs)"],
                                  check=True, stdout=subprocess.PIPE, text=True).stdout
            yield "disk_uploads_taken", taken, BUDGET // MESH
            yield "disk_none_taken", int(taken == 0), 0
            yield "disk_bytes_of_models", int(kept), BUDGET
