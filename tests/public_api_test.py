#!/usr/bin/python3
"""Tests that the interface that clients rely on stays. The public protos must contain everything that public_api.txt
names, under the same numbers and types. They must not import protos of the stages or google.rpc.

    tests/public_api_test.py            exit 1 and a line for each removed or changed item
    tests/public_api_test.py --write    adds new items to public_api.txt; a release does so
"""
import pathlib
import subprocess
import sys
import tempfile

from google.protobuf import descriptor_pb2

ROOT = pathlib.Path(__file__).resolve().parent.parent
KEPT = ROOT / "tests/public_api.txt"
PUBLIC = [f"slicefarm/v1/{name}.proto" for name in ("error_reason", "geometry", "jobs", "mesh", "presets", "process", "profiles")]
FIELD = descriptor_pb2.FieldDescriptorProto


def read_files():
    with tempfile.NamedTemporaryFile() as out:
        subprocess.run(["protoc", "-I", ROOT / "proto", "--include_imports", f"--descriptor_set_out={out.name}", *PUBLIC], check=True)
        return descriptor_pb2.FileDescriptorSet.FromString(pathlib.Path(out.name).read_bytes()).file


def lines_of_message(name, message):
    for field in message.field:
        kind = field.type_name.lstrip(".") or FIELD.Type.Name(field.type).removeprefix("TYPE_").lower()
        repeated = "repeated " if field.label == FIELD.LABEL_REPEATED else ""
        oneof = message.oneof_decl[field.oneof_index].name if field.HasField("oneof_index") and not field.proto3_optional else ""
        optional = "optional " if field.proto3_optional else f"oneof {oneof} " if oneof else ""
        yield f"field {name}.{field.name} = {field.number} {optional}{repeated}{kind}"
    for nested in message.nested_type:
        yield from lines_of_message(f"{name}.{nested.name}", nested)
    for enum in message.enum_type:
        yield from (f"value {name}.{enum.name}.{value.name} = {value.number}" for value in enum.value)


def lines_of_file(file):
    for message in file.message_type:
        yield from lines_of_message(f"{file.package}.{message.name}", message)
    for enum in file.enum_type:
        yield from (f"value {file.package}.{enum.name}.{value.name} = {value.number}" for value in enum.value)
    for service in file.service:
        for method in service.method:
            ways = ["stream " if streams else "" for streams in (method.client_streaming, method.server_streaming)]
            yield (f"call {file.package}.{service.name}.{method.name} {ways[0]}{method.input_type.lstrip('.')}"
                   f" -> {ways[1]}{method.output_type.lstrip('.')}")


def main():
    files = read_files()
    problems = [f"{file.name} is imported, and is none of the public ones" for file in files
                if file.name not in PUBLIC and not file.name.startswith("google/protobuf/")]
    present = {line for file in files if file.name in PUBLIC for line in lines_of_file(file)}
    kept = set(KEPT.read_text().splitlines()) if KEPT.exists() else set()
    problems += [f"gone or changed: {line}" for line in sorted(kept - present)]
    if sys.argv[1:] == ["--write"] and not problems:
        KEPT.write_text("".join(f"{line}\n" for line in sorted(kept | present)))
    print("\n".join(problems) or f"{len(kept)} of {len(present)} things are promised, and all are there")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
