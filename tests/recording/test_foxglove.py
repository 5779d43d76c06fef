"""`--foxglove`: messages that the published schemas accept, and that say what the frames say."""

from __future__ import annotations

import base64
import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest
from mcap.reader import make_reader

from crs_cc.cli.main import main
from crs_cc.recording.foxglove.messages import POINTS, FoxgloveView
from crs_cc.recording.recording import Recording
from crs_cc.sim.files.world_xml import empty_world


def test_scenes_and_logs_are_valid_and_are_those_of_the_frames(
    recorded: Path, tmp_path: Path
) -> None:
    path = tmp_path / "fox.mcap"
    options = ["-ex", "goto 2", "--record", str(path), "--foxglove"]
    assert main(["debug", "--batch", str(recorded), *options]) == 0
    found: dict[str, list[dict[str, object]]] = {"/scene": [], "/log": []}
    with path.open("rb") as file:
        for schema, channel, message in make_reader(file).iter_messages(topics=list(found)):
            assert schema is not None
            content = json.loads(message.data)
            jsonschema.validate(content, json.loads(schema.data))
            found[channel.topic].append(content)
    assert any(each["message"] == "told go" for each in found["/log"])
    recording = Recording(path)
    frames = list(recording.frames())
    recording.close()
    assert len(frames) == len(found["/scene"])
    for frame, scene in zip(frames, found["/scene"], strict=True):
        entities = {each["id"]: each for each in scene["entities"]}  # type: ignore[attr-defined]
        place = entities["robot robot0"]["cylinders"][0]["pose"]["position"]
        assert [place["x"], place["y"]] == pytest.approx(frame.values[:2, 0], abs=1e-4)
        assert "crate" in entities


def test_many_robots_are_points() -> None:
    values = np.zeros((3, 300))
    values[0] = np.arange(300)
    values[0, 7] = np.nan
    channel, data = FoxgloveView(empty_world()).frame(5, values, ["r"] * 300, [])
    assert channel is POINTS
    content = json.loads(data)
    jsonschema.validate(content, json.loads(POINTS.schema_data))
    points = np.frombuffer(base64.b64decode(content["data"]), "<f4").reshape(-1, 3)
    assert points[:, 0].tolist() == [x for x in range(300) if x != 7]
