#!/usr/bin/env python3
"""Tests a server that runs out of file descriptors. With gRPC 1.51 it never accepts a connection again (CVE-2023-4785).
It must therefore end by itself with its own exit code, so that its supervisor restarts it.

usage: deaf_test.py
"""
import socket
import subprocess
import sys
import tempfile

from door_farm import BIN

TAKES_NO_CONNECTIONS = 3


def start(folder, *arguments):
    command = ["prlimit", "--nofile=128", BIN / "slicefarm-worker", "--listen", "127.0.0.1:0", "--accept-patience", "3", *arguments]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=open(f"{folder}/log", "w"), text=True)
    line = process.stdout.readline()
    assert line.startswith("listening on "), line
    return process, int(line.rsplit(":", 1)[1])


def main():
    with tempfile.TemporaryDirectory() as folder:
        process, port = start(folder)
        assert subprocess.run([BIN / "slicefarm", "health", f"127.0.0.1:{port}"], stdout=subprocess.DEVNULL).returncode == 0
        held = [socket.create_connection(("127.0.0.1", port)) for _ in range(300)]
        for connection in held:
            connection.close()
        code = process.wait()
        log = open(f"{folder}/log").read()
        assert code == TAKES_NO_CONNECTIONS, (code, log)
        assert "no new connection is taken any more" in log, log
        assert '"msg":"stopped"' in log, log
        print("ended with", code)


if __name__ == "__main__":
    sys.exit(main())
