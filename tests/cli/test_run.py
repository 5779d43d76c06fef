"""`crs run` from end to end: output, exit status, several robots, interruption, results as data."""

from __future__ import annotations

import io
import json
import os
import pty
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from lxml import etree

import crs_cc.sim
from crs_cc.cli.main import main
from crs_cc.cli.messages import left_out_text
from tests.commands import crs
from tests.processes import wait_until_it_waits

PAIR = """<world version="1" name="pair"><area length="6m" width="4m"/>
<robot id="left" x="1m" y="2m"/><robot id="right" x="5m" y="2m" heading="180deg"/></world>"""
HELLO = '#include <stdio.h>\nint main(void) { printf("hello\\n"); return 7; }\n'
LOOP = "int main(void) { for (;;) ; }\n"
NULL = "int main(void)\n{\n    int *p = 0;\n    return *p;\n}\n"
DRIVE = """#include <stdio.h>
#include "Nclient.h"
int main(int argc, char **argv)
{
    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    pr(50, 50, 0);
    ws(1, 1, 0, 20);
    printf("%s there at %ld\\n", argv[argc - 1], State[STATE_CONF_X]);
    return 0;
}
"""
TALK = """#include <stdio.h>
int main(void) { for (;;) { puts("on"); fflush(stdout); } }
"""
NAME_ONLY = re.compile(r"Nclient version.*\nCopyright.*\n")


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("pair.xml").write_text(PAIR)
    for name, text in (("hello", HELLO), ("loop", LOOP), ("null", NULL), ("drive", DRIVE)):
        Path(f"{name}.c").write_text(text)


def start(*arguments: str, **options: object) -> subprocess.Popen[str]:
    pipes = dict.fromkeys(("stdout", "stderr"), subprocess.PIPE) | options
    return subprocess.Popen(crs(*arguments), text=True, **pipes)  # type: ignore[call-overload]


# -- output and exit status ------------------------------------------------------------------------


def test_one_robots_output_and_exit_status_are_passed_through(
    capfd: pytest.CaptureFixture[str],
) -> None:
    assert main(["run", "hello.c"]) == 7
    assert capfd.readouterr() == ("hello\n", "")


def test_each_line_of_several_robots_names_its_robot(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "hello.c", "pair.xml"]) == 1  # both ended, but not with 0
    assert capfd.readouterr() == ("[left] hello\n[right] hello\n", "")


def test_streams_are_separate_and_bytes_unchanged(
    capfdbinary: pytest.CaptureFixture[bytes],
) -> None:
    Path("bytes.c").write_text(
        "#include <stdio.h>\nint main(void)\n{ int c; for (c = 0; c < 256; c++) putchar(c);\n"
        'fputs("to stderr", stderr); return 0; }\n'
    )
    assert main(["run", "bytes.c"]) == 0
    assert capfdbinary.readouterr() == (bytes(range(256)), b"to stderr")


def test_a_program_that_still_runs_at_max_time_counts_as_0(
    capfd: pytest.CaptureFixture[str],
) -> None:
    assert main(["run", "loop.c", "--max-time", "0.5", "--json"]) == 0
    data = json.loads(capfd.readouterr().out)
    assert data["robots"][0]["outcome"] == "running"
    assert data["simulated_s"] == pytest.approx(0.5)
    place = data["robots"][0]["stands_in"]
    assert (place["function"], place["file"], place["line"]) == ("main", "loop.c", 1)


def test_the_command_line_overrides_seed_and_duration_of_the_world(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("short.xml").write_text(PAIR.replace("<world", '<world seed="5" duration="400ms"'))
    assert main(["run", "loop.c", "short.xml", "--json"]) == 0
    data = json.loads(capfd.readouterr().out)
    assert (data["seed"], data["simulated_s"]) == (5, pytest.approx(0.4))
    options = ["--seed", "0", "--max-time", "0.2", "--json"]
    assert main(["run", "loop.c", "short.xml", *options]) == 0
    data = json.loads(capfd.readouterr().out)
    assert (data["seed"], data["simulated_s"]) == (0, pytest.approx(0.2))


def test_an_error_of_the_program_shows_its_line(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "null.c"]) == 123
    shown = capfd.readouterr().err
    assert re.match(r"null\.c:4:\d+: error: null pointer.*\n        return \*p;\n +\^~\n", shown)


