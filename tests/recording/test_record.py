"""What `crs run --record` writes can be read by others, and holds what happened."""

from __future__ import annotations

import errno
import io
import json
import time
from collections.abc import Iterable
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mcap.reader import NonSeekingReader, make_reader

from crs_cc.cli.main import main
from crs_cc.recording import frames, recording_file, topics
from crs_cc.recording.block import Block, saved_messages
from crs_cc.recording.columns import Part
from crs_cc.recording.frame_buffer import Shape
from crs_cc.recording.frames import FrameDecoder, count_in, messages
from crs_cc.recording.mcap_reader import McapReader
from crs_cc.recording.mcap_writer import MAX_CHUNK, McapWriter
from crs_cc.recording.readings import STATE, ReadingDecoder, ReadingEncoder, Readings
from crs_cc.recording.recording import Recording


def test_the_public_python_reader_reads_it_with_all_checksums(recorded: Path) -> None:
    with recorded.open("rb") as file:
        reader = make_reader(file, validate_crcs=True)
        summary = reader.get_summary()
        assert summary is not None
        assert summary.statistics is not None
        messages = list(reader.iter_messages())
        assert len(messages) == summary.statistics.message_count
        names = [each.name for each in reader.iter_attachments()]
        assert names == ["source/drive.c.zst", "source/room.xml.zst", "source/speed.h"]
        assert [each.name for each in reader.iter_metadata()] == [
            "crs.run", "crs.roster.1", "crs.result"
        ]  # fmt: skip
        for schema, channel, message in messages:
            if channel.message_encoding == "json":
                assert schema is None
                assert json.loads(message.data)["entries"]


def test_it_contains_the_events_of_the_run(recorded: Path) -> None:
    recording = Recording(recorded)
    frames = list(recording.frames())
    assert [frame.time_ns for frame in frames] == sorted(frame.time_ns for frame in frames)
    assert frames[0].values[:, 0].tolist() == [1.0, 1.0, 0.0]
    assert frames[-1].values[0, 0] > 2.0
    assert recording.rosters[0].robots == ("robot0",)
    assert recording.rosters[0].objects == ("crate",)
    kinds = [data["kind"] for _, data in recording.data(topics.EVENT.topic)]
    assert kinds == ["collision", "exited"]
    pieces = [data for _, data in recording.data(topics.OUTPUT.topic)]
    assert any("base64" in piece for piece in pieces)  # what is no UTF-8
    given = [data for _, data in recording.data(topics.INPUT.topic)]
    inputs = [data["text"] for data in given if data["kind"] == "stdin"]
    assert inputs == ["go\n"]
    codes = np.concatenate([each.codes for each in recording.readings()])
    states = np.concatenate([each.states for each in recording.readings()])
    assert (codes == 12).sum() >= 0
    assert states[:, 17].max() > 0
    assert recording.is_complete
    recording.close()


def test_the_frame_at_a_time_is_the_last_one_before_it(recorded: Path) -> None:
    recording = Recording(recorded)
    frames = list(recording.frames())
    for frame in frames[::7]:
        found = recording.frame_at(frame.time_ns + 1)
        assert found is not None
        assert found.time_ns == frame.time_ns
        np.testing.assert_array_equal(found.values, frame.values)
    recording.close()


