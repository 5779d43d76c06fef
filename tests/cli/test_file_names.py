"""File names that cannot be decoded by the locale, or as UTF-8, work as any other."""

from __future__ import annotations

import json
import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

C_LOCALE = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
COPY = r"""
#include <stdio.h>
#include "größe.h"
int main(int argc, char *argv[])
{
    FILE *from = fopen("k\303\244rte", "r"), *to = fopen("sp\303\274r/\377", "w");
    if (from == NULL || to == NULL)
        return 9;
    putc(getc(from), to);
    fputs("f\303\244hrt\n", stderr);
    puts(argc > 1 ? argv[1] : "none");
    return SIZE;
}
"""
WORLD = """<world version="1"><area length="9m" width="9m"/>
<robot x="1m" y="2m" program="köpie.c" definition="röver.xml"/></world>"""
COMMANDS = "break köpie.c:8\nrun\nsave breakpoints hält.dbg\nsource hält.dbg\n"


@pytest.fixture(autouse=True)
def c_locale(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in C_LOCALE.items():
        monkeypatch.setenv(name, value)
    monkeypatch.chdir(tmp_path)


def crs(line: str) -> tuple[int, str, str]:
    """Run crs in the locale of the environment; return exit status, stdout and stderr."""
    command = [sys.executable, "-m", "crs_cc", *shlex.split(line)]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, check=False)
    return done.returncode, os.fsdecode(done.stdout), os.fsdecode(done.stderr)


def write_files() -> None:
    Path("köpie.c").write_text(COPY, encoding="utf-8")
    Path("größe.h").write_text("#define SIZE 7\n")
    Path("kärte.txt").write_text("x")
    Path("kommändos").write_text(COMMANDS, encoding="utf-8")
    Path("wörld.xml").write_text(WORLD, encoding="utf-8")


def test_no_name_on_the_command_line_is_an_internal_error() -> None:
    write_files()
    files = "--file kärte=kärte.txt --files öut"
    status, out, err = crs(f"run köpie.c {files} --plot plöt.svg -- ärg")
    assert (status, out, err) == (7, "ärg\n", "fährt\n")
    assert [path.name for path in Path("öut/spür").iterdir()] == [os.fsdecode(b"\xff")]
    assert "köpie.c in an empty world" in Path("plöt.svg").read_text("utf-8")
    assert crs("check köpie.c größe.h")[0] == 0
    assert crs("compile --emit wat köpie.c")[0] == 0
    assert "köpie.c:" in crs("compile köpie.c")[1]


def test_no_name_in_a_world_or_a_script_is_an_internal_error() -> None:
    write_files()
    assert crs("new robot rover")[0] == 0
    Path("rover.xml").rename("röver.xml")
    assert crs("run wörld.xml --file kärte=kärte.txt -q -- x")[0] == 7
    status, out, _ = crs("debug --batch köpie.c --file kärte=kärte.txt -x kommändos -- ärg")
    assert (status, out.count("at köpie.c:8")) == (0, 2)


def test_a_macro_on_the_command_line_is_decoded_as_in_a_file() -> None:
    Path("wide.c").write_text("int main(void) { return größe; }\n", encoding="utf-8")
    assert crs("run wide.c -D größe=5")[0] == 5


def test_messages_show_a_name_as_it_is() -> None:
    Path("fählt.c").write_bytes(b"int main(void) { return none; }\n")
    assert crs("check fählt.c")[2].startswith("fählt.c:1:25: error: ")
    assert crs("check fohlt.c")[2].endswith(
        "did you mean 'fählt.c'?\n1 file checked: 1 error, 0 warnings\n"
    )
    assert "--file 'nüll'" in crs("run fählt.c --file nüll")[2]
    assert json.loads(crs("check --json nüll.c")[1])[0]["text"] == "no such file"


def test_a_name_that_is_not_utf_8_works_as_any_other(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LC_ALL", "C.UTF-8")
    name = os.fsdecode(b"h\xff.c")
    Path(name).write_bytes(b"int main(void) { return none; }\n")
    assert crs(f"check {name}")[2].startswith(f"{name}:1:25: error: ")
    Path(name).write_bytes(b"int main(void) { return 0; }\n")
    status, out, err = crs(f"run {name} --summary --plot path.svg")
    assert (status, out) == (0, "")
    assert name in err
    assert "h\ufffd.c in an empty world" in Path("path.svg").read_text("utf-8")
