#!/usr/bin/python3
"""Prints one plate of a 3MF project on a farm: a complete client in one page, as an example for other clients.

usage: print_plate.py SERVER PROJECT.3mf PLATE OUT.gcode [PROFILE...]

It needs grpcio and stubs made by protoc (with grpcio-tools, or Debian's python3-grpcio, python3-protobuf and
protobuf-compiler-grpc):
    protoc -I proto --python_out=. --grpc_out=. --plugin=protoc-gen-grpc=$(which grpc_python_plugin) \
      proto/slicefarm/v1/{jobs,presets,mesh,geometry,process}.proto proto/google/rpc/{status,error_details}.proto
"""
import hashlib, pathlib, sys, time, uuid  # noqa: E401
import google.protobuf, grpc  # noqa: E401
google.__path__ = [*google.__path__, *(f"{folder}/google" for folder in sys.path)]  # also finds the stubs of google.rpc
from google.rpc import error_details_pb2, status_pb2
from slicefarm.v1 import jobs_pb2 as pb, jobs_pb2_grpc


def reason_of(error):
    """Returns the machine-readable reason of a refused call, such as JOB_NOT_FOUND."""
    info = error_details_pb2.ErrorInfo()
    packed = [value for key, value in error.trailing_metadata() or () if key == "grpc-status-details-bin"]
    return "".join(info.reason for value in packed for each in status_pb2.Status.FromString(value).details if each.Unpack(info))


def persist(work, *arguments):
    """Calls `work` again for two minutes if the farm is full or restarts. Any other error ends the program with its reason."""
    for seconds in (1, 2, 4, 8, 15, 30, 60, None):
        try:
            return work(*arguments)
        except grpc.RpcError as error:
            if seconds is None or error.code().name not in ("UNAVAILABLE", "RESOURCE_EXHAUSTED", "DEADLINE_EXCEEDED"):
                sys.exit(f"{reason_of(error) or error.code().name}: {error.details()}")
            time.sleep(seconds)


def upload(meshes, digest, data):
    """Uploads the mesh. Continues at the byte where an earlier upload ended; sends nothing if the mesh is complete."""
    there = meshes.GetUpload(pb.GetUploadRequest(sha256=digest), timeout=30)
    first = pb.UploadMeshRequest(sha256=digest, size=len(data), write_offset=there.committed_size)
    pieces = (pb.UploadMeshRequest(data=data[at:at + (1 << 20)]) for at in range(there.committed_size, len(data), 1 << 20))
    return there.complete or meshes.UploadMesh((message for part in ([first], pieces) for message in part), timeout=600)


def main(server, project, plate, out, *profiles):
    channel, data = grpc.insecure_channel(server), pathlib.Path(project).read_bytes()
    meshes, jobs, digest = jobs_pb2_grpc.MeshesStub(channel), jobs_pb2_grpc.JobsStub(channel), hashlib.sha256(data).hexdigest()
    persist(upload, meshes, digest, data)
    read = persist(meshes.ReadProject, pb.ReadProjectRequest(sha256=digest, plate=int(plate)))
    [spec] = [each.spec for each in read.plates if each.number == int(plate)] or [sys.exit(f"{project} has no plate {plate}")]
    spec.profiles.extend(profiles)
    job = persist(jobs.CreateJob, pb.CreateJobRequest(request_id=str(uuid.uuid4()), spec=spec))
    job = persist(lambda: list(jobs.WatchJob(pb.WatchJobRequest(id=job.id)))[-1].job)
    print(pb.JobState.Name(job.state), *job.warnings, sep="\nwarning: ", file=sys.stderr)
    if job.state != pb.JOB_STATE_SUCCEEDED:
        sys.exit(f"{job.error.reason}: {job.error.message}")
    request = pb.DownloadRequest(id=job.id, artifact=pb.ARTIFACT_GCODE)
    pathlib.Path(out).write_bytes(persist(lambda: b"".join(part.data for part in jobs.Download(request))))


if __name__ == "__main__":
    main(*sys.argv[1:]) if len(sys.argv) > 4 else sys.exit(__doc__)
