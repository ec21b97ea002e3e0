#!/usr/bin/env python3
"""Fails if an include crosses the layers, or if a file breaks a size or pairing rule.

usage: check_layers.py [repo root]        exit 1 and one line per violation

The order of the layers is base <- gcode, geometry, picture <- model <- macro, kinematics <- config, stage, algo <-
wire, rpc, sandbox <- remote, store <- run <- server. A service never includes another service. Exceptions are the
folders that assemble whole programs, services/worker, services/cli and services/lab; no other folder includes them.
Code of a single process is in processes/<name>. Its types (model) belong to the layer model, and the stages of the
process include them. Its other folders (settings, task, wire, job) are used only through processes/list. No other file
names a process, except common/model/process.h.
"""
import pathlib
import re
import sys

WIRE, GRPC = r"\.pb\.h$", r"^grpc"
PURE = {"base", "gcode", "model", "geometry"}
EDGE = PURE | {"config", "stage", "wire", "rpc", "algo"}
PROCESS = {"settings", "task", "task_wire", "job"}  # layers of a process's own code and of the process lists
# layer: (path pattern, layers it may include, system and generated headers it must not include)
LAYERS = [
    ("base", r"common/base/", {"base"}, f"{WIRE}|{GRPC}"),
    ("gcode", r"common/gcode/", {"base", "gcode"}, f"{WIRE}|{GRPC}"),
    ("geometry", r"common/geometry/", {"base", "geometry"}, f"{WIRE}|{GRPC}"),
    ("picture", r"common/picture/", {"base", "picture"}, f"{WIRE}|{GRPC}"),
    ("model", r"(?:common|processes/\w+)/model/", PURE, f"{WIRE}|{GRPC}"),
    ("kinematics", r"common/kinematics/", PURE | {"kinematics"}, f"{WIRE}|{GRPC}"),
    ("macro", r"common/macro/", {"base", "geometry", "model", "macro"}, f"{WIRE}|{GRPC}"),
    ("config", r"common/config/", PURE | {"config", "stage", "macro"}, f"{WIRE}|{GRPC}"),
    ("stage", r"common/stage/", PURE | {"stage"}, f"{WIRE}|{GRPC}"),
    ("settings", r"processes/\w+/settings(?:[/.]|_test)", PURE | {"config", "macro", "settings"}, f"{WIRE}|{GRPC}"),
    ("task", r"processes/\w+/tasks?(?:[/.]|_test)", PURE | {"stage", "task"}, f"{WIRE}|{GRPC}"),
    ("task_wire", r"processes/\w+/wire(?:[/.]|_test)", PURE | {"stage", "wire", "task", "task_wire"}, r"\.grpc\.pb\.h$|^grpc"),
    ("job", r"processes/\w+/jobs?(?:[/.]|_test)", PURE | {"stage", "task", "algo", "job"}, f"{WIRE}|{GRPC}"),
    ("wire", r"common/wire/", PURE | {"stage", "wire"}, r"\.grpc\.pb\.h$|^grpc"),
    ("rpc", r"common/rpc/", PURE | {"rpc"}, r"slicefarm/v1/(?!shared).*\.pb\.h$"),
    ("algo", r"services/(\w+)/algo/", PURE | {"algo", "stage", "macro", "kinematics", "picture"}, f"{WIRE}|{GRPC}"),
    ("sandbox", r"services/(\w+)/sandbox/", PURE | {"algo", "sandbox"}, f"{WIRE}|{GRPC}"),
    ("remote", r"services/(\w+)/remote/", EDGE | {"remote", "task_wire"}, None),
    ("store", r"services/(\w+)/store/", PURE | {"store", "algo", "rpc", "wire"}, GRPC),
    ("run", r"services/(\w+)/run/", PURE | {"run", "algo", "store"}, f"{WIRE}|{GRPC}"),
    ("server", r"services/(\w+)/server/", EDGE | {"remote", "sandbox", "store", "run", "server"} | PROCESS, None),
    ("console", r"services/(cli)/console/", PURE | {"config", "console"}, f"{WIRE}|{GRPC}"),
    ("cli", r"services/(cli)/", EDGE | {"remote", "console", "cli", "picture"} | PROCESS, None),
    ("lab", r"services/(lab)/", EDGE | {"console", "lab", "picture"}, None),
]
COMPOSITION_ROOTS = {"worker", "cli", "lab"}
JOBS_OF = "coordinator"  # service that assembles jobs; processes/*/job implements its interfaces
PROCESSES = re.compile(r"processes/(\w+)/(?!model/)")
# Files of lasers beside their folders: the enumerators, and the stage that exposes layers.
LASER_FILES = re.compile(r"processes/(laser|list)/|processes/CMakeLists.txt|services/exposure/|common/model/process\.h")
PROCESS_MODEL = re.compile(r'#include "processes/\w+/model/')
CLIPPER = re.compile(r"^(polyclipping/)?clipper")  # allowed only in common/geometry
IMPURE = re.compile(r"\b(getenv|std::cout|std::cerr|printf|exit|rand|system_clock|steady_clock)\s*[\(:<]")
# libm's results depend on the CPU (FMA or not). The functions of common/base/portable_math.h have the same results everywhere.
LIBM = re.compile(
    r"\bstd::(LIBM)[fl]?\b|(?<![\w.>:])(?:::)?(LIBM)[fl]?\s*\(".replace(
        "LIBM",
        "a?(?:sin|cos|tan)h?|atan2|sincos|hypot|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|erfc?|[lt]gamma|polar",
    )
)
# Clang 14 builds the fuzzers. It cannot compile the views of GCC 12's library that return a part of a range.
SUBRANGE = re.compile(
    r"\bstd::(views::\w+|ranges::(?:views|subrange|unique|equal_range|rotate|remove|remove_if|partition|stable_partition|search|find_end)\b)"
)
# A place or a direction must be an Eigen::Vector2d or Vector3d. A forbidden type of one's own is a struct that has only
# coordinates and operators.
STRUCT = re.compile(r"\bstruct (\w+) \{")
COORDINATES = re.compile(r"(?:(?:double|float) )?[uvxyz](?: = [\d.]+)?")
LIBM_FREE = {"base", "gcode", "geometry", "model", "kinematics", "macro", "config", "stage", "algo", "settings", "task", "job"}
MAX_LINES, MAX_TEST_LINES = 500, 1000
TEST_FILE = re.compile(r"_test\.(cc|h)$")  # as in cmake/build_info.cmake
TEST_ONLY = re.compile(r"^(gtest|gmock)/|_test\.h$")


