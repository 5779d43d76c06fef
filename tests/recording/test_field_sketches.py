"""What recordings have of pheromone fields: what lay where, at any time, and nothing hostile."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crs_cc.api.session import Session
from crs_cc.cli.main import main
from crs_cc.core.errors import RecordingError
from crs_cc.recording import recording_file
from crs_cc.recording.field_sketches import MAX_SIDE, TOLERANCE, FieldSketch, sketches_in
from crs_cc.recording.mcap_reader import McapReader
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.mcap_writer import McapWriter
from crs_cc.recording.recording import Recording
from tests.recorded_fields import record
from tests.recording.test_hostile import unpacked
from tests.recording.test_replay import rewritten_event


@pytest.fixture
def sketches(fields_folder: Path) -> list[tuple[float, FieldSketch]]:
    """Return the recorded sketches with their times [s]."""
    recording = Recording(fields_folder / "run.mcap")
    found = [(time_ns / NS, sketch) for time_ns, sketch in sketches_in(recording)]
    recording.close()
    return found


def test_sketches_predict_the_field_at_every_second(
    fields_folder: Path, sketches: list[tuple[float, FieldSketch]]
) -> None:
    session = Session(fields_folder / "room.xml")
    for second in range(1, 7):
        session.run(second)
        for name in ("trail", "smoke"):
            time_s, sketch = [each for each in sketches if each[0] <= second + 1e-9
                              and each[1].name == name][-1]  # fmt: skip
            amounts, square_m = session.inner.environment.field_sketch(name, MAX_SIDE)
            assert (sketch.square_m, sketch.x_m, sketch.y_m) == (square_m, -6.0, -2.0)
            left = sketch.most * math.exp(-(second - time_s) / sketch.evaporation_s)
            found = sketch.shares / 255 * left
            assert np.array_equal(found > 0.0, amounts > 0.0)
            most = amounts.max()
            np.testing.assert_allclose(found, amounts, rtol=0, atol=(TOLERANCE + 1 / 255) * most)
    assert most > 0.0


def test_a_field_that_only_evaporates_is_not_recorded_again(
    sketches: list[tuple[float, FieldSketch]],
) -> None:
    times_s = [round(time_s, 3) for time_s, each in sketches if each.name == "trail"]
    assert times_s[:3] == [0.0, 2.0, 5.0]
    times_s = [round(time_s, 3) for time_s, each in sketches if each.name == "smoke"]
    assert times_s[:2] == [0.0, 5.0]


def test_run_and_bytes_do_not_depend_on_how_often_it_was_saved(
    fields_folder: Path,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(recording_file, "MAX_CHUNK", 20_000)
    record(fields_folder, tmp_path / "often.mcap")
    monkeypatch.setattr(McapWriter, "save", lambda _writer, _first_ns, _last_ns, _parts: None)
    record(fields_folder, tmp_path / "once.mcap")
    assert (tmp_path / "often.mcap").read_bytes() == (tmp_path / "once.mcap").read_bytes()
    assert main(["replay", str(tmp_path / "often.mcap"), "--verify"]) == 0
    assert "the same run" in capfd.readouterr().out


def test_a_world_without_fields_has_no_field_messages(recorded: Path) -> None:
    recording = Recording(recorded)
    assert not list(recording.messages("/crs/field"))
    recording.close()


GOOD = FieldSketch.made("a", np.eye(3), (0.0, 0.0), 0.1, 40.0).entry()


@pytest.mark.parametrize(
    "values",
    [
        {"field": 1},
        {"field": "x" * 2000},
        {"rows": 0},
        {"rows": True, "columns": 9},
        {"rows": 4},
        {"rows": 3.0},
        {"columns": 10**9},
        {"most": -1.0},
        {"most": float("nan")},
        {"x_m": float("inf")},
        {"y_m": "0"},
        {"square_m": 0.0},
        {"square_m": True},
        {"evaporation_s": 0.0},
        {"evaporation_s": float("nan")},
        {"shares": None},
        {"shares": "!"},
        {"shares": "A" * 10**6},
    ],
)
def test_an_invalid_sketch_is_rejected(values: dict[str, Any]) -> None:
    assert FieldSketch.of(GOOD).shares.tolist() == (255 * np.eye(3)).tolist()
    with pytest.raises(ValueError, match=r"a field has|base64|[Ii]ncorrect padding"):
        FieldSketch.of({**GOOD, **values})


@pytest.mark.parametrize("values", [{"most": 10**400}, {"field": None}, {"rows": []}])
def test_a_recording_with_an_invalid_sketch_gives_one_error(
    fields_folder: Path,
    tmp_path: Path,
    capfd: pytest.CaptureFixture[str],
    values: dict[str, object],
) -> None:
    path = tmp_path / "other.mcap"
    rewritten_event(fields_folder / "run.mcap", path, values)
    assert main(["replay", str(path), "--html", str(tmp_path / "run.html")]) == 120
    assert capfd.readouterr().err.count("error:") == 1


def test_mutated_sketches_are_rejected_or_within_bounds(
    fields_folder: Path, tmp_path: Path
) -> None:
    reader = McapReader(fields_folder / "run.mcap")
    plain = unpacked((fields_folder / "run.mcap").read_bytes(), reader)
    reader.close()
    begin = plain.index(b'"field":"trail"')
    end = plain.index(b'"shares":"', begin) + 60
    random, path = np.random.default_rng(21), tmp_path / "mutated.mcap"
    said, read = set(), 0
    for _ in range(150):
        data = bytearray(plain)
        for at in random.integers(begin, end, 2).tolist():
            data[at] = int(random.integers(256)) if random.random() < 0.5 else ord("9")
        path.write_bytes(data)
        recording = Recording(path)
        try:
            found = list(sketches_in(recording))
        except RecordingError as error:
            said.add(str(error))
        else:
            read += 1
            assert all(each.shares.size <= MAX_SIDE**2 for _, each in found)
            assert all(0.0 <= each.most < np.inf for _, each in found)
        finally:
            recording.close()
    assert len(said) > 5
    assert read > 5
