#!/usr/bin/python3
"""Tests a client in another language: docs/print_plate.py prints plate 2 of a Bambu 3MF in at most 62 lines. It uses
Debian's Python, our public protos, and Google's google/rpc, with which it shows the reason of a failed call or job.
Run it with Debian's python3, because another python3 in the PATH does not have Debian's modules.

usage: python_client_test.py SLICEFARM
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parent), str(pathlib.Path(__file__).resolve().parent.parent)]
from local_farm import ROOT, running_farm
from project_test import bambu_files, write

CLIENT = ROOT / "docs/print_plate.py"
PUBLIC = ["jobs", "presets", "mesh", "geometry", "process"]
# Google's definition, reduced to the part that the test needs. It differs from proto/google/rpc, so both in one program would be
# an error.
STATUS = """syntax = "proto3"; package google.rpc; import "google/protobuf/any.proto";
message Status { int32 code = 1; string message = 2; repeated google.protobuf.Any details = 3; }
"""
DETAILS = """syntax = "proto3"; package google.rpc;
message ErrorInfo { string reason = 1; string domain = 2; map<string, string> metadata = 3; }
message DebugInfo { repeated string stack_entries = 1; string detail = 2; }
message Help { message Link { string description = 1; string url = 2; } repeated Link links = 1; }
"""


def make_stubs(folder):
    google = folder / "of_google/google/rpc"
    google.mkdir(parents=True)
    (google / "status.proto").write_text(STATUS)
    (google / "error_details.proto").write_text(DETAILS)
    plugin = "--plugin=protoc-gen-grpc=/usr/bin/grpc_python_plugin"
    subprocess.run(["protoc", "-I", ROOT / "proto", f"--python_out={folder}", f"--grpc_out={folder}", plugin,
                    *(f"slicefarm/v1/{name}.proto" for name in PUBLIC)], cwd=ROOT / "proto", check=True)
    subprocess.run(["protoc", "-I", folder / "of_google", f"--python_out={folder}", "google/rpc/status.proto",
                    "google/rpc/error_details.proto"], check=True)


def check_errors(folder, print_plate, project):
    """Checks that each failure is reported with its reason and message."""
    def failure(*arguments):
        done = print_plate(*arguments)
        assert done.returncode == 1 and not (folder / "none.gcode").exists(), done
        return done.stderr.splitlines()[-1]

    reason, message = failure(project, "2", folder / "none.gcode", "no-such-profile").split(": ", 1)
    assert reason == "PROFILE_NOT_FOUND" and "no-such-profile" in message, (reason, message)
    flat = {name: re.sub(r' z="([\d.]+)"', lambda z: f' z="{float(z[1]) / 1e4}"', text) for name, text in bambu_files().items()}
    reason, message = failure(write(folder / "flat.3mf", flat), "2", folder / "none.gcode").split(": ", 1)
    assert reason == "NOTHING_TO_PRINT" and message, (reason, message)


def main(program):
    assert len(CLIENT.read_text().splitlines()) <= 62
    with tempfile.TemporaryDirectory(prefix="slicefarm-") as folder, running_farm() as farm:
        folder = pathlib.Path(folder)
        make_stubs(folder)
        farm.await_serving()
        project = write(folder / "bambu.3mf", bambu_files())
        subprocess.run([program, "slice", project, "--plate", "2", "-o", folder / "want.gcode"], check=True)
        server = farm.coordinators[0].address
        environment = {**os.environ, "PYTHONPATH": str(folder)}

        def print_plate(*arguments):
            return subprocess.run([sys.executable, CLIENT, server, *arguments], env=environment, stderr=subprocess.PIPE, text=True)
        done = print_plate(project, "2", folder / "got.gcode")
        assert done.returncode == 0, done.stderr
        assert (folder / "got.gcode").read_bytes() == (folder / "want.gcode").read_bytes()
        check_errors(folder, print_plate, project)
    print("plate 2 is that of slicefarm slice, and failures are told with their reason")


if __name__ == "__main__":
    main(*sys.argv[1:])