def layer_of(path):
    for name, pattern, _, _ in LAYERS:
        if m := re.match(pattern, path):
            return name, (m.group(1) if m.groups() else None)
    return None, None


def check_includes(path, text, layer, service, is_test):
    _, _, allowed, forbidden = next(l for l in LAYERS if l[0] == layer)
    for match in re.finditer(r'^\s*#\s*include\s*[<"]([^">]+)[">]', text, re.M):
        included = match.group(1)
        where = f"{path}:{text[: match.start()].count(chr(10)) + 1}"
        to, to_service = layer_of(included)
        if to and to not in allowed and not (is_test and to in PROCESS):
            yield f"{where}: {layer} must not include {to} ({included})"
        roots = COMPOSITION_ROOTS if layer != "job" or to_service != JOBS_OF else {service}
        if to_service and to_service != service and service not in roots:
            yield f"{where}: service {service} must not include service {to_service}"
        if not is_test:
            yield from check_process(path, where, included)
        if included.startswith("tests/") and not is_test:
            yield f"{where}: product code must not include tests/"
        if TEST_ONLY.search(included) and not is_test:
            yield f"{where}: only a file named *_test.h or *_test.cc may include {included}"
        if forbidden and not is_test and re.search(forbidden, included):
            yield f"{where}: {layer} must not include {included}"
        if CLIPPER.match(included) and layer != "geometry":
            yield f"{where}: Clipper is private to common/geometry"


