#!/usr/bin/env python3
"""Tests the set of files that the build id covers, by running cmake/build_info.cmake over a copy of the sources.

usage: build_id_test.py REPOSITORY
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

CHANGES = [
    # path, True if a change of the file changes the build id
    ("services/infill/algo/section_fill.cc", True),
    ("services/slicing/algo/section/sweep.h", True),
    ("services/texture/algo/engrave_job.cc", True),
    ("common/kinematics/jerk_planner.cc", True),
    ("common/gcode/gcode_text.cc", True),
    ("services/slicing/sandbox/reader_side.cc", True),
    ("processes/fdm/job/fdm_programs.cc", True),
    ("services/coordinator/algo/pipeline/report_json.cc", True),
    ("common/base/portable_math.cc", True),
    ("common/config/resolve.cc", True),
    ("common/wire/layers/layer_wire.cc", True),
    ("proto/slicefarm/v1/layer.proto", True),
    ("CMakeLists.txt", True),
    ("services/cli/commands/slice_command.cc", False),
    ("services/lab/main.cc", False),
    ("services/coordinator/server/webhooks/webhook_message.cc", False),
    ("services/coordinator/store/blobs/directory_blob_store.cc", False),
    ("services/coordinator/algo/dispatch/dispatcher.cc", False),
    ("common/rpc/server/server.cc", False),
    ("common/base/error_test.cc", False),
    ("proto/slicefarm/v1/jobs.proto", False),
    ("README.md", False),
]

# Folders with files that stage programs include, but that do not affect the bytes of a result.
CARRIERS = re.compile(r"common/rpc/|services/coordinator/algo/dispatch/")
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)


def build_id(tree, tools="GNU=12.2.0,libc=glibc-2.36"):
    output = tree / "build_info.cc"
    command = ["cmake", f"-DSOURCE_DIR={tree}", f"-DTOOLS={tools}", f"-DTEMPLATE={tree}/common/base/build_info.cc.in",
               f"-DOUTPUT={output}", "-DVERSION=1.2.3", "-DRELEASE_DATE=2026-11-21", "-P", str(tree / "cmake/build_info.cmake")]
    subprocess.run(command, check=True)
    text = output.read_text()
    output.unlink()
    return text


def covered(tree):
    """Returns the paths of the files that the build id covers."""
    listing = tree / "listing.txt"
    command = ["cmake", f"-DSOURCE_DIR={tree}", "-DTOOLS=", f"-DTEMPLATE={tree}/common/base/build_info.cc.in", f"-DLISTING={listing}",
               f"-DOUTPUT={tree}/build_info.cc", "-DVERSION=1.2.3", "-DRELEASE_DATE=2026-11-21", "-P", str(tree / "cmake/build_info.cmake")]
    subprocess.run(command, check=True)
    names = set(listing.read_text().split())
    listing.unlink()
    (tree / "build_info.cc").unlink()
    return names


def files_of_stages(tree):
    """Returns the paths of all files that belong to the stage programs and the pipeline.

    Follows the includes of their sources. A header also adds the sources beside it, since any of them may implement it.
    """
    roots = [*tree.glob("services/*/server/main.cc"), *tree.glob("services/coordinator/algo/pipeline/*.cc"), *tree.glob("processes/*/job/*.cc")]
    found, left = set(), [r for r in roots if "coordinator/server" not in r.as_posix()]
    while left:
        file = left.pop()
        name = file.relative_to(tree).as_posix()
        if name in found or re.search(r"_test\.(cc|h)$", name):
            continue
        found.add(name)
        if not CARRIERS.match(name):
            left += [tree / path for path in INCLUDE.findall(file.read_text()) if (tree / path).exists()]
            left += file.parent.glob("*.cc") if file.suffix == ".h" else []
    return found


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
        of_stages = files_of_stages(tree)
        if len(of_stages) < 500:
            failures.append(f"only {len(of_stages)} files of stages were found")
        names = covered(tree)
        failures += [f"{path}: stages are made of it, and the build id does not cover it"
                     for path in sorted(of_stages - names) if not CARRIERS.match(path)]
        new = tree / "services/infill/algo/new_file.cc"
        new.write_text("")
        if build_id(tree) == before:
            failures.append("a new file of a stage is the same build")
        new = tree / "services/a_new_stage/algo/new_file.cc"
        new.parent.mkdir(parents=True)
        new.write_text("")
        if "services/a_new_stage/algo/new_file.cc" not in covered(tree):
            failures.append("the build id does not cover a new service")
    for failure in failures:
        print(failure)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
