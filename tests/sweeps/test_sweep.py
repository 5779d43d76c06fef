"""Sweeps: what is varied, what fails, and the same table however it comes to be."""

from __future__ import annotations

import contextlib
import errno
import json
import os
import random
import signal
import subprocess
import sys
import time
import weakref
from pathlib import Path
from typing import Any

import pytest

import crs_cc
from crs_cc.cli.main import main
from crs_cc.jobs.pool import Worker
from crs_cc.recording.recording import Recording
from crs_cc.runtime.fleet import Fleet
from crs_cc.sweeps import single_run
from crs_cc.sweeps import sweep as sweep_module
from crs_cc.sweeps.experiment import ExperimentError
from crs_cc.sweeps.rows import RowFile
from crs_cc.sweeps.sweep import Sweep
from tests.sweeps.trials import EXPERIMENT, MANY, PROGRAM, swept, write


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return tmp_path / "trial"


def rows_of(sweep: Sweep) -> list[dict[str, Any]]:
    return [sweep.rows[number] for number in sorted(sweep.rows)]


def test_every_kind_of_parameter_changes_what_it_names(folder: Path) -> None:
    path = write(
        folder,
        """
[parameters]
define.SPEED = [50, 100]
robots = [1, 2]
world.crate.x = ["3m", "1.6m"]
""",
    )
    rows = rows_of(swept(path, folder / "out"))
    assert len(rows) == 2 * 2 * 2 * 3
    assert [row["seed"] for row in rows[:4]] == [1, 2, 3, 1]
    world = crs_cc.load_world(folder / "hall.xml")
    for row in rows[::5]:
        builder = crs_cc.WorldBuilder(folder / "hall.xml")
        builder.set("crate", x=row["parameters"]["world.crate.x"])
        if row["parameters"]["robots"] == 1:
            builder.remove("b")
        defines = [f"SPEED={row['parameters']['define.SPEED']}"]
        program = crs_cc.compile_c(folder / "drive.c", defines=defines)
        session = crs_cc.Session(builder.world(), program, seed=row["seed"])
        assert session.run().state_hash == row["state_hash"]
    assert world.duration_s == rows[0]["simulated_s"] == 1.0


USUAL = {
    "setup": "",
    "fault": "",
    "argument.1": 1,
    "robot.drive.wheel-base": "30cm",
    "link": "serial",
}


def test_what_is_scattered_has_other_places_with_each_seed(folder: Path) -> None:
    path = write(folder, "[parameters]\nworld.crowd.count = [1, 2]\n")
    hall = (folder / "hall.xml").read_text()
    crowd = '<scatter id="crowd" robot="scout" count="1"/></world>'
    (folder / "hall.xml").write_text(hall.replace("</world>", crowd))
    rows = rows_of(swept(path, folder / "out"))
    assert [row["status"] for row in rows] == ["ended"] * 6
    program = crs_cc.compile_c(folder / "drive.c")
    for row in rows[:3]:
        world = crs_cc.load_world(folder / "hall.xml", seed=row["seed"])
        session = crs_cc.Session(world, program, seed=row["seed"])
        assert session.run().state_hash == row["state_hash"]
    assert len({crs_cc.load_world(folder / "hall.xml", seed=seed).robots for seed in (1, 2)}) == 2


def cases(*others: dict[str, object]) -> str:
    """Return combinations, each by what is not as usual."""
    return "\n".join(
        "[[cases]]\n"
        + "".join(f"{name} = {json.dumps(value)}\n" for name, value in {**USUAL, **other}.items())
        for other in others
    )


