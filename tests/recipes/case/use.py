"""The case by itself: it passes, and each of its faults turns red."""

import json
import pathlib

from program import expect, verify

expect("Beats of two particles" in verify("--list"), "talus_verify --list does not name the case")
verify("--only", "beats", "--jobs", "1", "--out", "verify")
found = json.loads(pathlib.Path("verify/results.json").read_text())
expect([case["id"] for case in found["cases"]] == ["beats"], "results.json has another case")
