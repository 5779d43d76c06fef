"""`crs replay`: summary, instants, exports, verification, recovery."""

from __future__ import annotations

import csv
import json
import shutil
from pathlib import Path
from tempfile import gettempdir

import pytest

from crs_cc.cli.main import main
from crs_cc.recording.hashes import entry_of, hashes_in
from crs_cc.recording.mcap_reader import McapReader
from crs_cc.recording.mcap_writer import McapWriter
from crs_cc.recording.recording import Recording
from crs_cc.recording.topics import TOPICS


def rewritten(source: Path, target: Path, *, run: dict[str, str] | None = None) -> None:
    """Copy a recording with a changed description, and changed hashes at 2 s if there is none."""
    reader = McapReader(source)
    with target.open("wb") as file:
        writer = McapWriter(file)
        for name, values in reader.metadata.items():
            writer.metadata(name, {**values, **(run or {})} if name == "crs.run" else values)
        for name in reader.attachments:
            writer.attachment(name, reader.attachment(name))
        for chunk in reader.chunks:
            for message in reader.messages(chunk):
                data = message.data
                if run is None and message.topic == "/crs/hash":
                    (entry,) = json.loads(data)["entries"]
                    hashes = [
                        each._replace(digest="0" * 4) if each.timesteps == 40 else each
                        for each in hashes_in(entry)
                    ]
                    entry.update(entry_of(hashes))
                    data = json.dumps({"entries": [entry]}).encode()
                writer.add(TOPICS[message.topic], message.time_ns, data)
            writer.cut()
        writer.finish()
    reader.close()


def rewritten_event(source: Path, target: Path, values: dict[str, object]) -> None:
    """Copy a recording with other values in what programs drew, changes of them, and fields."""
    reader = McapReader(source)
    with target.open("wb") as file:
        writer = McapWriter(file)
        for name, known in reader.metadata.items():
            writer.metadata(name, known)
        for name in reader.attachments:
            writer.attachment(name, reader.attachment(name))
        for chunk in reader.chunks:
            for message in reader.messages(chunk):
                data = message.data
                if message.topic in ("/crs/input", "/crs/event", "/crs/field"):
                    entries = json.loads(data)["entries"]
                    for entry in entries:
                        if entry.get("patches") or "mark" in entry or "shares" in entry:
                            entry.update(values)
                    data = json.dumps({"entries": entries}).encode()
                writer.add(TOPICS[message.topic], message.time_ns, data)
        writer.finish()
    reader.close()


def test_it_prints_a_summary_by_default(recorded: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["replay", str(recorded)]) == 0
    said = capfd.readouterr().out
    assert "1 robot" in said
    assert "program   drive.c" in said
    assert "events    1 collision, 1 exited" in said
    assert "robot0    exited with 3" in said
    recording = Recording(recorded)
    assert f"recorded  {len(list(recording.frames()))} frames, " in said
    recording.close()


def test_it_shows_the_state_at_a_time(recorded: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["replay", str(recorded), "--at", "1.5s"]) == 0
    said = capfd.readouterr().out
    assert " at 1.500 s\n" in said
    assert "crate" in said
    assert "x 3.000 m  y 1.000 m" in said
    assert "robot0  2 " in said
    assert main(["replay", str(recorded), "--at", "soon"]) == 2
    for command in ("replay", "debug"):
        capfd.readouterr()
        options = ["--batch"] if command == "debug" else []
        assert main([command, *options, str(recorded), "--at", "99s"]) == 0
        assert ", before 99 s: this is its end" in capfd.readouterr().err


def test_tables_have_units_and_no_formulas(recorded: Path, tmp_path: Path) -> None:
    assert main(["replay", str(recorded), "--csv", str(tmp_path)]) == 0
    rows = {path.stem: list(csv.DictReader(path.open(newline=""))) for path in tmp_path.iterdir()}
    assert set(rows) == {"poses", "sensors", "events", "messages"}
    assert rows["poses"][0]["x [m]"] == "1.0"
    assert {row["name"] for row in rows["poses"]} == {"robot0", "crate"}
    assert rows["events"][0]["kind"] == "collision"
    assert float(rows["events"][0]["x [m]"]) > 2.0
    sonar = [row for row in rows["sensors"] if row["request"] == "GET_SN"]
    assert len(sonar) == 12
    assert int(sonar[0]["sonar 0 [in]"]) > 0


def test_it_plots(recorded: Path, tmp_path: Path) -> None:
    picture = tmp_path / "path.svg"
    assert main(["replay", str(recorded), "--plot", str(picture)]) == 0
    assert b"drive.c in room.xml" in picture.read_bytes()


