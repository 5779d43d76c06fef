"""The page of a recorded run: what is in it, and what a browser makes of it without a network."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crs_cc.cli.main import main
from crs_cc.cli.recording_plot import world_of
from crs_cc.recording.recording import Recording
from crs_cc.workbench import page
from crs_cc.workbench.page import html_page
from crs_cc.workbench.recorded_content import fields_in
from tests.workbench.in_browser import chromium

VIEWER = Path(page.__file__).parent / "static"
DECODE = """
const { inflate, fromBase64, decodeBlock } = await import(process.argv[1]);
for (const [, , text] of JSON.parse(process.argv[2]))
  for (const { time, values } of decodeBlock(await inflate(fromBase64(text))))
    console.log(JSON.stringify([time, ...values]));
"""


def run_in(html: str) -> Any:
    found = re.search(r'<script type="application/json" id="run">(.*?)</script>', html, re.DOTALL)
    assert found is not None
    return json.loads(found[1])


@pytest.fixture(scope="module")
def html(recorded: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("page") / "run.html"
    assert main(["replay", str(recorded), "--html", str(path)]) == 0
    return path


def test_a_page_contains_the_run(html: Path) -> None:
    text = html.read_text()
    run = run_in(text)
    assert (run["programs"], run["world_name"]) == ("drive.c", "room.xml")
    assert "left out" not in run["note"]
    assert [each["id"] for each in run["world"]["shapes"]][-1] == "crate"
    assert [each[1] for each in run["events"]] == ["collision", "exited"]
    assert "told go\n" in [each[3] for each in run["output"]]
    assert len(run["paths"]) == 2
    assert "default-src 'none'" in text  # it could load nothing if it wanted to


def test_a_page_that_would_be_too_large_is_thinned_with_a_note(recorded: Path) -> None:
    recording = Recording(recorded)
    text = html_page(recording, world_of(recording), most_bytes=600)
    recording.close()
    assert "left out: all but 1 in" in run_in(text)["note"]


def test_a_page_has_the_fields_of_the_recording(
    html: Path, fields_folder: Path, tmp_path: Path
) -> None:
    page = tmp_path / "fields.html"
    assert main(["replay", str(fields_folder / "run.mcap"), "--html", str(page)]) == 0
    run = run_in(page.read_text())
    assert run["world"]["fields"] == ["trail", "smoke"]
    assert {each["name"] for each in run["fields"]} == {"trail", "smoke"}
    run = run_in(html.read_text())
    assert (run["world"]["fields"], run["fields"]) == ([], None)


def test_sketches_of_fields_are_thinned_to_a_size(fields_folder: Path) -> None:
    recording = Recording(fields_folder / "run.mcap")
    whole, stride = fields_in(recording)
    few, thinned = fields_in(recording, 1500)
    text = html_page(recording, world_of(recording), most_bytes=18_750)
    recording.close()
    assert (stride, thinned) == (1, 2)
    for name in ("trail", "smoke"):
        times_s = [[each["t"] for each in found if each["name"] == name] for found in (whole, few)]
        assert times_s[1] == times_s[0][::2]
    assert "left out: all but 1 in 2 sketches of fields" in run_in(text)["note"]


def test_the_viewers_decoder_agrees_with_ours(recorded: Path, html: Path) -> None:
    if shutil.which("node") is None:
        pytest.skip("node not found: the viewer's decoder cannot be run")
    module = (VIEWER / "frames.js").as_uri()
    command = ["node", "--input-type=module", "-e", DECODE, module]
    blocks = json.dumps(run_in(html.read_text())["blocks"])
    done = subprocess.run([*command, blocks], capture_output=True, timeout=60, check=True)
    rows = [json.loads(line) for line in done.stdout.splitlines()]
    recording = Recording(recorded)
    frames = list(recording.frames())
    recording.close()
    assert len(rows) == len(frames)
    for row, frame in zip(rows, frames, strict=True):
        assert row[0] == frame.time_s
        np.testing.assert_allclose(row[1:], frame.values.ravel(), atol=1e-6)


def test_a_browser_shows_it_without_a_network(html: Path, tmp_path: Path) -> None:
    options = [
        *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run"),
        *("--disable-background-networking", "--disable-component-update", "--disable-sync"),
        *(f"--user-data-dir={tmp_path}", "--virtual-time-budget=3000", "--dump-dom"),
        "--host-resolver-rules=MAP * ~NOTFOUND",
    ]
    done = subprocess.run(
        [chromium(), *options, html.as_uri()],
        capture_output=True, text=True, timeout=120, check=True,
    )  # fmt: skip
    assert 'data-time="0.000"' in done.stdout  # a frame was drawn
    assert "<title>drive.c in room.xml" in done.stdout
    assert "0.000 s</output>" in done.stdout  # the clock
    assert 'title="Play the recording"' in done.stdout
