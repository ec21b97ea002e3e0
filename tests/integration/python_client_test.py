#!/usr/bin/python3
"""A client in another language: docs/print_plate.py, of 52 lines at most, prints plate 2 of a Bambu 3MF with Debian's Python, our public
protos, and Google's own google/rpc beside them, by which it reads what an error says. (Of Debian's python3, not of another one
that comes first in the PATH: its modules are Debian's.)

usage: python_client_test.py SLICEFARM
"""
import importlib
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parent), str(pathlib.Path(__file__).resolve().parent.parent)]
from local_farm import ROOT, running_farm
from project_test import bambu_files, write

CLIENT = ROOT / "docs/print_plate.py"
PUBLIC = ["jobs", "mesh", "geometry", "process"]
# As Google has it, as far as a test needs it: more than proto/google/rpc, so both in one program would be an error.
GOOGLES = """syntax = "proto3"; package google.rpc; import "google/protobuf/any.proto";
message ErrorInfo { string reason = 1; string domain = 2; map<string, string> metadata = 3; }
message DebugInfo { repeated string stack_entries = 1; string detail = 2; }
message Help { message Link { string description = 1; string url = 2; } repeated Link links = 1; }
message Status { int32 code = 1; string message = 2; repeated google.protobuf.Any details = 3; }
"""


def make_stubs(folder):
    google = folder / "of_google/google/rpc"
    google.mkdir(parents=True)
    (google / "error_details.proto").write_text(GOOGLES)
    plugin = "--plugin=protoc-gen-grpc=/usr/bin/grpc_python_plugin"
    subprocess.run(["protoc", "-I", ROOT / "proto", f"--python_out={folder}", f"--grpc_out={folder}", plugin,
                    *(f"slicefarm/v1/{name}.proto" for name in PUBLIC)], cwd=ROOT / "proto", check=True)
    subprocess.run(["protoc", "-I", folder / "of_google", f"--python_out={folder}", "google/rpc/error_details.proto"], check=True)


def check_errors(folder, address):
    import google
    google.__path__ = [*google.__path__, str(folder / "google")]
    details = importlib.import_module("google.rpc.error_details_pb2")
    import grpc
    from slicefarm.v1 import jobs_pb2, jobs_pb2_grpc
    try:
        jobs_pb2_grpc.JobsStub(grpc.insecure_channel(address)).GetJob(jobs_pb2.GetJobRequest(id="none"), timeout=30)
        raise AssertionError("there is no such job")
    except grpc.RpcError as error:
        [text] = [value for key, value in error.trailing_metadata() if key == "grpc-status-details-bin"]
    info = details.ErrorInfo()
    assert details.Status.FromString(text).details[0].Unpack(info)
    assert (info.domain, info.reason) == ("slicefarm", "JOB_NOT_FOUND"), info


def main(program):
    assert len(CLIENT.read_text().splitlines()) <= 52
    with tempfile.TemporaryDirectory(prefix="slicefarm-") as folder, running_farm() as farm:
        folder = pathlib.Path(folder)
        make_stubs(folder)
        sys.path.insert(0, str(folder))
        farm.await_serving()
        project = write(folder / "bambu.3mf", bambu_files())
        subprocess.run([program, "slice", project, "--plate", "2", "-o", folder / "want.gcode"], check=True)
        server = farm.coordinators[0].address
        subprocess.run([sys.executable, CLIENT, server, project, "2", folder / "got.gcode"], check=True,
                       env={**os.environ, "PYTHONPATH": str(folder)})
        assert (folder / "got.gcode").read_bytes() == (folder / "want.gcode").read_bytes()
        check_errors(folder, server)
    print("plate 2 is that of slicefarm slice, and Google's google.rpc reads what an error says")


if __name__ == "__main__":
    main(*sys.argv[1:])
