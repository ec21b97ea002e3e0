"""Tenants upload until their budget, and the database's, is reached: what is there then, and what refusals say."""
import json
import pathlib
import re
import subprocess
import tempfile

from local_farm import BIN, running_farm

BUDGET = 8 << 20
MESH = 1 << 20


def meshes(directory, count):
    """Cubes whose files differ, with as many bytes of a comment in their header as make a mesh large."""
    for number in range(count):
        path = pathlib.Path(directory) / f"{number}.stl"
        facet = "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 1\nendloop\nendfacet\n"
        path.write_text(f"solid {number}\n" + facet * (MESH // len(facet)) + "endsolid\n")
        yield path


def upload(farm, token, mesh):
    return farm.client("submit", mesh, "--detach", "-q", "--patience", "0", "--token-file", token)


def measure():
    with tempfile.TemporaryDirectory(prefix="slicefarm-exhaust-") as directory:
        made = subprocess.run([BIN / "slicefarm", "token"], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
        token, file = pathlib.Path(directory) / "token", pathlib.Path(directory) / "tenants.json"
        token.write_text(made[0])
        file.write_text(json.dumps({"tenants": {"hog": {"tokens": [json.loads(made[1])], "max_kept_bytes": BUDGET}}}))
        with running_farm("postgres", directory, extra=["--tenants", str(file)]) as farm:
            refusals = [done for done in (upload(farm, token, mesh) for mesh in meshes(directory, 16)) if done.returncode]
            used = subprocess.run(["psql", "-At", farm.postgres.connection, "-c", "SELECT coalesce(sum(size), 0) FROM blobs"],
                                  check=True, stdout=subprocess.PIPE, text=True).stdout
            yield "disk_refused_too_few", max(0, 7 - len(refusals)), 0
            yield "disk_refusals_without_reason", sum(not re.search("keep|bytes|budget", r.stderr) for r in refusals), 0
            yield "disk_bytes_of_tenant", int(used), BUDGET + MESH
