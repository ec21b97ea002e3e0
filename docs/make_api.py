#!/usr/bin/python3
"""Writes docs/api.md, the reference of the public API, from the comments of the public protos.

    docs/make_api.py            writes docs/api.md
    docs/make_api.py --check    exits with 1 if docs/api.md is not up to date

The codes and causes of errors are read from the table in proto/slicefarm/v1/README.md.
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import textwrap

from google.protobuf import descriptor_pb2

ROOT = pathlib.Path(__file__).resolve().parent.parent
FILES = ("jobs", "profiles", "presets", "mesh", "geometry", "process", "error_reason")
PACKAGE = ".slicefarm.v1."
FIELD = descriptor_pb2.FieldDescriptorProto
COLUMNS = 128

INTRODUCTION = """\
# API of slicefarm

Clients call four gRPC services: `Meshes`, `Jobs`, `Profiles` and `Presets`, package `slicefarm.v1`. Their protos are in
`proto/slicefarm/v1`. This page is made from the comments there by `docs/make_api.py`: change the comments, then run the script
again.

- A client in one page, with retries and resumed uploads: `docs/print_plate.py`.
- The usual order of calls: `GetUpload`, `UploadMesh`, `CreateJob`, `WatchJob`, `Download`.
- A call with a token has the metadata `authorization: Bearer TOKEN`. See
  [running a farm](users/running-a-farm.md#tenants-and-tokens).
- Messages and fields are only added, never changed: `tests/public_api_test.py` checks this.
- The largest message has 4 MiB. Set a deadline for every call except `WatchJob` and `WatchJobs`.
"""

ERRORS = """\
## Errors

Every error of a service has a `google.rpc.ErrorInfo` in the trailing metadata `grpc-status-details-bin`. Its `domain` is
`slicefarm` and its `reason` is one of the names below. Its `metadata` has the facts, such as `limit`, `got`, `setting` or
`line`. Where they apply, these details are added:

- `RetryInfo`: the time after which the client should try again.
- `BadRequest`: the field, or `settings.KEY`, that an INVALID_ARGUMENT refers to.
- `QuotaFailure`: the limit, for RESOURCE_EXHAUSTED.
- `PreconditionFailure`: the blob, job or profile, for FAILED_PRECONDITION.

Errors of gRPC itself have no details. In the outcomes of a batch, the metadata `retry_after_ms` replaces `RetryInfo`.
[Troubleshooting](users/troubleshooting.md) has the remedy for each reason.
"""


def read_files():
    with tempfile.NamedTemporaryFile() as out:
        subprocess.run(["protoc", "-I", ROOT / "proto", "--include_source_info", f"--descriptor_set_out={out.name}",
                        *(f"slicefarm/v1/{name}.proto" for name in FILES)], check=True)
        files = descriptor_pb2.FileDescriptorSet.FromString(pathlib.Path(out.name).read_bytes()).file
    order = {f"slicefarm/v1/{name}.proto": at for at, name in enumerate(FILES)}
    return sorted(files, key=lambda file: order[file.name])


def comments_of(file):
    """Returns the comment of each declaration as one line, by its path in the descriptor."""
    comments = {}
    for place in file.source_code_info.location:
        text = " ".join(f"{place.leading_comments} {place.trailing_comments}".split())
        if text:
            comments[tuple(place.path)] = text
    return comments


def sentence(text):
    """Returns the text with a capital letter and a full stop, unless it begins with a name."""
    text = text.strip()
    if not text:
        return ""
    if text[0].islower() and "_" not in text.split()[0]:
        text = text[0].upper() + text[1:]
    return text if text[-1] in ".!?" else text + "."


def wrapped(text, indent=""):
    return textwrap.fill(text, COLUMNS, subsequent_indent=indent, break_long_words=False, break_on_hyphens=False)


def link(type_name):
    if not type_name.startswith(PACKAGE):
        return f"`{type_name.lstrip('.')}`"
    name = type_name.removeprefix(PACKAGE)
    return f"[{name}](#{name.replace('.', '').lower()})"


def type_of(field, entries):
    if field.type_name in entries:
        key, value = entries[field.type_name].field
        return f"map from {type_of(key, {})} to {type_of(value, {})}"
    name = link(field.type_name) if field.type_name else FIELD.Type.Name(field.type).removeprefix("TYPE_").lower()
    if field.label == FIELD.LABEL_REPEATED:
        return f"repeated {name}"
    return f"optional {name}" if field.proto3_optional else name


def item(head, comment):
    text = sentence(comment)
    return wrapped(f"- {head}: {text}" if text else f"- {head}.", "  ")


def lines_of_message(name, message, path, comments):
    yield f"### {name}\n"
    if path in comments:
        yield wrapped(sentence(comments[path])) + "\n"
    entries = {f"{PACKAGE}{name}.{nested.name}": nested for nested in message.nested_type if nested.options.map_entry}
    fields = []
    for at, field in enumerate(message.field):
        oneof = "" if field.proto3_optional or not field.HasField("oneof_index") else \
            f", one of `{message.oneof_decl[field.oneof_index].name}`"
        head = f"`{field.name}` = {field.number}, {type_of(field, entries)}{oneof}"
        fields.append(item(head, comments.get((*path, 2, at), "")))
    yield "\n".join(fields or ["No fields."]) + "\n"
    for at, enum in enumerate(message.enum_type):
        yield from lines_of_enum(f"{name}.{enum.name}", enum, (*path, 4, at), comments)
    for at, nested in enumerate(message.nested_type):
        if not nested.options.map_entry:
            yield from lines_of_message(f"{name}.{nested.name}", nested, (*path, 3, at), comments)


def lines_of_enum(name, enum, path, comments):
    yield f"### {name}\n"
    if path in comments:
        yield wrapped(sentence(comments[path])) + "\n"
    yield "\n".join(item(f"`{value.name}` = {value.number}", comments.get((*path, 2, at), ""))
                    for at, value in enumerate(enum.value)) + "\n"


def lines_of_service(service, path, comments):
    yield f"## Service {service.name}\n"
    yield wrapped(sentence(comments.get(path, ""))) + "\n"
    for at, method in enumerate(service.method):
        request, answer = (("stream of " if streams else "") + link(kind) for streams, kind in
                           ((method.client_streaming, method.input_type), (method.server_streaming, method.output_type)))
        yield f"### {service.name}.{method.name}\n"
        yield f"{request} → {answer}\n"
        yield wrapped(sentence(comments.get((*path, 2, at), ""))) + "\n"


def lines_of_errors(error_file):
    rows = dict(re.findall(r"^\| ([A-Z_]+) \| (.*) \|$", (ROOT / "proto/slicefarm/v1/README.md").read_text(), re.M))
    yield ERRORS
    items = []
    for value in error_file.enum_type[0].value[1:]:
        code, when = rows[value.name].split(" | ", 1) if " | " in rows[value.name] else (rows[value.name].rstrip(" |"), "")
        items.append(item(f"[`{value.name}`](users/troubleshooting.md#{value.name.lower()}) = {value.number}, {code}", when))
    yield "\n".join(items) + "\n"


def page():
    files = read_files()
    parts = [INTRODUCTION]
    for file in files:
        comments = comments_of(file)
        for at, service in enumerate(file.service):
            parts += lines_of_service(service, (6, at), comments)
    parts.append("## Messages\n")
    for file in files[:-1]:
        comments = comments_of(file)
        for at, message in enumerate(file.message_type):
            parts += lines_of_message(message.name, message, (4, at), comments)
        for at, enum in enumerate(file.enum_type):
            parts += lines_of_enum(enum.name, enum, (5, at), comments)
    parts += lines_of_errors(files[-1])
    return "\n".join(parts)


def main():
    target, text = ROOT / "docs/api.md", page()
    if sys.argv[1:] == ["--check"]:
        if not target.exists() or target.read_text() != text:
            print("docs/api.md is not up to date: run docs/make_api.py")
            return 1
        print("docs/api.md is up to date")
        return 0
    if sys.argv[1:]:
        print(__doc__)
        return 2
    target.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