def test_frames_are_exact_to_a_tenth_of_a_millimetre_and_of_a_milliradian(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    random = np.random.default_rng(3)
    block = random.normal(0.0, 300.0, (7, 4, 5))
    block[2:4, :, 1] = np.nan
    block[6, 0, 0] = 1e12  # farther than a frame can tell
    decoder = FrameDecoder()
    times_ns = [5, 50_000_005, 3_000_000_005, 3_000_000_006, *(4 * 10**9 + n for n in range(3))]
    ((time_ns, message),) = messages(times_ns, block)
    parts = list(decoder.frames(time_ns, message))
    assert count_in(message) == len(parts)
    assert [each for each, _ in parts] == times_ns
    again = np.array([values for _, values in parts])
    monkeypatch.setattr(frames, "MAX_GROUP", 0)
    alone = messages(times_ns, block)
    assert [each for each, _ in alone] == times_ns
    np.testing.assert_array_equal([decoder.decode(data) for _, data in alone], again)
    assert again[6, 0, 0] == pytest.approx(214748.3647)
    block[6, 0, 0] = again[6, 0, 0]
    np.testing.assert_allclose(again, block, atol=0.5e-4)


def test_numbers_out_of_range_are_written_without_a_warning() -> None:
    """A modified file may have any numbers."""
    strange = np.array([[1e308], [-np.inf], [np.nan]])
    strange.view(np.uint64)[2] = 0x7FF0000000000001  # signals when it is used
    with np.errstate(all="raise"):
        found = frames.quantized(strange).view(np.int32)
    assert found.ravel().tolist() == [2**31 - 1, -(2**31) + 1, frames.NOWHERE]


def test_readings_are_exact_and_none_are_wrong_after_a_lost_message() -> None:
    random = np.random.default_rng(4)
    encoder, decoder, sparse = ReadingEncoder(), ReadingDecoder(), ReadingDecoder()
    states = random.integers(-(2**31), 2**31, (50, STATE))
    unreadable = []
    for number in range(30):
        time_ns = number * 700_000_000
        rows = int(random.integers(0, 60))
        robots = random.integers(0, 50, rows)
        clock_s = np.arange(rows, dtype=np.float64) * 0.01 + time_ns / 1e9
        vectors = np.zeros((rows, STATE), np.int32)
        for row, robot in enumerate(robots):  # some elements change, by little or by much
            states[robot, random.integers(0, STATE, 3)] += random.integers(-9, 9)
            states[robot, random.integers(STATE)] = random.integers(-(2**31), 2**31)
            vectors[row] = states[robot].astype(np.int32)
        meant = Readings(np.arange(rows), robots, clock_s, vectors)
        data = encoder.encode(meant, time_ns)
        found = decoder.decode(data, time_ns)
        assert found is not None
        for name in ("codes", "robots", "states"):
            np.testing.assert_array_equal(getattr(found, name), getattr(meant, name))
        np.testing.assert_allclose(found.clock_s, clock_s, atol=1e-6)
        if number % 10 != 4:  # lost
            other = sparse.decode(data, time_ns)
            if other is None:
                unreadable.append(number)
            else:
                np.testing.assert_array_equal(other.states, vectors)
    assert unreadable == [*range(5, 14), *range(25, 29)]  # up to the end of ten seconds


def test_a_run_that_is_killed_loses_at_most_its_last_second(
    recorded: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = Recording(recorded)
    source.write_sources(tmp_path)
    source.close()
    path, kept = tmp_path / "run.mcap", list[bytes]()
    save = McapWriter.save

    def noted(writer: McapWriter, first_ns: int, last_ns: int, parts: Iterable[Part]) -> None:
        save(writer, first_ns, last_ns, parts)
        kept.append(path.read_bytes())

    monkeypatch.setattr(McapWriter, "save", noted)
    monkeypatch.setattr(recording_file, "BLOCK_S", 3.0)
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b"go\n")))
    files = [str(tmp_path / name) for name in ("drive.c", "room.xml")]
    main(["run", *files, "--record", str(path), "--quiet", "--max-time", "5.5"])
    assert len(kept) == 4  # at 1 and 2, 4 and 5 seconds
    often = path.read_bytes()
    monkeypatch.setattr(McapWriter, "save", lambda _writer, _first_ns, _last_ns, _parts: None)
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b"go\n")))
    main(["run", *files, "--record", str(path), "--quiet", "--max-time", "5.5"])
    assert len(kept) == 4
    assert path.read_bytes() == often  # however often it was saved
    whole = Recording(path)
    frames = [(each.time_ns, each.values.tolist()) for each in whole.frames()]
    read = sum(len(each.robots) for each in whole.readings())
    whole.close()
    cut = tmp_path / "cut.mcap"
    for content, end_s in zip(kept, (1, 2, 4, 5), strict=True):
        cut.write_bytes(content + content[-5000:-2500])  # and something that was not finished
        recording = Recording(cut)
        assert not recording.is_complete
        assert recording.end_ns == end_s * 10**9
        there = [(each.time_ns, each.values.tolist()) for each in recording.frames()]
        assert there == [each for each in frames if each[0] <= end_s * 10**9]
        assert len(list(recording.hashes())) == end_s + 1
        assert 0 < sum(len(each.robots) for each in recording.readings()) < read
        recording.close()
        with cut.open("rb") as file:  # the public reader agrees
            found = NonSeekingReader(file, validate_crcs=True)
            times: list[int] = []
            with pytest.raises(Exception):  # noqa: B017, PT011 - its errors have no common class
                times.extend(
                    each.log_time for *_, each in found.iter_messages(log_time_order=False)
                )


