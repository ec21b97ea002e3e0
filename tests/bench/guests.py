#!/usr/bin/env python3
"""Measures the time of a tenant's small job, alone and while another tenant's long jobs occupy all --jobs.

usage: guests.py [GUESTS...]      values of --guests (0 12)
"""
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from local_farm import BIN, MODELS, running_farm

LONG = ["--set", "layer_height=0.05", "--set", "fill_pattern=gyroid", "--set", "fill_density=40"]


def submit(farm, tenant, *arguments):
    command = [BIN / "slicefarm", "submit", MODELS / "textbox.stl", "--generic", "-q", "--server", farm.coordinators[0].address, *arguments]
    return subprocess.run(command, env=os.environ | {"SLICEFARM_TOKEN": f"token-of-{tenant}"}, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True)


def small_job_s(farm, out, number):
    begin = time.monotonic()
    done = submit(farm, "b", "-o", out, "--set", f"fill_density={number}")
    assert done.returncode == 0, done.stderr
    return time.monotonic() - begin


def main():
    tenants = {"tenants": {name: {"tokens": [{"sha256": hashlib.sha256(f"token-of-{name}".encode()).hexdigest(),
                                              "scopes": ["submit", "read"]}]} for name in "ab"}}
    for guests in sys.argv[1:] or ["0", "12"]:
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "tenants.json"
            file.write_text(json.dumps(tenants))
            with running_farm(extra=["--tenants", str(file), "--jobs", "2", "--guests", guests]) as farm:
                out = pathlib.Path(folder) / "out.gcode"
                alone = sorted(small_job_s(farm, out, 10 + i) for i in range(3))[1]
                for i in range(2):
                    done = submit(farm, "a", "--detach", *LONG, "--set", f"infill_speed={50 + i}")
                    assert done.returncode == 0, done.stderr
                while (farm.coordinators[0].metric('slicefarm_jobs{state="RUNNING"}') or 0) < 2:
                    time.sleep(0.05)
                beside = small_job_s(farm, out, 20)
                running = farm.coordinators[0].metric('slicefarm_jobs{state="RUNNING"}')
                print(f"--guests {guests}: alone {alone:.1f} s, beside two long jobs {beside:.1f} s; of these run still {running:.0f}")


if __name__ == "__main__":
    main()