def test_errors_of_several_robots_name_them(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "null.c", "pair.xml"]) == 1
    shown = capfd.readouterr().err
    assert re.findall(r"error: \[(\w+)\] null pointer", shown) == ["left", "right"]


@pytest.mark.parametrize("flag", [[], ["--json"]])
def test_an_error_in_the_source_exits_with_121(
    flag: list[str], capfd: pytest.CaptureFixture[str]
) -> None:
    Path("bad.c").write_text("int main(void)\n{\n    return sped;\n}\n")
    assert main(["run", "bad.c", *flag]) == 121
    shown = capfd.readouterr()
    assert shown.err.startswith("bad.c:3:12: error: ")
    assert "    return sped;\n               ^\n" in shown.err
    if flag:
        data = json.loads(shown.out)
        assert data["exit_status"] == 121
        assert data["diagnostics"][0]["line"] == 3


def test_an_error_in_the_world_exits_with_122(capfd: pytest.CaptureFixture[str]) -> None:
    Path("pair.xml").write_text(PAIR.replace('id="right"', 'id="left"'))
    assert main(["run", "hello.c", "pair.xml"]) == 122
    assert re.match(r"pair\.xml:2.*error: ", capfd.readouterr().err)


@pytest.mark.parametrize(
    "content", [b"", b"\x00\xff\x7fELF" * 999, b'int main(void) { return "\xfe; }']
)
def test_binary_junk_is_rejected(content: bytes, capfd: pytest.CaptureFixture[str]) -> None:
    Path("junk.c").write_bytes(content)
    Path("junk.xml").write_bytes(content)
    assert main(["run", "junk.c"]) == 121
    assert "error: " in capfd.readouterr().err
    assert main(["run", "hello.c", "junk.xml"]) == 122
    shown = capfd.readouterr().err
    assert shown.startswith("junk.xml")
    assert "Traceback" not in shown


def test_warnings_are_shown_unless_quiet(capfd: pytest.CaptureFixture[str]) -> None:
    Path("old.c").write_text("main()\n{\n    return 0;\n}\n")
    assert main(["run", "old.c"]) == 0
    assert "old.c:1:1: warning: " in capfd.readouterr().err
    assert main(["run", "-q", "old.c"]) == 0
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("command", ["run", "compile"])
def test_quiet_suppresses_warnings_beside_errors(
    command: str, capfd: pytest.CaptureFixture[str]
) -> None:
    Path("old.c").write_text("main()\n{\n    return missing;\n}\n")
    assert main([command, "old.c"]) == 121
    assert "warning: " in capfd.readouterr().err
    assert main([command, "-q", "old.c"]) == 121
    shown = capfd.readouterr().err
    assert "error: use of undeclared identifier 'missing'" in shown
    assert "warning: " not in shown


# -- programs, arguments, input --------------------------------------------------------------------


def test_arguments_after_two_dashes_are_passed_to_main(capfd: pytest.CaptureFixture[str]) -> None:
    Path("args.c").write_text(
        "#include <stdio.h>\nint main(int c, char **v)\n{ while (*++v) puts(*v); return c; }\n"
    )
    assert main(["run", "args.c", "--", "--seed", "-1", "two words", "ü"]) == 5
    assert capfd.readouterr().out == "--seed\n-1\ntwo words\nü\n"


def test_a_program_reads_standard_input(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    Path("cat.c").write_text(
        "#include <stdio.h>\nint main(void)\n"
        "{ int c, n = 0; while ((c = getchar()) != EOF) { putchar(c); n++; } return n; }\n"
    )
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b"one\ntwo")))
    assert main(["run", "cat.c"]) == 7
    assert capfd.readouterr().out == "one\ntwo"


