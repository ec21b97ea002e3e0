#!/usr/bin/python3
"""Prints one plate of a 3MF project on a farm: a client in a page, for who writes one of his own.

usage: print_plate.py SERVER PROJECT.3mf PLATE OUT.gcode

It needs grpcio, and stubs that any protoc makes of proto/slicefarm/v1 (with grpcio-tools, or Debian's python3-grpcio,
python3-protobuf and protobuf-compiler-grpc):
    protoc -I proto --python_out=. --grpc_out=. --plugin=protoc-gen-grpc=$(which grpc_python_plugin) \
      proto/slicefarm/v1/{jobs,mesh,geometry,process}.proto
"""
import hashlib
import pathlib
import sys
import uuid

import grpc
from slicefarm.v1 import jobs_pb2, jobs_pb2_grpc

CHUNK = 64 << 10


def upload(meshes, data):
    """Goes on where an earlier call ended; nothing is sent of what is there."""
    digest = hashlib.sha256(data).hexdigest()
    there = meshes.GetUpload(jobs_pb2.GetUploadRequest(sha256=digest), timeout=30)
    if not there.complete:
        def pieces(at):
            yield jobs_pb2.UploadMeshRequest(sha256=digest, size=len(data), write_offset=at, data=data[at:at + CHUNK])
            for begin in range(at + CHUNK, len(data), CHUNK):
                yield jobs_pb2.UploadMeshRequest(data=data[begin:begin + CHUNK])
        meshes.UploadMesh(pieces(there.committed_size), timeout=600)
    return digest


def main(server, project, plate, out):
    channel = grpc.insecure_channel(server)
    meshes, jobs = jobs_pb2_grpc.MeshesStub(channel), jobs_pb2_grpc.JobsStub(channel)
    digest = upload(meshes, pathlib.Path(project).read_bytes())
    read = meshes.ReadProject(jobs_pb2.ReadProjectRequest(sha256=digest, plate=int(plate)), timeout=60)
    [spec] = [each.spec for each in read.plates if each.number == int(plate)]
    job = jobs.CreateJob(jobs_pb2.CreateJobRequest(request_id=str(uuid.uuid4()), spec=spec), timeout=30)
    for event in jobs.WatchJob(jobs_pb2.WatchJobRequest(id=job.id)):
        job = event.job
        print(jobs_pb2.JobState.Name(job.state), f"{job.progress.layers_done}/{job.progress.layers_total}", file=sys.stderr)
    if job.state != jobs_pb2.JOB_STATE_SUCCEEDED:
        sys.exit(f"{job.error.reason}: {job.error.message}")
    with open(out, "wb") as file:
        for part in jobs.Download(jobs_pb2.DownloadRequest(id=job.id, artifact=jobs_pb2.ARTIFACT_GCODE)):
            file.write(part.data)


if __name__ == "__main__":
    main(*sys.argv[1:])