BURST = """\
#include <stdio.h>
#include <unistd.h>
#include <Nclient.h>
int main(void)
{
    int i, line;
    connect_robot(1);
    for (i = 0; i < 16; i++) {
        get_sn();
        printf("second %d\\n", i);
        for (line = 0; line < (i == 5 ? 9000 : 0); line++)
            printf("%06d %080d\\n", line, i);
        fflush(stdout);
        usleep(250000);
    }
    return 0;
}
"""


def test_large_output_is_written_early_and_none_is_lost_or_duplicated(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The burst comes in the middle of a second, after seconds that were saved as they were."""
    source, path, kept = tmp_path / "go.c", tmp_path / "run.mcap", list[bytes]()
    source.write_text(BURST)
    for name in ("save", "cut"):
        written = getattr(McapWriter, name)

        def noted(writer: McapWriter, *values: Any, _write: Any = written, **more: Any) -> None:
            _write(writer, *values, **more)
            kept.append(path.read_bytes())

        monkeypatch.setattr(McapWriter, name, noted)
    assert main(["run", str(source), "--record", str(path), "--quiet"]) == 0
    whole, read = told(path)
    assert whole.count("\n") == 9018  # two by connect_robot
    sizes, counts = [0], [0]
    for content in kept:
        path.write_bytes(content)  # as it is when the run is killed
        output, readings = told(path)
        assert whole.startswith(output)
        assert readings == pytest.approx(read[: len(readings)], abs=1e-6)  # kept in microseconds
        sizes.append(len(output))
        counts.append(len(readings))
    assert len(read) == 17  # one by connect_robot
    assert max(after - before for before, after in pairwise(counts)) <= 5  # in a second
    assert sizes == sorted(sizes)
    assert (
        max(after - before for before, after in pairwise(sizes)) < 1.5 * MAX_CHUNK
    )  # a message more


def told(path: Path) -> tuple[str, list[float]]:
    """Return what a recording has of the output, and the times of its readings [s]."""
    recording = Recording(path)
    pieces = [data["text"] for _, data in recording.data(topics.OUTPUT.topic)]
    times_s = [time_s for each in recording.readings() for time_s in each.clock_s.tolist()]
    recording.close()
    return "".join(pieces), times_s


def said(number: int) -> list[Part]:
    """Return what is saved of a second in which nothing happens but an event."""
    block = Block(0.0, Shape(1, 0, has_turret=False))
    block.add_entry(topics.EVENT, 1000 * number, {"n": number})
    return list(block.take_unsaved().parts())


class StoppedFile(io.BytesIO):
    """A file that keeps what it would be if its program were killed at any moment.

    Attributes:
        after: its contents after each operation, and in the middle of each longer than 9 bytes.
    """

    def __init__(self) -> None:
        super().__init__()
        self.after: list[bytes] = []

    def write(self, data: bytes) -> int:  # type: ignore[override]
        whole, at, half = self.getvalue(), self.tell(), len(data) // 2
        if len(data) > 9:
            self.after.append(whole[:at] + data[:half] + whole[at + half :])
        done = super().write(data)
        self.after.append(self.getvalue())
        return done

    def truncate(self, size: int | None = None) -> int:
        done = super().truncate(size)
        self.after.append(self.getvalue())
        return done


@pytest.mark.parametrize("size", [5, 5000])
def test_the_file_is_valid_whenever_the_writer_is_stopped(size: int, tmp_path: Path) -> None:
    """A chunk takes the place of what was saved, be it shorter or, of random bytes, longer."""
    path, random = tmp_path / "run.mcap", np.random.default_rng(5)

    file = StoppedFile()
    writer = McapWriter(file)
    sizes = []
    for number in range(9):
        writer.add(topics.OUTPUT, number, bytes([number]) + random.bytes(size))
        writer.save(number, number, said(number))
        sizes.append(len(file.getvalue()))
        if number % 4 == 3:
            for each in range(number - 3, number + 1):
                ((channel, time_ns, data),) = saved_messages(b"".join(said(each)))
                writer.add(channel, time_ns, data)
            writer.cut()
            sizes.append(len(file.getvalue()))
    known = 0
    for content in file.after:
        path.write_bytes(content)
        reader = McapReader(path)
        found = [each for chunk in reader.chunks for each in reader.messages(chunk)]
        reader.close()
        for topic in ("/crs/output", "/crs/event"):
            all_data = [each.data for each in found if each.topic == topic]
            if topic == "/crs/event":
                all_data = [bytes([json.loads(each)["entries"][0]["n"]]) for each in all_data]
            numbers = [data[0] for data in all_data]
            assert numbers == list(range(len(numbers)))
        assert len(numbers) >= known
        known = len(numbers)
    assert known == 9
    if size < 10:
        assert sizes[4] < sizes[3]


def test_a_file_does_not_depend_on_when_seconds_were_saved() -> None:
    files = []
    for saves in (False, True):
        file = io.BytesIO()
        writer = McapWriter(file)
        writer.define(topics.TOPICS.values())
        if saves:
            writer.save(1, 2, said(2))
        writer.add(topics.EVENT, 1, b"{}")
        writer.add(topics.OUTPUT, 2, b"{}")
        writer.finish()
        files.append(file.getvalue())
    assert files[0] == files[1]
    summary = make_reader(io.BytesIO(files[0])).get_summary()
    assert summary is not None
    assert [each.topic for each in summary.channels.values()] == ["/crs/event", "/crs/output"]


def test_a_full_disk_ends_the_recording_but_not_the_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    program = tmp_path / "count.c"
    program.write_text(
        "#include <stdio.h>\n#include <unistd.h>\n"
        'int main(void) { int i; for (i = 0; i < 5; i++) { printf("%d", i); sleep(1); } return 4; }'
    )
    left = 1800
    write = recording_file._UnbufferedFile.write

    def limited(self: recording_file._UnbufferedFile, data: bytes) -> int:
        nonlocal left
        left -= len(data)
        if left < 0:
            raise OSError(errno.ENOSPC, "No space left on device")
        return write(self, data)

    monkeypatch.setattr(recording_file._UnbufferedFile, "write", limited)
    path = tmp_path / "run.mcap"
    assert main(["run", str(program), "--record", str(path), "--quiet"]) == 4
    said = capfd.readouterr()
    assert said.out == "01234"
    assert "warning: the recording ends at" in said.err
    assert "No space left on device" in said.err
    recording = Recording(path)
    assert not recording.is_complete
    assert list(recording.frames())
    recording.close()


def test_recording_does_not_change_the_run(
    recorded: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    recording = Recording(recorded)
    recording.write_sources(tmp_path)
    assert recording.result is not None
    state = recording.result["state_hash"]
    recording.close()
    files = [str(tmp_path / name) for name in ("drive.c", "room.xml")]
    (tmp_path / "input").write_text("go\nmore\n")
    with (tmp_path / "input").open() as given, pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.stdin", given)
        main(["run", *files, "--json", "--quiet", "--max-time", "8"])
    assert json.loads(capfd.readouterr().out)["state_hash"] == state


def test_a_run_writes_tables_and_output_and_keeps_its_pace(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    program = tmp_path / "hello.c"
    program.write_text(
        "#include <stdio.h>\n#include <unistd.h>\n"
        'int main(void) { puts("hello"); fputs("there", stderr); sleep(1); return 0; }'
    )
    begin_s = time.monotonic()
    options = ["--csv", str(tmp_path / "tables"), "--speed", "2", "--json", "--quiet"]
    assert main(["run", str(program), *options]) == 0
    assert time.monotonic() - begin_s > 0.5
    (robot,) = json.loads(capfd.readouterr().out)["robots"]
    assert (robot["stdout"], robot["stderr"]) == ("hello\n", "there")
    assert not robot["output_truncated"]
    names = sorted(path.name for path in (tmp_path / "tables").iterdir())
    assert names == ["events.csv", "messages.csv", "poses.csv", "sensors.csv"]
    assert main(["run", str(program), "--speed", "fast"]) == 2


@pytest.mark.parametrize(("sensors", "least", "most"), [("none", 0, 0), ("all", 20, 45)])
def test_the_recorded_sensors_can_be_selected(
    tmp_path: Path, sensors: str, least: int, most: int
) -> None:
    program, path = tmp_path / "turn.c", tmp_path / "run.mcap"
    program.write_text(
        "#include <Nclient.h>\nint main(void) { connect_robot(1); vm(50, -50, 0); for (;;) ; }"
    )
    options = ["--record", str(path), "--record-sensors", sensors, "--record-every", "100ms"]
    assert main(["run", str(program), *options, "--max-time", "2", "--quiet"]) == 0
    recording = Recording(path)
    found = list(recording.readings())
    assert least <= sum(len(each.robots) for each in found) <= most
    if sensors == "all":
        unasked = np.concatenate([each.states[each.codes == 0] for each in found])
        assert len(np.unique(unasked[:, 36])) > 10  # it turns, and nobody asks
    assert 20 <= len(list(recording.frames())) <= 23
    recording.close()
