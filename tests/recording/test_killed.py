"""A recorded run that is killed, and what is made of its file."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.recording import topics
from crs_cc.recording.block import Block, saved_messages
from crs_cc.recording.gathered import Shape
from crs_cc.recording.recording import Recording
from crs_cc.session.session import Session

PROGRAM = """\
#include <Nclient.h>
#include <stdio.h>

int main(void)
{
    int n;
    connect_robot(1);
    for (n = 0;; n++) {
        vm(50, n % 100 - 50, 0);
        gs();
        ws(1, 1, 1, 1);
        printf("%d\\n", n);
    }
}
"""


def test_a_run_that_is_killed_is_recovered(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    program, path, mended = (tmp_path / name for name in ("drive.c", "run.mcap", "mended.mcap"))
    program.write_text(PROGRAM)
    command = [sys.executable, "-m", "crs_cc", "run", str(program), "--record", str(path)]
    command += ["--quiet", "--max-time", "3600"]
    run = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    end_s, sizes = time.monotonic() + 120.0, set[int]()
    try:
        while len(sizes) < 4:  # the start, and what was saved twice
            assert run.poll() is None, run.stderr and run.stderr.read()
            assert time.monotonic() < end_s
            time.sleep(0.05)
            sizes.add(path.stat().st_size if path.exists() else 0)
    finally:
        run.send_signal(signal.SIGKILL)
        run.communicate()
    assert run.returncode == -signal.SIGKILL
    assert main(["replay", str(path), "--recover", str(mended)]) == 0
    recording = Recording(mended)
    times_s = [frame.time_s for frame in recording.frames()]
    said = [entry["text"] for _, entry in recording.data(topics.OUTPUT.topic)]
    recording.close()
    assert times_s[0] == 0.0
    assert times_s[-1] >= 1.0
    assert said[1:] == [f"{n}\n" for n in range(len(said) - 1)]  # after the library's banner
    assert len(said) > 1
    capfd.readouterr()
    assert main(["replay", str(mended), "--verify"]) == 0
    assert "the same run" in capfd.readouterr().out


ASKING = """\
#include <Nclient.h>
#include <stdio.h>

int main(void)
{
    char line[9];
    int n;
    connect_robot(1);
    vm(50, 50, 0);
    for (n = 0; n < 9; n++) {
        gs();
        ws(1, 1, 1, 1);
        printf("%d\\n", n);
    }
    printf("ready\\n");
    fflush(stdout);
    return !fgets(line, sizeof line, stdin);
}
"""


def test_a_run_is_saved_before_it_waits_for_input(tmp_path: Path) -> None:
    """Its seconds pass faster than they are saved else."""
    program, path = tmp_path / "ask.c", tmp_path / "run.mcap"
    program.write_text(ASKING)
    command = [sys.executable, "-m", "crs_cc", "run", str(program), "--record", str(path)]
    run = subprocess.Popen([*command, "--quiet"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    assert run.stdout is not None
    try:
        while run.stdout.readline() != b"ready\n":
            assert run.poll() is None
        end_s = time.monotonic() + 60.0
        while not (said := _said(path)) or said[-1] != "ready\n":
            assert time.monotonic() < end_s, said
            time.sleep(0.01)
    finally:
        run.send_signal(signal.SIGKILL)
        run.communicate()
    assert said[-3:] == ["7\n", "8\n", "ready\n"]


def test_a_run_that_fails_is_saved(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    program, path, advance = tmp_path / "drive.c", tmp_path / "run.mcap", Session.advance
    program.write_text(PROGRAM)

    def fails(session: Session, most: int, *, calmly: bool = False) -> bool:
        if session.time_s >= 5.0:
            raise MemoryError
        return advance(session, most, calmly=calmly)

    monkeypatch.setattr(Session, "advance", fails)
    assert main(["run", str(program), "--record", str(path), "--quiet"]) != 0
    recording = Recording(path)
    assert recording.end_ns == 5 * 10**9
    recording.close()


def _said(path: Path) -> list[str]:
    """Return what programs have printed, according to a recording that is being written."""
    recording = Recording(path)
    said = [entry["text"] for _, entry in recording.data(topics.OUTPUT.topic)]
    recording.close()
    return said


def test_saved_readings_of_impossible_robots_are_refused() -> None:
    block = Block(0.0, Shape(1, 0, has_turret=False))
    block.readings.single.append(
        (12).to_bytes(4, "little"), (-5).to_bytes(8, "little", signed=True), bytes(8), bytes(4 * 45)
    )
    saved = b"".join(block.unsaved().parts())
    with pytest.raises(ValueError, match="a reading is not valid"):
        list(saved_messages(saved))


def test_where_a_chunk_ends_does_not_depend_on_what_was_saved() -> None:
    """What is printed is encoded when the chunk is; its size must not change when it is saved."""
    block = Block(0.0, Shape(1, 0, has_turret=False))
    for content in (b"\xff" * 1000, b'"\n' * 100, b"plain"):
        block.add_output(5, 0, 1, content)
    before = block.size
    saved = b"".join(block.unsaved().parts())
    assert [channel for channel, _, _ in saved_messages(saved)] == [topics.OUTPUT]
    assert block.size == before
    assert not list(saved_messages(b"".join(block.unsaved().parts())))
