"""Snapshots in files: a session goes on from one as if it had not been away."""

from __future__ import annotations

import hashlib
import struct
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import zstandard

from crs_cc.core.errors import RecordingError
from crs_cc.core.source import Diagnostics
from crs_cc.runtime.executable import Executable
from crs_cc.session.build import build_executable
from crs_cc.session.session import Session
from crs_cc.session.snapshot_file import _HEAD, PAGE
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.model.world import WorldModel

PROGRAM = r"""
#include <Nclient.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include <crs.h>

int main(void)
{
    FILE *log = fopen("log", "w");
    char *block = malloc(100000);
    int i;

    connect_robot(1);
    for (i = 0;; i++) {
        get_sn();
        vm(100 - 10 * (i % 5), 100, 0);
        fprintf(log, "%d\n", (int)State[17]);
        fflush(log);
        block[i % 100000] = (char)i;
        usleep(150000);
    }
}
"""
WORLD = """<world version="1" timestep="50ms">
  <area length="6m" width="4m"/>
  <box id="crate" x="2m" y="1m" length="0.4m" width="0.4m" mass="5kg"/>
  {robots}
</world>
"""


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> tuple[WorldModel, Executable]:
    folder = tmp_path_factory.mktemp("saved")
    (folder / "drive.c").write_text(PROGRAM)
    places = [(1.0, 1.0), (1.0, 2.0), (1.0, 3.0)]
    robots = "".join(f'<robot x="{x}m" y="{y}m" setup="noisy"/>' for x, y in places)
    (folder / "room.xml").write_text(WORLD.format(robots=robots))
    return load_world(folder / "room.xml"), build_executable([folder / "drive.c"], Diagnostics())


@pytest.fixture(scope="module")
def saved(run: tuple[WorldModel, Executable], tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("file") / "run.snapshot"
    session = Session(run[0], [run[1]] * 3)
    for _ in range(60):
        session.step()
    session.save(path)
    return path


def test_a_session_goes_on_from_a_file(run: tuple[WorldModel, Executable], saved: Path) -> None:
    world, executable = run
    session = Session(world, [executable] * 3)
    for _ in range(60):
        session.step()
    again = Session.load(saved, world, [executable] * 3)
    assert again.state_hash() == session.state_hash()
    for _ in range(60):
        session.step()
        again.step()
    assert again.state_hash() == session.state_hash()
    assert session.environment.state.collisions.any()
    assert again.files(1) == session.files(1)


def test_equal_pages_are_stored_once(run: tuple[WorldModel, Executable], saved: Path) -> None:
    session = Session.load(saved, run[0], [run[1]] * 3)
    raw = sum(each.content.nbytes for each in session.snapshot().programs)
    assert saved.stat().st_size < raw / 5


def test_another_session_refuses_it(run: tuple[WorldModel, Executable], saved: Path) -> None:
    world, executable = run
    with pytest.raises(RecordingError, match=r"of another session \(different: seed\)"):
        Session.load(saved, world, [executable] * 3, seed=5)
    other = replace(world, name="other")
    with pytest.raises(RecordingError, match=r"of another session \(different: world\)"):
        Session.load(saved, other, [executable] * 3)


def test_a_session_with_other_robots_is_not_saved(
    run: tuple[WorldModel, Executable], tmp_path: Path
) -> None:
    session = Session(run[0], [run[1]] * 3)
    session.add_robot(replace(run[0].robots[0], id="late", join_s=9.0), run[1])
    with pytest.raises(ValueError, match="cannot be saved"):
        session.save(tmp_path / "run.snapshot")


def test_what_is_no_snapshot_is_refused(
    run: tuple[WorldModel, Executable], saved: Path, tmp_path: Path
) -> None:
    world, executables = run[0], [run[1]] * 3
    whole, path = saved.read_bytes(), tmp_path / "other.snapshot"
    magic, version, checksum, size = _HEAD.unpack_from(whole)
    bomb = zstandard.ZstdCompressor().compress(bytes(2**26))
    bombed = hashlib.sha256(bomb).digest()
    for content, reason in (
        (b"\x80\x04N.", "not written by crs"),
        (whole[:-5], "damaged"),
        (_HEAD.pack(magic, 9, checksum, size) + whole[_HEAD.size :], "its version is 9"),
        (_HEAD.pack(magic, version, checksum, 2**63) + whole[_HEAD.size :], "too large"),
        (_HEAD.pack(magic, version, bombed, 1000) + bomb, "its size differs"),
    ):
        path.write_bytes(content)
        with pytest.raises(RecordingError, match=reason):
            Session.load(path, world, executables)


def test_mutated_snapshots_are_refused_or_restored(
    run: tuple[WorldModel, Executable], saved: Path, tmp_path: Path
) -> None:
    whole = saved.read_bytes()
    content = zstandard.ZstdDecompressor().decompress(whole[_HEAD.size :])
    (pages,) = struct.unpack_from("<I", content)
    random, path, refused = np.random.default_rng(5), tmp_path / "m.snapshot", 0
    for _ in range(40):
        data = bytearray(content)
        at = int(random.integers(4 + pages * PAGE, len(data)))
        data[at : at + 4] = random.bytes(4)
        packed = zstandard.ZstdCompressor().compress(bytes(data))
        magic, version, _, _ = _HEAD.unpack_from(whole)
        head = _HEAD.pack(magic, version, hashlib.sha256(packed).digest(), len(data))
        path.write_bytes(head + packed)
        try:
            Session.load(path, run[0], [run[1]] * 3)
        except RecordingError:
            refused += 1
    assert refused > 3