def test_several_files_make_one_program(capfd: pytest.CaptureFixture[str]) -> None:
    Path("half.c").write_text("int half(int n) { return n / PARTS; }\n")
    Path("main.c").write_text("int half(int);\nint main(void) { return half(84); }\n")
    assert main(["run", "main.c", "half.c", "-D", "PARTS=2"]) == 42
    assert capfd.readouterr() == ("", "")


def test_headers_are_found_in_the_given_folders(capfd: pytest.CaptureFixture[str]) -> None:
    Path("include").mkdir()
    Path("include/size.h").write_text("#define SIZE 9\n")
    Path("uses.c").write_text('#include "size.h"\nint main(void) { return SIZE; }\n')
    assert main(["run", "uses.c"]) == 121
    assert "size.h" in capfd.readouterr().err
    assert main(["run", "uses.c", "-I", "include"]) == 9


def test_robots_run_the_worlds_program_or_else_the_command_lines(
    capfd: pytest.CaptureFixture[str],
) -> None:
    world = PAIR.replace(
        '<robot id="left" x="1m" y="2m"/>',
        '<robot id="left" x="1m" y="2m" program="drive.c"/>',
    )
    Path("pair.xml").write_text(world)
    assert main(["run", "hello.c", "pair.xml", "-q"]) == 1
    out = capfd.readouterr().out
    assert out == "[right] hello\n[left] drive there at 50\n"
    assert main(["run", "pair.xml"]) == 2
    assert "no program for 'right'" in capfd.readouterr().err


def test_an_unused_program_is_warned_about(capfd: pytest.CaptureFixture[str]) -> None:
    Path("pair.xml").write_text(PAIR.replace('y="2m"', 'y="2m" program="drive.c"'))
    assert main(["run", "hello.c", "pair.xml"]) == 0
    assert "hello.c: warning: unused" in capfd.readouterr().err


# -- what is shown of a run ------------------------------------------------------------------------


LOST = """#include "Nclient.h"
static void look(void)
{
    get_sn();
}
int main(void)
{
    look();
    gs();
    connect_robot(1);
    gs();
    return 0;
}
"""


def test_a_robot_call_before_connecting_is_warned_about_once(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("lost.c").write_text(LOST)
    assert main(["run", "lost.c", "pair.xml"]) == 0
    shown = capfd.readouterr()
    assert shown.out.count("Not connected to any robot") == 4  # as the vendor's client says
    assert shown.err.endswith(
        "lost.c:4:5: warning: 'get_sn' is called without a connection to the robot "
        "[-Wunconnected]\n"
        "        get_sn();\n        ^~~~~~~~\n    hint: call connect_robot first\n"
    )
    assert shown.err.count("without a connection") == 1
    assert main(["run", "lost.c", "--quiet"]) == 0
    assert "without a connection" not in capfd.readouterr().err


def test_json_on_stdout_is_pure_and_the_programs_output_goes_to_stderr(
    capfd: pytest.CaptureFixture[str],
) -> None:
    assert main(["run", "drive.c", "pair.xml", "--json", "--seed", "3"]) == 0
    shown = capfd.readouterr()
    assert "[left] drive there at 50\n" in shown.err
    data = json.loads(shown.out)
    assert data["seed"] == 3
    left, right = data["robots"]
    assert left["pose"]["x_m"] == pytest.approx(1.127, abs=1e-3)
    assert right["pose"]["x_m"] == pytest.approx(5 - 0.127, abs=1e-3)
    assert left["odometry"]["x_m"] == pytest.approx(0.127, abs=1e-3)
    assert left["distance_m"] == pytest.approx(0.127, abs=1e-3)
    assert left["commands"] == 4  # CONNECT, CT, PR, WS
    assert left["exit_status"] == 0


def test_runs_are_reproducible_in_another_process(
    capfd: pytest.CaptureFixture[str],
) -> None:
    command = ["run", "drive.c", "pair.xml", "--json", "--seed", "3"]
    assert main(command) == 0
    texts = [capfd.readouterr().out]
    for hash_seed in ("1", "2"):
        process = start(*command, env={**os.environ, "PYTHONHASHSEED": hash_seed})
        texts.append(process.communicate(timeout=60)[0])
    results = [json.loads(text) for text in texts]
    for result in results:
        del result["timing"]
    assert results[0] == results[1] == results[2]
    assert len(results[0]["state_hash"]) == 64


@pytest.mark.parametrize("other", ["loop.c", "null.c", "deep.c", "flood.c"])
def test_a_misbehaving_program_does_not_affect_the_other_robots(
    other: str, capfd: pytest.CaptureFixture[str]
) -> None:
    Path("deep.c").write_text("int f(int n) { return f(n + 1) + n; }\nint main() { return f(0); }")
    Path("flood.c").write_text(TALK)
    left = {}
    for program in ("hello.c", other):
        world = PAIR.replace('heading="180deg"', f'heading="180deg" program="{program}"')
        Path("pair.xml").write_text(world)
        main(["run", "drive.c", "pair.xml", "--json", "--max-time", "1.2", "-q"])
        left[program] = json.loads(capfd.readouterr().out)["robots"][0]
    assert left["hello.c"]["outcome"] == "exited"
    assert left[other] == left["hello.c"]


def test_the_summary_is_shown_on_request(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "drive.c", "-q", "--summary"]) == 0
    shown = capfd.readouterr()
    assert "exit 0 at" in shown.err
    assert "0.13 0.00 m 0°" in shown.err
    assert shown.out == "drive there at 50\n"


