"""`--foxglove`: messages that the published schemas accept, and that say what the frames say."""

from __future__ import annotations

import base64
import json
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from jsonschema.protocols import Validator
from jsonschema.validators import validator_for
from mcap.reader import make_reader

from crs_cc.cli.main import main
from crs_cc.recording import recording_file
from crs_cc.recording.foxglove.messages import POINTS, FoxgloveView
from crs_cc.recording.recording import Recording
from crs_cc.sim.files.world_xml import empty_world


@cache
def validator(schema_data: bytes) -> Validator:
    """Return what validates messages by a schema, which is itself valid."""
    schema = json.loads(schema_data)
    made = validator_for(schema)
    made.check_schema(schema)
    return made(schema)


def test_scenes_and_logs_are_valid_and_match_the_frames(
    recorded: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "fox.mcap"
    options = ["-ex", "goto 3", "--record", str(path), "--foxglove"]
    monkeypatch.setattr(recording_file, "BLOCK_S", 2.0)
    assert main(["debug", "--batch", str(recorded), *options]) == 0
    found: dict[str, list[dict[str, object]]] = {"/scene": [], "/log": []}
    with path.open("rb") as file:
        for schema, channel, message in make_reader(file).iter_messages(topics=list(found)):
            assert schema is not None
            content = json.loads(message.data)
            validator(schema.data).validate(content)
            found[channel.topic].append(content)
    assert any(each["message"] == "told go" for each in found["/log"])
    recording = Recording(path)
    frames = list(recording.frames())
    recording.close()
    assert len(frames) == len(found["/scene"])
    damaged, mended = tmp_path / "damaged.mcap", tmp_path / "mended.mcap"
    content = bytearray(path.read_bytes())
    content[recording.mcap.chunks[0].extent.at + 60] ^= 255
    damaged.write_bytes(content)
    assert main(["replay", str(damaged), "--recover", str(mended)]) == 0
    with mended.open("rb") as file:
        rows = list(make_reader(file).iter_messages(topics=["/scene", "/log"]))
    assert {channel.topic for _, channel, _ in rows} == set(found)
    assert all(schema.name.startswith("foxglove.") for schema, _, _ in rows if schema)
    assert json.loads(rows[-1][2].data) == found[rows[-1][1].topic][-1]
    for frame, scene in zip(frames, found["/scene"], strict=True):
        entities = {each["id"]: each for each in scene["entities"]}  # type: ignore[attr-defined]
        place = entities["robot robot0"]["cylinders"][0]["pose"]["position"]
        assert [place["x"], place["y"]] == pytest.approx(frame.values[:2, 0], abs=1e-4)
        assert "crate" in entities


ROOT = Path(__file__).parents[2]
SCANNER = """
#include <Nclient.h>
#include <crs.h>
#include <unistd.h>
int main(void) {
    static int ranges[482]; static struct crs_pixel row[320]; int i;
    connect_robot(1); conf_tm(0);
    for (i = 0; i < 2; i++) { crs_laser(ranges, 482); crs_camera(row, 320); sleep(1); }
    return 0;
}
"""
SEEN = """<world version="1" timestep="100ms"><area length="4m" width="3m"/>
  <box id="red" x="2m" y="1.5m" length="0.4m" width="3m" colour="red"/>
  <robot id="other" x="3m" y="2m"/><robot id="eye" definition="eye.xml" x="1m" y="1.5m"/>
</world>
"""


def test_scans_and_pictures_of_a_robot_are_valid_and_show_the_world(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    program, path = tmp_path / "scan.c", tmp_path / "run.mcap"
    (tmp_path / "world.xml").write_text(SEEN)
    (tmp_path / "eye.xml").write_bytes((ROOT / "worlds" / "lib" / "seer.xml").read_bytes())
    program.write_text(SCANNER)
    command = ["run", str(program), str(tmp_path / "world.xml"), "--record", str(path), "--quiet"]
    assert main([*command, "--foxglove-robot", "eye"]) == 0
    found: dict[str, list[dict[str, Any]]] = {"/eye/scan": [], "/eye/camera": []}
    with path.open("rb") as file:
        for schema, channel, message in make_reader(file).iter_messages():
            assert "other" not in channel.topic
            if channel.topic in found:
                assert schema is not None
                content = json.loads(message.data)
                validator(schema.data).validate(content)
                found[channel.topic].append(content)
    scan, picture = found["/eye/scan"][0], found["/eye/camera"][0]
    middle = scan["ranges"][len(scan["ranges"]) // 2]
    assert scan["pose"]["position"]["x"] + middle == pytest.approx(1.8, abs=0.02)
    pixels = np.frombuffer(base64.b64decode(picture["data"]), np.uint8)
    rows = pixels.reshape(picture["height"], picture["width"], 3)
    assert rows[3, picture["width"] // 2].tolist() == [255, 0, 0]
    assert main([*command, "--foxglove-robot", "eve"]) == 2
    assert "unknown robot 'eve'" in capfd.readouterr().err


def test_many_robots_are_points() -> None:
    values = np.zeros((3, 300))
    values[0] = np.arange(300)
    values[0, 7] = np.nan
    channel, data = FoxgloveView(empty_world()).frame(5, values, ["r"] * 300, [])
    assert channel is POINTS
    content = json.loads(data)
    validator(POINTS.schema_data).validate(content)
    points = np.frombuffer(base64.b64decode(content["data"]), "<f4").reshape(-1, 3)
    assert points[:, 0].tolist() == [x for x in range(300) if x != 7]