def test_faults_arguments_and_definitions_can_be_varied(folder: Path) -> None:
    changed = cases(
        {},
        {"setup": "noisy"},
        {"fault": "robot=a device=drive dead=yes; robot=b device=sonar dead=yes"},
        {"argument.1": 2, "robot.drive.wheel-base": "40cm"},
        {"link": "ideal"},
    )
    path = write(folder, f"until_decided = true\n{changed}", EXPERIMENT.replace("3", "1"))
    rows = rows_of(swept(path, folder / "out"))
    assert [row["status"] for row in rows] == ["ended"] * 5
    assert len({row["state_hash"] for row in rows}) == 5
    assert rows[2]["measures"]["distance_m"] < rows[0]["measures"]["distance_m"]


WRONG = {
    'world = "hall.xml"\nseed = 3': "unknown key 'seed'\n    hint: did you mean 'seeds'?",
    "seeds = 3": "'world' is missing: name a world file",
    'world = "hall.xml"\nseeds = [1, 1]': "'seeds' must have at least one seed, without duplicates",
    'world = "hall.xml"\nseeds = 0': "'seeds' must be a whole number from 1 to 1000000, not 0",
    'world = "hall.xml"\nduration = "3 kg"': "'3 kg' is not a time",
    'world = "hall.xml"\n[parameters]\nspeed = [1]': "unknown parameter 'speed' (known: define.",
    'world = "hall.xml"\n[parameters]\nrobots = 3': "'parameters.robots' must be a list, not 3",
    'world = "hall.xml"\n[parameters]\nrobots = [nan]': "'parameters.robots': invalid value nan",
    'world = "hall.xml"\n[parameters]\nrobots = { low = 1, high = 4 }': "it requires 'samples'",
    'world = "hall.xml"\n[limits]\nfuel = "much"': "'limits.fuel' must be a whole number",
    'world = "hall.xml"\n[search]\nmethod = "tpe"': "'search.measure' is missing",
    'world = "hall.xml': "trial.toml: error: Unterminated string",
}


@pytest.mark.parametrize("text", WRONG)
def test_an_invalid_experiment_is_one_clear_error(text: str, folder: Path) -> None:
    path = write(folder, experiment=text)
    with pytest.raises(ExperimentError) as wrong:
        Sweep(path, folder / "out")
    assert WRONG[text] in str(wrong.value)
    assert str(wrong.value).startswith(f"{path}: error: ")


def test_all_errors_are_reported_before_the_first_run(folder: Path) -> None:
    path = write(
        folder,
        """
[parameters]
define.SPEED = ["100", "1 +"]
world.crate.x = ["3m", "-3 kg"]
robots = [2, 3]
""",
    )
    with pytest.raises(ExperimentError) as wrong:
        swept(path, folder / "out")
    messages = [each.text for each in wrong.value.diagnostics]
    assert len(messages) == 3
    assert messages[0].startswith("define.SPEED=100, world.crate.x=3m, robots=3: robots = 3")
    assert messages[1].startswith("define.SPEED=100, world.crate.x=-3 kg, robots=2: hall.xml:2")
    assert messages[2].startswith("define.SPEED=1 +, world.crate.x=3m, robots=2: drive.c:11")
    assert not (folder / "out").exists()


@pytest.mark.parametrize(
    ("more", "text"),
    [
        ("[parameters]\ndefine.SPED = [1]", "define.SPED: no C file uses the macro 'SPED'"),
        ("[parameters]\nworld.crat.x = [1]", "world.crat.x: unknown element 'crat'"),
        ("[parameters]\nworld.crate.z = [1]", "world.crate.z: unknown attribute 'z'"),
        ('[parameters]\nrobot = ["scot"]', "unknown robot 'scot'"),
        ('[parameters]\nsetup = ["x"]', "unknown setup 'x'"),
        ('[parameters]\nrobot.drive.wheel-base = ["30cm", "-1cm"]', "wheel-base: '-1cm'"),
        ("[parameters]\nargument.2 = [1]", "there is no argument 1 before it"),
        ('[parameters]\nfault = ["dead"]', "fault: 'dead' is not NAME=VALUE"),
        ('measures = "m.py"', "m.py: No such file or directory"),
        ('files = { a = "none.txt" }', "none.txt"),
    ],
)
def test_unknown_names_are_reported_before_the_first_run(
    more: str, text: str, folder: Path
) -> None:
    path = write(folder, more)
    with pytest.raises(ExperimentError) as wrong:
        swept(path, folder / "out")
    assert text in str(wrong.value)
    assert not (folder / "out").exists()