def test_the_plot_shows_the_path(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "drive.c", "pair.xml", "--plot", "way.svg"]) == 0
    root = etree.parse("way.svg").getroot()
    assert len(root.findall(".//{*}polyline")) == 2
    assert "drive.c in pair.xml" in [row.text for row in root.iter("{*}text")]


def test_two_robots_that_touch_are_one_collision_in_the_plot() -> None:
    """They drive at each other, 2 m apart; the edge is out of reach."""
    program = "int main(void) { connect_robot(1); vm(200, 200, 0); sleep(6); return 0; }"
    Path("ram.c").write_text('#include <unistd.h>\n#include "Nclient.h"\n' + program)
    Path("two.xml").write_text(
        '<world version="1"><area length="9m" width="4m"/><robot x="3m" y="2m"/>'
        '<robot x="5m" y="2m" heading="180deg"/></world>'
    )
    assert main(["run", "ram.c", "two.xml", "--plot", "way.svg", "--quiet"]) == 0
    assert ", 1 collision<" in Path("way.svg").read_text()


def test_the_picture_of_a_program_of_several_files_names_the_first() -> None:
    Path("main.c").write_text("int answer(void);\nint main(void) { return answer(); }\n")
    Path("part.c").write_text("int answer(void) { return 0; }\n")
    assert main(["run", "main.c", "part.c", "--plot", "way.svg"]) == 0
    assert "main.c in an empty world" in Path("way.svg").read_text()


@pytest.mark.parametrize(
    ("picture", "message"),
    [
        ("nowhere/a.svg", "cannot write 'nowhere/a.svg': no such folder."),
        ("hello.c/a.svg", "'hello.c' is not a folder."),
        (".", "File '.' is a directory."),
        ("x" * 300 + ".svg", "File name too long."),
        ("x" * 300 + "/a.svg", "File name too long."),
    ],
)
def test_a_picture_that_cannot_be_written_is_rejected_before_the_run(
    picture: str, message: str, capfd: pytest.CaptureFixture[str]
) -> None:
    assert main(["run", "hello.c", "--plot", picture]) == 2
    shown = capfd.readouterr()
    assert message in shown.err
    assert shown.out == ""


def test_a_full_disk_for_the_plot_loses_no_results() -> None:
    process = start("run", "drive.c", "--plot", "/dev/full", "--json", "--summary")
    out, err = process.communicate(timeout=60)
    assert process.returncode == 1
    assert json.loads(out)["robots"][0]["outcome"] == "exited"
    assert "exit 0 at" in err
    assert err.endswith("crs: error: No space left on device: /dev/full\n")


