"""Recordings with changed bytes: one clear error or a result, never a traceback or a hang.

`CRS_MUTATIONS=2000 pytest tests/recording/test_hostile.py` tries as many as the figure says.
"""

from __future__ import annotations

import io
import os
import resource
import time
from collections.abc import Iterable
from pathlib import Path

import numpy as np
import pytest
import zstandard

from crs_cc.cli.main import main
from crs_cc.cli.show_recording import state_at, summary
from crs_cc.cli.tables import tables
from crs_cc.core.errors import CrsError
from crs_cc.recording.columns import Part
from crs_cc.recording.mcap_reader import McapReader
from crs_cc.recording.mcap_records import CHUNK_HEAD, MAGIC, Op, record, text
from crs_cc.recording.mcap_writer import McapWriter
from crs_cc.recording.recording import Recording
from crs_cc.recording.recovery import recover

COUNT = int(os.environ.get("CRS_MUTATIONS", "60"))


def mutated(content: bytes, random: np.random.Generator) -> bytes:
    """Return a recording with some bytes changed, cut out, put in, or cut off."""
    data = bytearray(content)
    for _ in range(int(random.integers(1, 6))):
        at = int(random.integers(len(data)))
        size = int(random.integers(1, 40))
        match random.integers(6):
            case 0:
                data[at] ^= 1 << int(random.integers(8))
            case 1:
                data[at : at + size] = random.bytes(size)
            case 2:
                del data[at : at + size]
            case 3:
                data[at:at] = data[: size * 8]
            case 4:
                data[at : at + 8] = int(random.integers(2**63)).to_bytes(8, "little")
            case _:
                del data[at + 1 :]
    return bytes(data)


def unpacked(content: bytes, reader: McapReader) -> bytes:
    """Return a recording whose chunks are not compressed and have no checksum: easier to change."""
    parts, end = [], 0
    for chunk in reader.chunks:
        head = chunk.extent.at - 9
        parts.append(content[end:head])
        plain = reader._content(chunk)
        fields = CHUNK_HEAD.pack(chunk.first_ns, chunk.last_ns, len(plain), 0)
        body = fields + text("") + len(plain).to_bytes(8, "little") + plain
        parts.append(record(Op.CHUNK, body))
        end = chunk.extent.at + chunk.extent.size
    return b"".join([*parts, content[end:]])


def use(path: Path, target: Path) -> str:
    """Perform all operations that do not run programs; return the messages."""
    try:
        recording = Recording(path)
    except CrsError as error:
        return str(error)
    try:
        list(summary(recording))
        list(state_at(recording, 1.0))
        for _, _, rows in tables(recording):
            for _ in rows:
                pass
        recording.sources()
    except CrsError as error:
        return str(error)
    finally:
        recover(recording, target)
        recording.close()
    return ""


def killed(recorded: Path, folder: Path, monkeypatch: pytest.MonkeyPatch) -> bytes:
    """Return the recording of the same run as it is when that is killed in its sixth second."""
    recording, path, kept = Recording(recorded), folder / "killed.mcap", list[bytes]()
    recording.write_sources(folder)
    recording.close()
    save = McapWriter.save

    def noted(writer: McapWriter, first_ns: int, last_ns: int, parts: Iterable[Part]) -> None:
        save(writer, first_ns, last_ns, parts)
        kept.append(path.read_bytes())

    with monkeypatch.context() as patch:
        patch.setattr(McapWriter, "save", noted)
        patch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b"go\n")))
        files = [str(folder / name) for name in ("drive.c", "room.xml")]
        main(["run", *files, "--record", str(path), "--quiet", "--max-time", "5.5"])
    return kept[-1]


def test_mutated_recordings_give_one_error_or_a_result(
    recorded: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = recorded.read_bytes()
    reader = McapReader(recorded)
    kinds = whole, unpacked(whole, reader), killed(recorded, tmp_path, monkeypatch)
    reader.close()
    random = np.random.default_rng(16)
    path, said = tmp_path / "mutated.mcap", set()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    longest_s = 0.0
    for number in range(COUNT):
        path.write_bytes(mutated(kinds[number % len(kinds)], random))
        start = time.process_time()
        said.add(use(path, tmp_path / "mended.mcap")[-60:])
        longest_s = max(longest_s, time.process_time() - start)
    assert len(said) > min(COUNT, 60) / 10  # errors of many kinds
    assert longest_s < 5.0
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 300_000


def test_a_decompression_bomb_is_not_unpacked(recorded: Path, tmp_path: Path) -> None:
    bomb = zstandard.ZstdCompressor(level=19).compress(bytes(2**28))
    path = tmp_path / "bomb.mcap"
    whole = recorded.read_bytes()
    reader = McapReader(recorded)
    head = whole[: reader.chunks[0].extent.at - 9]
    reader.close()
    assert head.startswith(MAGIC)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for size in (1000, 2**28, 2**63):
        fields = CHUNK_HEAD.pack(0, 0, size, 0)
        body = fields + text("zstd") + len(bomb).to_bytes(8, "little") + bomb
        path.write_bytes(head + record(Op.CHUNK, body))
        assert "the chunk at byte" in use(path, tmp_path / "mended.mcap")
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 150_000
