#!/usr/bin/env python3
"""S3 bucket for tests: PUT, GET (with ranges), HEAD and DELETE of objects as in Amazon's S3. The objects are files in a
directory.

    tests/fake_s3.py --dir DIR [--port P] [--bucket farm] [--access KEY] [--secret SECRET] [--rate R --seed S]

Prints its port when it listens. Every request must be signed by Signature Version 4 and be at most 15 minutes old. The
signature is implemented here independently, from Amazon's description. The content of a PUT must have the SHA-256 that
the request states. An object exists when all of it has arrived, and it survives a kill of the server.

Faults: with --rate, this share of all requests fails, chosen by the seed. The kind `wrong` is not used for GETs then,
because a download detects wrong bytes only at its end. Faults can also be given in a file DIR/.faults, a JSON list of
{"method": "PUT", "kind": KIND, "times": N}. The file is deleted when it is read. The next N such requests fail. KIND is
one of
    500, 503, 403      that answer
    stall              no answer, until the client gives up
    cut                the connection ends in the middle of the body, of the client's or of the server's
    wrong              bytes that were changed in transit
    lost               the request is executed, and the connection ends without an answer
GET /counts returns the number of requests and of failures by method, and the number of object bytes `sent`.
"""
import argparse
import calendar
import collections
import hashlib
import hmac
import http.server
import json
import os
import pathlib
import random
import re
import socket
import sys
import threading
import time
import urllib.parse

KINDS = ["500", "503", "403", "cut", "lost"]  # faults with --rate: the kinds that take no time; also `wrong` for PUTs
BLOCK = 1 << 20
CODES = {"500": "InternalError", "503": "SlowDown", "403": "AccessDenied"}


class Bucket:
    """State that is shared by all requests."""

    def __init__(self, options):
        self.root, self.options = pathlib.Path(options.dir).resolve(), options
        self.root.mkdir(parents=True, exist_ok=True)
        self.lock, self.rng = threading.Lock(), random.Random(options.seed)
        self.rules, self.counts, self.number = [], collections.Counter(), 0

    def fault(self, method):
        with self.lock:
            self.counts[method] += 1
            if (self.root / ".faults").exists():
                self.rules = json.loads((self.root / ".faults").read_text())
                (self.root / ".faults").unlink()
            for rule in self.rules:
                if rule["method"] == method and rule["times"] > 0:
                    rule["times"] -= 1
                    self.counts[f"{method} {rule['kind']}"] += 1
                    return rule["kind"]
            kinds = [*KINDS, "wrong"] if method == "PUT" else KINDS
            return self.rng.choice(kinds) if self.rng.random() < self.options.rate else None

    def new_file(self):
        with self.lock:
            self.number += 1
            return self.root / f".new-{os.getpid()}-{self.number}"

    def path(self, key):
        return self.root / urllib.parse.quote(key, safe="")


def signature_problem(handler, options):
    """Returns the error code of a request that must be refused; None if it is signed correctly."""
    parts = re.fullmatch(r"AWS4-HMAC-SHA256 Credential=([^/]+)/(\d{8})/([^/]+)/s3/aws4_request,\s*SignedHeaders=([^,]+),\s*Signature=([0-9a-f]{64})",
                         handler.headers.get("authorization", ""))
    if not parts:
        return "AccessDenied"
    access, day, region, names, signature = parts.groups()
    when = handler.headers.get("x-amz-date", "")
    if access != options.access:
        return "InvalidAccessKeyId"
    if not when.startswith(day) or abs(time.time() - calendar.timegm(time.strptime(when, "%Y%m%dT%H%M%SZ"))) > 900:
        return "RequestTimeTooSkewed"
    signed = names.split(";")
    if signed != sorted(signed) or not {"host", "x-amz-content-sha256", "x-amz-date"} <= set(signed):
        return "AccessDenied"
    url = urllib.parse.urlsplit(handler.path)
    pairs = sorted(urllib.parse.parse_qsl(url.query, keep_blank_values=True))
    query = "&".join(f"{urllib.parse.quote(k, safe='-_.~')}={urllib.parse.quote(v, safe='-_.~')}" for k, v in pairs)
    path = urllib.parse.quote(urllib.parse.unquote(url.path), safe="/-_.~")
    headers = "".join(f"{name}:{' '.join(handler.headers.get(name, '').split())}\n" for name in signed)
    request = "\n".join([handler.command, path, query, headers, names, handler.headers["x-amz-content-sha256"]])
    to_sign = "\n".join(["AWS4-HMAC-SHA256", when, f"{day}/{region}/s3/aws4_request", hashlib.sha256(request.encode()).hexdigest()])
    key = f"AWS4{options.secret}".encode()
    for word in (day, region, "s3", "aws4_request"):
        key = hmac.new(key, word.encode(), hashlib.sha256).digest()
    right = hmac.new(key, to_sign.encode(), hashlib.sha256).hexdigest()
    return None if hmac.compare_digest(right, signature) else "SignatureDoesNotMatch"