def test_the_trace_has_a_line_for_each_robot_and_timestep(
    capfd: pytest.CaptureFixture[str],
) -> None:
    assert main(["run", "drive.c", "pair.xml", "--trace", "requests"]) == 0
    lines = NAME_ONLY.sub("", capfd.readouterr().err).splitlines()
    rows = [line.split() for line in lines if re.match(r"\d+\.\d{3} ", line)]
    assert [row[:2] for row in rows[:4]] == [
        ["0.000", "left"], ["0.000", "right"], ["0.050", "left"], ["0.050", "right"],
    ]  # fmt: skip
    slices = [row[3] for row in rows if row[1:3] == ["left", "PR"]]
    assert slices == [f"{number}/{len(slices)}" for number in range(1, len(slices) + 1)]
    assert any(each.startswith("WS(") for row in rows for each in row)


def test_the_message_trace_shows_the_life_of_each_message(
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("call.c").write_text(
        '#include "crs.h"\nint main(void) { return crs_broadcast(4, "hi", 2) - 1; }\n'
    )
    assert main(["run", "call.c", "pair.xml", "--trace", "messages", "--quiet"]) == 0
    rows = [line.split(":") for line in NAME_ONLY.sub("", capfd.readouterr().err).splitlines()]
    told = [(row[0].split()[1], row[1], row[-1].strip()) for row in rows]
    assert told[0] == ("left", " radio message 0 from left to all, type 4, 2 bytes", "sent")
    assert {row[2] for row in told} <= {"sent", "delivered", "path blocked"}


# -- from outside ----------------------------------------------------------------------------------


def wait_for(path: Path) -> None:
    deadline_s = time.monotonic() + 60
    while not path.exists() or not path.read_text():
        assert time.monotonic() < deadline_s
        time.sleep(0.02)


def test_ctrl_c_ends_a_run_with_its_results() -> None:
    Path("talk.c").write_text(TALK)
    with Path("err.txt").open("w") as err:
        process = start("run", "talk.c", "--json", stderr=err)
        wait_for(Path("err.txt"))
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=60)
    assert process.returncode == 130
    data = json.loads(out)
    assert data["interrupted"]
    assert data["robots"][0]["outcome"] == "running"
    assert "Traceback" not in Path("err.txt").read_text()


def test_ctrl_c_while_waiting_for_input_ends_the_run_too() -> None:
    Path("ask.c").write_text(
        '#include <stdio.h>\nint main(void) { fputs("name?\\n", stderr); return getchar(); }\n'
    )
    with Path("err.txt").open("w") as err:
        command = [sys.executable, "-m", "crs_cc", "run", "ask.c", "--summary"]
        process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=err
        )
        wait_for(Path("err.txt"))
        wait_until_it_waits(process.pid)
        process.send_signal(signal.SIGINT)
        process.wait(timeout=60)
        process.communicate()
    shown = Path("err.txt").read_text()
    assert process.returncode == 130
    assert "running at" in shown
    assert "Traceback" not in shown


def test_a_closed_pipe_ends_the_run_quietly() -> None:
    Path("talk.c").write_text(TALK)
    process = start("run", "talk.c")
    assert process.stdout
    assert process.stderr
    assert process.stdout.readline() == "on\n"
    process.stdout.close()
    assert process.wait(timeout=60) == 141
    assert process.stderr.read() == ""
    process.stderr.close()


@pytest.mark.parametrize(
    ("shell", "status", "shown"),
    [
        ("crs run hello.c >&-", 7, ""),
        ("crs run hello.c 2>&- >/dev/null", 7, ""),
        ("crs run hello.c <&- >/dev/null", 7, ""),
        ("crs run hello.c >/dev/full", 1, "crs: error: No space left on device\n"),
        ("crs check nothing.c 2>/dev/full", 1, ""),
    ],
)
def test_closed_and_full_streams_are_not_internal_errors(
    shell: str, status: int, shown: str
) -> None:
    command = shell.replace("crs", f"{sys.executable} -m crs_cc", 1)
    done = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (status, shown)


