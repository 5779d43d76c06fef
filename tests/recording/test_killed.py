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
from crs_cc.recording.frame_buffer import Shape
from crs_cc.recording.recording import Recording

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
        while len(sizes) < 6:  # the start, and some seconds
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


def test_saved_readings_of_impossible_robots_are_rejected() -> None:
    block = Block(0.0, Shape(1, 0, has_turret=False))
    block.readings.single.append(
        (12).to_bytes(4, "little"), (-5).to_bytes(8, "little", signed=True), bytes(8), bytes(4 * 45)
    )
    saved = b"".join(block.take_unsaved().parts())
    with pytest.raises(ValueError, match="a reading is not valid"):
        list(saved_messages(saved))


def test_the_end_of_a_chunk_does_not_depend_on_saved_data() -> None:
    """What is printed is encoded when the chunk is; its size must not change when it is saved."""
    block = Block(0.0, Shape(1, 0, has_turret=False))
    for content in (b"\xff" * 1000, b'"\n' * 100, b"plain"):
        block.add_output(5, 0, 1, content)
    before = block.size
    saved = b"".join(block.take_unsaved().parts())
    assert [channel for channel, _, _ in saved_messages(saved)] == [topics.OUTPUT]
    assert block.size == before
    assert not list(saved_messages(b"".join(block.take_unsaved().parts())))