class Handler(http.server.BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    bucket = None

    def log_message(self, *_):
        pass

    def refuse(self, status, code):
        body = f"<?xml version='1.0'?><Error><Code>{code}</Code></Error>".encode()
        self.answer(status, {"content-length": len(body)})
        if self.command != "HEAD":
            self.wfile.write(body)
        self.close_connection = True  # the request body may be unread

    def answer(self, status, headers):
        self.send_response(status)
        for name, value in headers.items():
            self.send_header(name, str(value))
        self.end_headers()

    def cut(self):
        self.close_connection = True
        self.wfile.flush()
        self.connection.shutdown(socket.SHUT_RDWR)

    def stall(self):
        """Waits until the client has closed the connection."""
        self.connection.settimeout(120)
        try:
            while self.connection.recv(BLOCK):
                pass
        except OSError:
            pass
        self.close_connection = True

    def admit(self):
        """Returns the key and the fault of a valid request. Answers an invalid request itself and returns None."""
        fault = self.bucket.fault(self.command)
        if fault == "stall":
            return self.stall()
        if fault in CODES:
            return self.refuse(int(fault), CODES[fault])
        problem = signature_problem(self, self.bucket.options)
        if problem:
            return self.refuse(403, problem)
        name, _, key = urllib.parse.unquote(urllib.parse.urlsplit(self.path).path).lstrip("/").partition("/")
        if name != self.bucket.options.bucket or not key:
            return self.refuse(404, "NoSuchBucket")
        return key, fault

    def do_PUT(self):
        admitted = self.admit()
        if not admitted:
            return
        key, fault = admitted
        left, sha, new = int(self.headers["content-length"]), hashlib.sha256(), self.bucket.new_file()
        with open(new, "wb") as file:
            while left > 0:
                block = self.rfile.read(min(BLOCK, left))
                if not block or fault == "cut":
                    break
                if fault == "wrong":
                    block, fault = bytes([block[0] ^ 1]) + block[1:], None
                left -= len(block)
                sha.update(block)
                file.write(block)
        if left > 0:
            new.unlink()
            return self.cut()
        if sha.hexdigest() != self.headers["x-amz-content-sha256"]:
            new.unlink()
            return self.refuse(400, "XAmzContentSHA256Mismatch")
        new.rename(self.bucket.path(key))
        if fault in ("cut", "lost"):
            return self.cut()
        self.answer(200, {"content-length": 0})

    def part(self, size):
        """Returns (first, count, true if the request has a range); None if the range contains no byte of the object."""
        asked = re.fullmatch(r"bytes=(\d+)-(\d+)", self.headers.get("range", ""))
        if not asked:
            return 0, size, False
        first, last = int(asked[1]), min(int(asked[2]), size - 1)
        return (first, last - first + 1, True) if first <= last else None

    def do_GET(self):
        if self.path == "/counts":
            body = json.dumps(self.bucket.counts).encode()
            self.answer(200, {"content-length": len(body)})
            return self.wfile.write(body)
        admitted = self.admit()
        if not admitted:
            return
        key, fault = admitted
        try:
            file = open(self.bucket.path(key), "rb")
        except FileNotFoundError:
            return self.refuse(404, "NoSuchKey")
        with file:
            size = os.fstat(file.fileno()).st_size
            part = self.part(size)
            if part is None:
                return self.refuse(416, "InvalidRange")
            first, count, asked = part
            headers = {"content-length": count}
            if asked:
                headers["content-range"] = f"bytes {first}-{first + count - 1}/{size}"
            if fault == "lost":
                return self.cut()
            self.answer(206 if asked else 200, headers)
            if self.command == "GET":
                self.send_part(file, first, count, fault)

    do_HEAD = do_GET

    def send_part(self, file, first, count, fault):
        file.seek(first)
        while count > 0:
            block = file.read(min(BLOCK, count))
            if fault == "cut":
                self.wfile.write(block[: len(block) // 2])
                return self.cut()
            if fault == "wrong":
                block, fault = bytes([block[0] ^ 1]) + block[1:], None
            self.wfile.write(block)
            count -= len(block)
            with self.bucket.lock:
                self.bucket.counts["sent"] += len(block)

    def do_DELETE(self):
        admitted = self.admit()
        if not admitted:
            return
        key, fault = admitted
        if fault == "cut":
            return self.cut()
        self.bucket.path(key).unlink(missing_ok=True)
        if fault == "lost":
            return self.cut()
        self.answer(204, {})


class Server(http.server.ThreadingHTTPServer):
    daemon_threads, request_queue_size = True, 256

    def handle_error(self, request, client_address):
        if not isinstance(sys.exc_info()[1], OSError):  # the client may have closed the connection
            super().handle_error(request, client_address)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--dir", required=True)
    parser.add_argument("--port", type=int, default=0)
    parser.add_argument("--bucket", default="farm")
    parser.add_argument("--access", default="access")
    parser.add_argument("--secret", default="secret")
    parser.add_argument("--rate", type=float, default=0.0)
    parser.add_argument("--seed", type=int, default=1)
    Handler.bucket = Bucket(parser.parse_args())
    with Server(("127.0.0.1", Handler.bucket.options.port), Handler) as server:
        print(server.server_address[1], flush=True)
        server.serve_forever()


if __name__ == "__main__":
    main()