def test_on_a_terminal_there_are_colours_progress_and_a_summary() -> None:
    Path("slow.c").write_text("main()\n{\n    for (;;) ;\n}\n")
    screen, terminal = pty.openpty()
    environment = {**os.environ, "TERM": "xterm", "COLUMNS": "100"}
    environment.pop("NO_COLOR", None)
    process = start("run", "slow.c", "--max-time", "20", stderr=terminal, env=environment)
    os.close(terminal)
    shown = b""
    try:
        while piece := os.read(screen, 4096):
            shown += piece
    except OSError:  # how Linux says that the terminal is closed
        pass
    process.communicate()
    os.close(screen)
    assert b"\x1b[35m" in shown  # a magenta "warning"
    assert b"1 of 1 running" in shown
    assert b"running at 20.00 s" in shown
    assert process.returncode == 0


@pytest.mark.parametrize("target", ["hello.c", "pair.xml", "path.png", "path"])
def test_a_picture_never_overwrites_a_source(
    tmp_path: Path, capfd: pytest.CaptureFixture[str], target: str
) -> None:
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir() if path.is_file()}
    assert main(["run", "hello.c", "--plot", target]) == 2
    assert "is not an SVG file" in capfd.readouterr().err
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir() if path.is_file()} == before


def test_a_run_shows_a_few_warnings_and_check_shows_all(
    tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    lines = [f"void f{number}(int a) {{ a == {number}; }}" for number in range(9)]
    (tmp_path / "old.c").write_text("\n".join([*lines, "main() { return 0; }"]))
    assert main(["run", "old.c"]) == 0
    shown = capfd.readouterr().err
    assert shown.count("warning:") == 2
    assert "... and 8 more warnings; crs check shows all" in shown
    assert left_out_text(1) == "... and 1 more warning; crs check shows all"
    assert main(["check", "old.c"]) == 0
    assert "".join(capfd.readouterr()).count("warning:") == 10


# -- setup, link and client ------------------------------------------------------------------------


def test_a_program_is_faster_on_an_ideal_link(capfd: pytest.CaptureFixture[str]) -> None:
    ends_s = []
    for link in ("serial", "ideal"):
        assert main(["run", "drive.c", "--link", link, "--json"]) == 0
        ends_s.append(json.loads(capfd.readouterr().out)["robots"][0]["time_s"])
    assert ends_s[1] < ends_s[0]


@pytest.mark.parametrize("dialect", ["nomad", "report"])
def test_an_empty_file_has_no_main(dialect: str, capfd: pytest.CaptureFixture[str]) -> None:
    Path("empty.c").write_text("")
    assert main(["run", "empty.c", "--dialect", dialect]) == 121
    assert "empty.c: error: the program has no function 'main'" in capfd.readouterr().err


def test_an_unknown_robot_lists_the_known_ones(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "drive.c", "--robot", "marvin"]) == 2
    assert "scout" in capfd.readouterr().err


def test_a_robot_can_be_defined_by_the_user(capfd: pytest.CaptureFixture[str]) -> None:
    text = (Path(crs_cc.sim.__file__).parent / "files" / "robots" / "scout.xml").read_text()
    Path("slow.xml").write_text(text.replace('speed="10in/s"', 'speed="1in/s"'))
    for world, ends_s in (((), 5), (("pair.xml",), 5)):
        assert main(["run", "drive.c", *world, "--robot", "slow.xml", "--json"]) == 0
        assert json.loads(capfd.readouterr().out)["robots"][0]["time_s"] > ends_s


def test_a_missing_robot_definition_is_reported(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "drive.c", "--robot", "none.xml"]) == 122
    assert "none.xml: error: cannot be read" in capfd.readouterr().err


def test_an_unknown_setup_lists_the_known_ones(capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "drive.c", "--setup", "loud"]) == 122
    assert "ideal, noisy" in capfd.readouterr().err


@pytest.mark.parametrize("option", ["--link=radio", "--client=vendor"])
def test_an_invalid_choice_is_a_usage_error(option: str) -> None:
    assert main(["run", "drive.c", option]) == 2
