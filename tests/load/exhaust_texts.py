"""Submits specs of at most 64 KiB with settings that make texts grow. Each job succeeds with G-code of a limited size
or ends with a typed error. The coordinator's memory stays below 256 MiB, and a cancelled job ends within a second."""
import json
import pathlib
import tempfile
import time

from exhaust_memory import Most
from local_farm import MODELS, running_farm

MODEL = MODELS / "textbox.stl"
SPEC_BYTES = 64 << 10
COORDINATOR_MIB = 256
CANCEL_S = 1.0
LONG = "x" * 30_000


def substitutions(*rules):
    """Returns the value of a setting with rules of pattern, replacement and flags."""
    return ";".join(json.dumps(text) for rule in rules for text in (*rule, ""))


def specs():
    """Yields a name and the settings of each job."""
    yield "doubling_rules", {"gcode_substitutions": substitutions(*[("G", "GG", "")] * 18)}
    yield "doubling_all", {"gcode_substitutions": substitutions(*[(".+", "$&$&", "rs")] * 24)}
    yield "long_replacement", {"gcode_substitutions": substitutions(("^G1", LONG, "r"))}
    yield "empty_matches", {"gcode_substitutions": substitutions(("", LONG, "r"), ("z*", LONG, "r"))}
    yield "slow_pattern", {"gcode_substitutions": substitutions(*[("(G1.*QQ)|G", "$&;", "rs")] * 60)}
    yield "layer_template", {"layer_gcode": "; " + LONG, "before_layer_gcode": "; " + LONG}
    yield "nested_template", {"printer_notes": LONG, "layer_gcode": "; {printer_notes}" * 60}
    yield "start_template", {"printer_notes": LONG, "start_gcode": "; {printer_notes}" * 60, "end_gcode": "; {printer_notes}" * 60}
    yield "templates_and_rules", {"printer_notes": LONG, "layer_gcode": "; {printer_notes}" * 20,
                                  "gcode_substitutions": substitutions(*[("x", "xx", "")] * 20)}
    yield "file_name", {"printer_notes": LONG, "output_filename_format": "{printer_notes}" * 30}


def arguments(settings):
    """Returns the settings as arguments of `slicefarm submit`, through a config file, since some are long."""
    text = "".join(f"{key} = {value}\n" for key, value in settings.items())
    assert len(text) <= SPEC_BYTES, len(text)
    with tempfile.NamedTemporaryFile("w", suffix=".ini", delete=False) as file:
        file.write(text + "layer_height = 0.05\n")
    return ["--config", file.name]


def state_of(farm, job):
    return next(each for each in farm.jobs() if each["id"] == job)["state"]


def cancel_seconds(farm, job):
    """Returns the seconds from the acknowledged cancel to the job's end."""
    farm.client("cancel", job)
    begun = time.monotonic()
    while state_of(farm, job) in ("JOB_STATE_QUEUED", "JOB_STATE_RUNNING") and time.monotonic() < begun + 60:
        time.sleep(0.02)
    return time.monotonic() - begun


def refused_at_once(done):
    """Returns True if the coordinator refused the spec with a typed error."""
    return done.returncode != 0 and "error" in done.stderr


def measure():
    for name, settings in specs():
        with running_farm() as farm:
            most = Most(farm.coordinators[0])
            config = arguments(settings)
            done = farm.client("submit", MODEL, "--detach", "-q", *config)
            typed = refused_at_once(done)
            if not typed:
                ended = farm.await_end(300)[0]
                typed = ended["state"] == "JOB_STATE_SUCCEEDED" or ended.get("error", {}).get("reason") in ("REQUEST_TOO_LARGE", "SETTING_OUT_OF_RANGE")
                job = farm.submit(MODEL, *config, "--set", "perimeters=4")
                time.sleep(0.3)
                yield f"texts_{name}_cancel_s", cancel_seconds(farm, job), CANCEL_S
            yield f"texts_{name}_untyped", not typed, 0
            yield f"texts_{name}_coordinator_mib", most.stop(), COORDINATOR_MIB
            pathlib.Path(config[1]).unlink()