def test_the_same_run_is_verified(recorded: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["replay", str(recorded), "--verify"]) == 0
    assert "the same run" in capfd.readouterr().out


def test_a_different_run_is_reported_with_its_second_and_the_versions(
    recorded: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    other = tmp_path / "other.mcap"
    rewritten(recorded, other)
    assert main(["replay", str(other), "--verify"]) == 125
    said = capfd.readouterr().err
    assert "the run differs from its recording at 2.00 s: the state differs" in said
    assert "recorded with the same versions as here: crs" in said
    rewritten(recorded, other, run={"numpy": "1.0"})
    assert main(["replay", str(other), "--verify"]) == 0


def test_a_damaged_recording_is_recovered(
    recorded: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    whole, reader = recorded.read_bytes(), McapReader(recorded)
    half = reader.chunks[len(reader.chunks) // 2].extent.at + 20
    reader.close()
    broken, mended = tmp_path / "broken.mcap", tmp_path / "mended.mcap"
    broken.write_bytes(whole[:half])
    assert main(["replay", str(broken)]) == 0
    assert "before the end of the run" in capfd.readouterr().err
    assert main(["replay", str(broken), "--recover", str(broken)]) == 2
    assert main(["replay", str(broken), "--recover", str(mended)]) == 0
    assert "lost: 0 chunks" in capfd.readouterr().out
    mine, theirs = Recording(mended), Recording(recorded)
    frames = list(mine.frames())
    assert 0 < len(frames) < len(list(theirs.frames()))
    for found, meant in zip(frames, theirs.frames(), strict=False):
        assert (found.values == meant.values).all()
    mine.close()
    theirs.close()
    assert main(["replay", str(mended), "--verify"]) == 0


@pytest.mark.parametrize(
    ("run", "reason"),
    [
        ({"format": "7"}, "its format is 7 (this version reads 6)"),
        ({"run": "[" * 100_000}, "not valid JSON"),
        ({"run": '{"sources": ["../../etc/passwd"]}'}, "not a name of a file below a folder"),
        ({"run": '{"seed": 1e400}'}, "invalid seed"),
    ],
)
def test_an_invalid_description_is_rejected(
    recorded: Path,
    tmp_path: Path,
    capfd: pytest.CaptureFixture[str],
    run: dict[str, str],
    reason: str,
) -> None:
    other = tmp_path / "other.mcap"
    rewritten(recorded, other, run=run)
    assert main(["replay", str(other), "--verify"]) == 120
    assert reason in capfd.readouterr().err


def test_other_files_are_rejected(
    recorded: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    other = tmp_path / "other.mcap"
    other.write_bytes(b"\x89PNG")
    assert main(["replay", str(other)]) == 120
    assert "not an MCAP file" in capfd.readouterr().err
    assert main(["replay", str(tmp_path)]) == 120
    assert main(["replay", str(tmp_path / "none.mcap")]) == 120
    shutil.copy(recorded, other)
    with other.open("r+b") as file:  # the first chunk declares 2**63 bytes
        at = McapReader(recorded).chunks[0].extent.at
        file.seek(at + 16)
        file.write((2**63).to_bytes(8, "little"))
    assert main(["replay", str(other)]) == 120


def test_the_debugger_goes_to_a_time_in_a_recording_and_steps_back(
    recorded: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    commands = ["-ex", "print i", "-ex", "reverse-step", "-ex", "reverse-step", "-ex", "goto 5"]
    assert main(["debug", "--batch", str(recorded), "--at", "2s", *commands]) == 0
    said = capfd.readouterr()
    assert "told go" in said.out  # its recorded input
    assert "= 3" in said.out
    assert "t = 5.000 s" in said.out
    assert "differs" not in said.err
    assert "main () at " in said.out
    assert gettempdir() not in said.out  # its files have the names that they had
    assert main(["debug", "--batch", str(recorded), "room.xml"]) == 2


def test_the_debugger_reports_a_different_run(
    recorded: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    other = tmp_path / "other.mcap"
    rewritten(recorded, other)
    assert main(["debug", "--batch", str(other), "--at", "5s"]) == 0
    assert "the run differs from its recording at 2.00 s" in capfd.readouterr().err


def test_timed_input_is_recorded_with_the_replies_to_programs(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    program, keys, path = (tmp_path / name for name in ("wait.c", "keys.txt", "run.mcap"))
    program.write_text(
        "#include <poll.h>\n#include <stdio.h>\n#include <unistd.h>\n"
        "int main(void) { struct pollfd file = {0, POLLIN, 0}; int i;\n"
        'for (i = 0; i < 8; i++) { printf("%d", poll(&file, 1, 100)); usleep(100000); }\n'
        'printf(" %c\\n", getchar()); return 0; }\n'
    )
    keys.write_text("1s: x\n")
    assert main(["run", str(program), "--input", str(keys), "--record", str(path)]) == 0
    said = capfd.readouterr().out
    assert "0" in said
    assert said.endswith("1 x\n")
    assert main(["replay", str(path), "--verify"]) == 0
    capfd.readouterr()
    commands = ["-ex", "goto 0.3", "-ex", "goto 2"]
    assert main(["debug", "--batch", str(path), "--at", "1.5", *commands]) == 0
    found = capfd.readouterr()
    assert "differs" not in found.err
    assert said in found.out


def test_tables_are_written_as_parquet_and_arrow(recorded: Path, tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    options = ["--parquet", str(tmp_path / "p"), "--arrow", str(tmp_path / "a")]
    assert main(["replay", str(recorded), *options, "--csv", str(tmp_path / "c")]) == 0
    found = parquet.read_table(tmp_path / "p" / "poses.parquet").to_pylist()
    with (tmp_path / "c" / "poses.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(found) == len(rows)
    assert [str(row["x [m]"]) for row in found] == [row["x [m]"] for row in rows]
    assert found[0]["turret [deg]"] is None
    assert len(list((tmp_path / "a").iterdir())) == 4


def test_a_debugged_run_is_recorded_in_its_current_state(
    recorded: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "debugged.mcap"
    there = ["-ex", "goto 4", "-ex", "reverse-step", "-ex", "goto 2"]
    assert main(["debug", "--batch", str(recorded), *there, "--record", str(path)]) == 0
    mine, theirs = Recording(path), Recording(recorded)
    assert mine.end_ns == 2_000_000_000
    assert main(["replay", str(path), "--verify"]) == 0  # by other builds of the programs
    pairs = zip(mine.frames(), theirs.frames(), strict=False)
    assert all((own.values == other.values).all() for own, other in pairs)
    mine.close()
    theirs.close()


def test_changes_by_the_user_are_recorded_and_repeated(
    recorded: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    path, again = tmp_path / "changed.mcap", tmp_path / "again.mcap"
    lines = [
        "goto 1", "move robot0 to 1 2 90", "degrade robot0 sonar.0 dead", "break 19 if i == 4",
        "continue", "print 30 + 4", "print i = $ - 27", "delete", "goto 3", "move crate to 2 1",
        "goto 2.9", "print i", "goto 3.5",
    ]  # fmt: skip
    commands = [part for line in lines for part in ("-ex", line)]
    assert main(["debug", "--batch", str(recorded), *commands, "--record", str(path)]) == 0
    first = capfd.readouterr().out
    assert "= 7" in first
    recording = Recording(path)
    given = [data for _, data in recording.data("/crs/input") if data["kind"] == "change"]
    assert [each["text"] for each in given] == [
        "move robot0 to 1 2 90", "degrade robot0 sonar.0 dead", "i = $ - 27", "move crate to 2 1"
    ]  # fmt: skip
    assert len(given[2]["patches"]) == 1
    last = list(recording.frames())[-1]
    assert last.values[0].tolist() == pytest.approx([1.0, 2.0], abs=0.01)
    recording.close()
    assert main(["replay", str(path), "--verify"]) == 0
    assert "the same run: 5 hashes agree, 1 of them of the complete state" in capfd.readouterr().out
    look = ["-ex", "print i", "-ex", "info robots", "-ex", "goto 0.5", "-ex", "info robots"]
    options = ["--at", "3", *look, "-ex", "goto 3.5", "--record", str(again)]
    assert main(["debug", "--batch", str(path), *options]) == 0
    said = capfd.readouterr()
    assert said.err == ""
    assert main(["replay", str(again), "--verify"]) == 0
    rewritten_event(path, again, {"robot": 9})
    assert main(["replay", str(again), "--verify"]) == 125
    assert "memory of a robot that does not exist" in capfd.readouterr().err
    assert main(["debug", "--batch", str(again), "--at", "3"]) == 0
    assert "a recorded change cannot be repeated" in capfd.readouterr().err
    rewritten_event(path, again, {"position": [1, 2]})
    assert main(["replay", str(again), "--verify"]) == 120