def test_a_run_that_fails_is_a_row_and_a_recording_for_the_debugger(
    folder: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    path = write(folder, "[parameters]\nargument.1 = [1, 7]\n")
    sweep = swept(path, folder / "out")
    rows = rows_of(sweep)
    assert [row["status"] for row in rows] == ["ended"] * 3 + ["run-time error"] * 3
    assert rows[3]["error"].startswith("a: drive.c:15: ")
    assert "recording" not in rows[0]
    recording = folder / "out" / rows[3]["recording"]
    assert recording.name == "0003.mcap"
    assert Recording(recording).result is not None
    (folder / "commands").write_text("continue\nbacktrace\n")
    assert main(["debug", str(recording), "--batch", "-x", str(folder / "commands")]) == 0
    assert "drive.c:15" in capfd.readouterr().out


def test_a_recording_that_does_not_fit_the_disk_is_reported_and_retried(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, out = write(folder, MANY), folder / "out"
    record = single_run.record

    def full(experiment: Any, variant: Any, seed: int, path: Path) -> Any:
        if seed == 2:
            path.write_bytes(b"as much as there was room for")
            raise OSError(errno.ENOSPC, "No space left on device")
        return record(experiment, variant, seed, path)

    with monkeypatch.context() as patched:
        patched.setattr(single_run, "record", full)
        sweep = swept(path, out)
    assert sweep.unrecorded == dict.fromkeys((4, 10), "No space left on device")
    assert "recording" not in sweep.rows[4]
    assert sorted(each.name for each in (out / "failed").iterdir()) == [
        f"{number:04d}.mcap" for number in (3, 5, 9, 11)
    ]
    assert swept(path, out, resume=True).rows[4]["recording"] == "failed/0004.mcap"


LIMITS = "[limits]\noutput = 1000\nfuel = 1_000_000\n"


def test_runs_and_recordings_free_their_programs_when_they_end(
    folder: Path, fleets: list[weakref.ref[Fleet]]
) -> None:
    path = write(folder, "[parameters]\nargument.1 = [7]\n", EXPERIMENT.replace("3", "1"))
    (row,) = rows_of(swept(path, folder / "out"))
    assert row["recording"]
    assert [each() for each in fleets] == [None, None]


def test_limits_end_a_run_and_are_its_status(folder: Path) -> None:
    path = write(folder, LIMITS, EXPERIMENT.replace("3", "1"))
    (folder / "drive.c").write_text(
        "#include <stdio.h>\n#include <Nclient.h>\nint main(int argc, char **argv)\n"
        "{\n    connect_robot(1);\n    for (;;)\n        ENDLESS;\n}\n"
    )
    with path.open("a") as file:
        file.write("[parameters]\ndefine.ENDLESS = ['printf(\"%99d\", 0), gs()', ';', 'gs()']\n")
    rows = rows_of(swept(path, folder / "out"))
    assert [row["status"] for row in rows] == ["limit", "limit", "ended"]
    assert rows[0]["error"] == "printed more than 1,000 bytes"
    assert rows[1]["error"] == "computed more than 1,000,000 instructions"


@pytest.mark.skipif(sys.platform != "linux", reason="memory is limited on Linux only")
def test_a_run_that_raises_leaves_no_limit_of_memory_behind(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    import resource

    def failing(*_: object) -> None:
        assert resource.getrlimit(resource.RLIMIT_DATA) != before
        raise OSError(errno.ENOSPC, "no space", "run.mcap")

    before = resource.getrlimit(resource.RLIMIT_DATA)
    monkeypatch.setattr("crs_cc.sweeps.single_run.run", failing)
    (row, *_) = rows_of(swept(write(folder), folder / "out"))
    assert row["error"] == "run.mcap: no space"
    assert resource.getrlimit(resource.RLIMIT_DATA) == before


def test_measures_are_functions_of_a_session_or_a_recording(folder: Path) -> None:
    path = write(folder, 'measures = "measures.py"\n')
    (folder / "measures.py").write_text(
        "import numpy as np\n"
        "def west_m(session):\n"
        "    return session.poses[:, 0].min()\n"
        "def frames(recording):\n"
        "    return sum(1 for _ in recording.frames())\n"
        "def odd(session):\n"
        "    print('not on our channel')\n"
        "    return 1 / (session.seed - 2)\n"
    )
    rows = rows_of(swept(path, folder / "out"))
    assert [row["status"] for row in rows] == ["ended", "measure error", "ended"]
    assert rows[1]["error"] == "odd: line 8: ZeroDivisionError('division by zero')"
    assert rows[0]["measures"]["odd"] == -1.0
    assert 1.0 < rows[0]["measures"]["west_m"] < 1.5
    assert rows[0]["measures"]["frames"] == 21
    assert not list((folder / "out").glob("*.part"))


@pytest.mark.skipif(not hasattr(os, "fork"), reason="one run a process elsewhere")
def test_what_measures_keep_and_change_reaches_no_other_run(folder: Path) -> None:
    plain = rows_of(swept(write(folder), folder / "plain"))
    path = write(folder, 'measures = "measures.py"\n')
    (folder / "measures.py").write_text(
        "import os, signal\n"
        "seen = []\n"
        "def kept(session):\n"
        "    seen.append(session)\n"
        "    return len(seen)\n"
        "def process(session):\n"
        "    return os.getppid()\n"
        "def ran_on(session):\n"
        "    session.run(1.5)\n"
        "    return session.time_s\n"
    )
    sweep = Sweep(path, folder / "out")
    sweep.run(1)
    rows = rows_of(sweep)
    assert [row["error"] for row in rows] == ["", "", ""]
    assert [row["measures"]["kept"] for row in rows] == [1, 1, 1]
    assert len({row["measures"]["process"] for row in rows}) == 1
    assert [row["state_hash"] for row in rows] == [row["state_hash"] for row in plain]


TROUBLE = """import os, signal, time
def odd(session):
    if session.seed == 2:
        time.sleep(600)
    if session.seed == 3:
        os._exit(3)
    if session.seed == 4:
        os.kill(os.getpid(), signal.SIGABRT)
    if session.seed == 5:
        bytearray(2**32)
    if session.seed == 6:
        raise SystemExit
    return session.seed
"""


@pytest.mark.skipif(sys.platform != "linux", reason="memory is limited on Linux only")
def test_what_a_measure_does_to_its_process_costs_its_own_row_only(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sweep_module, "_TOGETHER_S", 1.0)
    plain = rows_of(swept(write(folder, "", EXPERIMENT.replace("3", "8")), folder / "plain"))
    more = 'measures = "measures.py"\n[limits]\nwall_s = 6\nmemory_mib = 1000\n'
    path = write(folder, more, EXPERIMENT.replace("3", "8"))
    (folder / "measures.py").write_text(TROUBLE)
    sweep = Sweep(path, folder / "out")
    sweep.run(1)
    rows = rows_of(sweep)
    ends = ["ended", "time out", *["crashed"] * 2, "measure error", "crashed", *["ended"] * 2]
    assert [row["status"] for row in rows] == ends
    assert "by signal 6" in rows[3]["error"]
    assert rows[4]["error"] == "odd: line 10: MemoryError()"
    assert [row["measures"]["odd"] for row in (rows[0], *rows[6:])] == [1, 7, 8]
    assert [row["state_hash"] for row in (rows[0], *rows[6:])] == [
        row["state_hash"] for row in (plain[0], *plain[6:])
    ]


def test_recordings_of_measures_that_were_killed_are_removed(folder: Path) -> None:
    path, out = write(folder), folder / "out"
    swept(path, out)
    (out / "run-2.mcap.part").write_bytes(b"half of it")
    swept(path, out, resume=True)
    assert not list(out.glob("*.part"))


# -- the same table however it comes to be -------------------------------------------------------


@pytest.fixture(scope="module")
def expected(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """The table of a sweep that nothing disturbs."""
    folder = tmp_path_factory.mktemp("expected")
    swept(write(folder, MANY), folder / "out")
    return (folder / "out" / "runs.csv").read_bytes()


def test_a_full_disk_costs_no_row(
    folder: Path, expected: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write(folder, MANY)
    add = RowFile.add

    def full(rows: RowFile, row: dict[str, Any]) -> None:
        if len(rows.rows) == 5:
            os.write(rows._descriptor, b'{"run": 5, "par')  # as much as there was room for
            raise OSError(errno.ENOSPC, "No space left on device", "rows.jsonl")
        add(rows, row)

    with monkeypatch.context() as patched:
        patched.setattr(RowFile, "add", full)
        with pytest.raises(OSError, match="No space"):
            swept(path, folder / "out")
    assert len((folder / "out" / "runs.csv").read_text().splitlines()) == 1 + 5
    with pytest.raises(ExperimentError, match="already has the results"):
        swept(path, folder / "out")
    assert len(swept(path, folder / "out", resume=True).rows) == 12
    assert (folder / "out" / "runs.csv").read_bytes() == expected


def test_a_sweep_goes_on_only_with_what_it_began_with(folder: Path) -> None:
    path = write(folder)
    swept(path, folder / "out")
    (folder / "drive.c").write_text(PROGRAM + "\n")
    with pytest.raises(ExperimentError, match=r"has changed since it began: drive.c"):
        swept(path, folder / "out", resume=True)


def test_a_killed_sweep_goes_on_to_the_same_table(folder: Path, expected: bytes) -> None:
    path, out = write(folder, MANY), folder / "out"
    command = [sys.executable, "-m", "crs_cc", "sweep", str(path), "--out", str(out), "--jobs", "1"]
    process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
    try:
        deadline = time.monotonic() + 60.0
        while not (out / "rows.jsonl").exists() or not (out / "rows.jsonl").stat().st_size:
            assert time.monotonic() < deadline
            time.sleep(0.005)
    finally:
        process.kill()
        process.wait()
    before = (out / "rows.jsonl").read_bytes()
    (out / "rows.jsonl").write_bytes(before[:-20] + before[-20:-3])  # the last line is cut off
    assert main(["sweep", str(path), "--out", str(out), "--jobs", "2", "--resume", "-q"]) == 1
    assert (out / "runs.csv").read_bytes() == expected


@pytest.mark.usefixtures("users_workers")
@pytest.mark.skipif(not Path("/proc/self").exists(), reason="needs /proc to find the processes")
def test_workers_killed_at_random_cost_no_row(
    folder: Path, expected: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, out = write(folder, MANY), folder / "out"
    started: list[int] = []
    start = Worker._start

    def noting(worker: Worker) -> object:
        process = start(worker)
        started.append(process.pid)
        return process

    monkeypatch.setattr(Worker, "_start", noting)
    sweep, chance, killed = Sweep(path, out), random.Random(1), []

    def kill(_progress: object) -> None:
        if chance.random() < 0.4 and len(killed) < 2:
            with contextlib.suppress(ProcessLookupError):  # it has not been started anew yet
                os.kill(started[-1], signal.SIGKILL)
                killed.append(started[-1])

    sweep.run(1, report=kill)
    assert len(killed) == 2
    assert len((out / "rows.jsonl").read_text().splitlines()) == 12
    assert (out / "runs.csv").read_bytes() == expected
