#!/usr/bin/env python3
"""What the build id follows, and what it does not: cmake/build_info.cmake over a copy of the sources.

usage: build_id_test.py REPOSITORY
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

CHANGES = [
    # path, whether a change of it is another build
    ("services/infill/algo/section_fill.cc", True),
    ("services/slicing/algo/section/sweep.h", True),
    ("services/slicing/sandbox/reader_side.cc", True),
    ("processes/fdm/job/fdm_programs.cc", True),
    ("services/coordinator/algo/pipeline/report_json.cc", True),
    ("common/base/portable_math.cc", True),
    ("common/config/resolve.cc", True),
    ("common/wire/layers/layer_wire.cc", True),
    ("proto/slicefarm/v1/layer.proto", True),
    ("CMakeLists.txt", True),
    ("services/cli/commands/slice_command.cc", False),
    ("services/load/client/main.cc", False),
    ("services/coordinator/server/webhooks/webhook_message.cc", False),
    ("services/coordinator/store/blobs/directory_blob_store.cc", False),
    ("services/coordinator/algo/dispatch/dispatcher.cc", False),
    ("common/rpc/server/server.cc", False),
    ("common/base/error_test.cc", False),
    ("proto/slicefarm/v1/jobs.proto", False),
    ("README.md", False),
]


def build_id(tree, tools="GNU=12.2.0,libc=glibc-2.36"):
    output = tree / "build_info.cc"
    command = ["cmake", f"-DSOURCE_DIR={tree}", f"-DTOOLS={tools}", f"-DTEMPLATE={tree}/common/base/build_info.cc.in",
               f"-DOUTPUT={output}", "-DVERSION=1.2.3", "-DRELEASE_DATE=2026-11-21", "-P", str(tree / "cmake/build_info.cmake")]
    subprocess.run(command, check=True)
    text = output.read_text()
    output.unlink()
    return text


def main():
    repository = pathlib.Path(sys.argv[1])
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder)
        for name in ("common", "processes", "services", "proto", "cmake"):
            shutil.copytree(repository / name, tree / name, ignore=shutil.ignore_patterns("*.md", "__pycache__"))
        for name in ("CMakeLists.txt", "README.md"):
            shutil.copy(repository / name, tree / name)
        before = build_id(tree)
        if build_id(tree) != before:
            failures.append("the same tree has two ids")
        if build_id(tree, tools="GNU=12.2.0,libc=glibc-2.37") == before:
            failures.append("another C library is the same build")
        for path, matters in CHANGES:
            content = (tree / path).read_bytes()
            (tree / path).write_bytes(content + b"\n")
            if (build_id(tree) != before) != matters:
                failures.append(f"{path}: a change is {'the same' if matters else 'another'} build")
            (tree / path).write_bytes(content)
        new = tree / "services/infill/algo/new_file.cc"
        new.write_text("")
        if build_id(tree) == before:
            failures.append("a new file of a stage is the same build")
    for failure in failures:
        print(failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