def check_process(path, where, included):
    """Reports an include of a process's folder by code outside this process and outside processes/list."""
    to, own = PROCESSES.match(included), PROCESSES.match(path)
    if to and to[1] != "list" and (own is None or own[1] not in ("list", to[1])):
        yield f"{where}: only the list of processes may include {included}"


def check_names(path, text):
    if LASER_FILES.match(path):
        return
    for number, line in enumerate(text.splitlines(), 1):
        if "laser" in line.lower() and not PROCESS_MODEL.match(line):
            yield f"{path}:{number}: names a process; ask the process instead"


def members(text, start):
    """Returns the members of the struct whose opening brace ends at `start`, split at `;`. Each nested pair of braces
    counts as one `;`.
    """
    depth, found = 1, []
    for c in text[start:]:
        depth += (c == "{") - (c == "}")
        if depth == 0:
            break
        if depth == 1:
            found.append(";" if c == "}" else c)
    return "".join(found).split(";")


def vectors(text):
    """Yields the names of structs that contain only coordinates and functions."""
    text = re.sub(r"//[^\n]*", "", text)
    for match in STRUCT.finditer(text):
        fields = [f.strip() for m in members(text, match.end()) if "(" not in m for f in m.split(",") if f.strip()]
        if len(fields) in (2, 3) and all(COORDINATES.fullmatch(field) for field in fields):
            yield match[1]


def check_vectors(path, text):
    for name in vectors(text):
        yield f"{path}: {name} is a vector of its own; use Vector2 or Vector3 of common/geometry/vector.h"


def check(root, file):
    path = file.relative_to(root).as_posix()
    layer, service = layer_of(path)
    text = file.read_text()
    is_test = bool(TEST_FILE.search(path))
    limit = MAX_TEST_LINES if is_test else MAX_LINES
    if (n := text.count("\n")) > limit:
        yield f"{path}: {n} lines, at most {limit}"
    if layer is None:
        yield f"{path}: in no known layer"
        return
    yield from check_includes(path, text, layer, service, is_test)
    if not is_test:
        yield from check_names(path, text)
        yield from check_vectors(path, text)
    if re.search(r"^(TYPED_)?TEST(_[FP])?\(", text, re.M) and not re.search(rf"^namespace slicefarm\S*::{file.stem} {{$", text, re.M):
        yield f"{path}: no namespace of its own, slicefarm::..::{file.stem}: files compiled as one share names"
    if layer in ("algo", "geometry", "model", "kinematics", "config", "run", "settings", "task", "job") and not is_test:
        for m in IMPURE.finditer(text):
            # A literal for tests may abort. Apart from this, pure code may not have side effects.
            if "OrDie" not in text:
                yield f"{path}:{text[: m.start()].count(chr(10)) + 1}: {m.group(1)} in pure code"
    for m in SUBRANGE.finditer(text):
        if not is_test:
            yield f"{path}:{text[: m.start()].count(chr(10)) + 1}: std::{m.group(1)}, which the compiler of the fuzzers does not take"
    if layer in LIBM_FREE and not is_test:
        for number, line in enumerate(text.splitlines(), 1):
            if m := LIBM.search(line.split("//")[0]):
                yield f"{path}:{number}: {m.group(1) or m.group(2)} of libm; use common/base/portable_math.h"
    if layer in ("algo", "geometry", "kinematics", "run") and path.endswith(".cc") and not is_test:
        if not file.with_name(file.stem + "_test.cc").exists():
            yield f"{path}: no {file.stem}_test.cc beside it"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve()
    files = [f for d in ("common", "processes", "services") for e in ("h", "cc") for f in sorted((root / d).rglob(f"*.{e}"))]
    if not files:
        print(f"no sources under {root}")
        return 1
    found = [v for f in files for v in check(root, f)]
    print("\n".join(found) or f"{len(files)} files, all layers respected")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
