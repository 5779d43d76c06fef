"""`crs grade` grades good, wrong, endless and hostile submissions in one run."""

from __future__ import annotations

import base64
import csv
import errno
import hashlib
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from crs_cc.cli.grading.grades import Case, identical_programs
from crs_cc.cli.grading.grading import file_names
from crs_cc.cli.grading.job import GradedRun
from crs_cc.cli.grading.submissions import Submission
from crs_cc.cli.main import main
from tests.cli.grading.handed_in import WORLD, body, good, hand_in

ALLOW = ["--allow", "place_robot", "--jobs", "1"]
LIMITS = ["--max-fuel", "20000000", "--max-output", "20000"]

GRADES = {
    "<c>.c": ("4", "ended", ""),
    "<img src=x onerror=alert(1)>.c": ("1", "ended", ""),
    "'=1+cmd.c": ("1", "ended", ""),
    "HUGO.C": ("4", "ended", ""),
    "allocates.c": ("0", "limit", "computed more than 20,000,000 instructions"),
    "anna.c": ("4", "ended", ""),
    "backward.c": ("0", "ended", ""),
    "berta.c": ("4", "ended", ""),
    "binary.c": ("0", "compile error", "is not a text file"),
    "bomb.c": ("0", "compile error", "bomb.c:41: macro expansion is too large"),
    "carl.c": ("4", "ended", ""),
    "cheats.c": ("0", "refused", "cheats.c:5: place_robot() is not allowed: no robot can do that"),
    "cheats_by_request.c": ("0", "refused", "new_world() is not allowed: no robot can do that"),
    "cheats_hidden.c": (
        "0", "refused", "cheats_hidden.c:6: new_world() is not allowed: no robot can do that",
    ),
    "crash_early.c": (
        "0", "run-time error",
        "crash_early.c:5: out of bounds: index 13 is past the end of 'a'",
    ),
    "crash_late.c": (
        "3", "run-time error", "crash_late.c:15: null pointer: reads 4 bytes at address 0x0",
    ),
    "dora": ("4", "ended", ""),
    "emil": ("4", "ended", ""),
    "empty.c": ("0", "compile error", "the program has no function 'main'"),
    "forks.c": ("0", "limit", "computed more than 20,000,000 instructions"),
    "frida.c": ("3", "ended", ""),
    "html_error.c": ("0", "compile error", "html_error.c:1: #error <script>alert(1)</script>"),
    "huge.c": ("0", "compile error", "huge.c:1: 'a' does not fit: 1600000000 bytes of 14675968"),
    "h\ufffd?.c": ("0", "compile error", f"h\ufffd?.c:1: #error ?[31m{'long ' * 60}"[:300] + "..."),
    "ida.cpp": ("0", "invalid", "no C file (.c)"),
    "itself.c": ("0", "compile error", "itself.c:1: #include nested more than 200 deep"),
    "link.c": ("0", "invalid", "link.c is a link; links are not followed"),
    "linked": ("0", "invalid", "secret.h is a link; links are not followed"),
    "loop.c": ("0", "limit", "computed more than 20,000,000 instructions"),
    "mine": ("0", "invalid", "a folder must not be called <library>"),
    "nested.c": ("0", "compile error", "nested.c:1: the program is nested too deeply here"),
    "no_code": ("0", "invalid", "no C file (.c)"),
    "nothing.c": ("1", "ended", ""),
    "outside.c": (
        "0", "compile error",
        "outside.c:1: '../../secret.h' is outside the directories that a program may read",
    ),
    "passwd.c": ("0", "compile error", "passwd.c:1: '/etc/passwd' cannot be included"),
    "pipe.c": ("0", "invalid", "pipe.c is neither a file nor a folder"),
    "prints.c": ("4", "ended", ""),
    "reads.c": ("0", "limit", "computed more than 20,000,000 instructions"),
    "recursion.c": (
        "0", "run-time error",
        "recursion.c:1: stack overflow: 21,846 nested calls fill the 2,097,152-byte stack",
    ),
    "semicolon.c": ("0", "compile error", "semicolon.c:3: expected ';' after '1'"),
    "slow.c": ("1", "ended", ""),
    "talks.c": ("0", "limit", "printed more than 20,000 bytes"),
    "two_mains": ("0", "compile error", "b.c:1: multiple definition of 'main'"),
    "unconnected.c": ("1", "ended", ""),
    "undeclared.c": (
        "0", "compile error", "undeclared.c:3: use of undeclared identifier 'speed'",
    ),
    "unlinked.c": ("0", "compile error", "unlinked.c:2: 'far' is used, but not defined"),
    "waits.c": ("1", "ended", ""),
    "writes.c": ("0", "limit", "computed more than 20,000,000 instructions"),
    "ö-gustav.c": ("4", "ended", ""),
}  # fmt: skip


@pytest.fixture(scope="module")
def graded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder in which all submissions have been graded."""
    folder = tmp_path_factory.mktemp("graded")
    (folder / "task.xml").write_text(WORLD)
    targets = [f"--{kind}={folder / f'grades.{kind}'}" for kind in ("csv", "html")]
    files = [str(hand_in(folder)), str(folder / "task.xml")]
    runs = ["--runs", str(folder / "runs"), "--jobs", "2", "--quiet"]
    assert main(["grade", *files, *LIMITS, *targets, *runs]) == 0
    return folder


def rows(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8-sig", newline="") as file:
        return list(csv.DictReader(file))


def test_every_submission_gets_its_grade(graded: Path) -> None:
    found = rows(graded / "grades.csv")
    grades = {row["submission"]: (row["points"], row["result"], row["message"]) for row in found}
    assert grades == GRADES
    assert {row["of"] for row in found} == {"4"}
    assert [row["submission"] for row in found] == list(GRADES)


def test_the_table_has_the_status_of_each_goal(graded: Path) -> None:
    by_name = {row["submission"]: row for row in rows(graded / "grades.csv")}
    goals = [(by_name[n]["task: There"], by_name[n]["task: No collision"]) for n in ("slow.c",)]
    assert goals == [("failed 6.00 s", "holds")]
    assert by_name["semicolon.c"]["task: There"] == ""
    assert by_name["anna.c"]["task: There"].startswith("met ")


def test_equal_programs_are_hinted_and_no_others(graded: Path) -> None:
    like = {row["submission"]: row["like"] for row in rows(graded / "grades.csv") if row["like"]}
    same = [("anna.c", "<c>.c"), ("berta.c", "carl.c")]
    assert like == {one: other for pair in same for one, other in (pair, pair[::-1])}


class Page(HTMLParser):
    """The elements of a page, and its text outside of scripts and styles."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.text = self.script = ""
        self._inside = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self._inside = tag
        self.elements.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        if self._inside == "script":
            self.script += data
        elif self._inside != "style":
            self.text += data

    def handle_endtag(self, tag: str) -> None:
        self._inside = ""


def test_nothing_of_a_submission_is_more_than_text_in_the_page(graded: Path) -> None:
    page = Page((graded / "grades.html").read_text("utf-8"))
    assert [tag for tag, _ in page.elements].count("script") == 1
    images = [attributes for tag, attributes in page.elements if tag == "img"]
    assert len(images) > 20
    for attributes in images:
        assert attributes.keys() == {"alt", "loading", "src"}
        assert (attributes["src"] or "").startswith("data:image/svg+xml;base64,")
    for _, attributes in page.elements:
        assert not any(name.startswith("on") for name in attributes)
    assert "0\n1\n2\n" in page.text  # printed by prints.c
    for text in ("<img src=x onerror=alert(1)>.c", "#error <script>alert(1)</script>", "ö-gustav"):
        assert text in page.text
    policy = next(a["content"] for tag, a in page.elements if "http-equiv" in a) or ""
    assert policy.startswith("default-src 'none'; img-src data:;")
    digest = base64.b64encode(hashlib.sha256(page.script.encode()).digest()).decode()
    assert f"script-src 'sha256-{digest}';" in policy  # else the table could not be sorted
    links = [attributes["href"] or "" for tag, attributes in page.elements if tag == "a"]
    assert all(re.match(r"#s\d+$|runs/\d{3}-\w+-task\.mcap$", link) for link in links), links


def test_nothing_outside_of_a_submission_is_read(graded: Path) -> None:
    for name in ("grades.csv", "grades.html"):
        text = (graded / name).read_text("utf-8")
        assert "4711" not in text
        assert "root:" not in text
    assert not list(graded.glob("x"))


def test_each_run_has_a_picture_and_a_recording_of_the_same_run(
    graded: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    pictures = {path.stem for path in (graded / "runs").glob("*.svg")}
    assert {"006-anna_c-task", "007-backward_c-task"} <= pictures
    assert b"There" in (graded / "runs" / "006-anna_c-task.svg").read_bytes()
    recording = graded / "runs" / "006-anna_c-task.mcap"
    assert main(["replay", str(recording), "--verify"]) == 0
    assert "the same run" in "".join(capfd.readouterr())
    main(["replay", str(recording)])
    shown = capfd.readouterr().out
    assert "anna.c" in shown
    assert "world/task.xml" in shown
    assert "crs-grade" not in shown


def test_grades_are_the_same_one_by_one_and_in_another_order(
    graded: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    names = ["prints.c", "crash_late.c"]
    files = [str(graded / "submissions" / name) for name in names]
    table = graded / "again.csv"
    arguments = [*files, str(graded / "task.xml"), *LIMITS, "--jobs", "1", "--csv", str(table)]
    assert main(["grade", *arguments, "--excel"]) == 0
    assert table.read_bytes().startswith(b"\xef\xbb\xbfsubmission,")
    assert not (graded / "grades.csv").read_bytes().startswith(b"\xef")
    before = {row["submission"]: row for row in rows(graded / "grades.csv")}
    assert rows(table) == [before[name] for name in names]
    assert capfd.readouterr().out.splitlines() == [
        "prints.c            4 of 4  ended",
        "crash_late.c        3 of 4  crash_late.c:15: null pointer: reads 4 bytes at address 0x0",
    ]


@pytest.fixture
def class_of_two(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("task.xml").write_text(WORLD)
    Path("in").mkdir()
    Path("in/anna.c").write_text(good())
    Path("in/places.c").write_text(body("place_robot(1181, 393, 0, 0); gs();"))
    return tmp_path


def test_an_allowed_call_counts_and_seeds_and_worlds_add_up(
    class_of_two: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    Path("other.xml").write_text(WORLD.replace('points="3"', 'points="5"'))
    arguments = ["in/places.c", "task.xml", "other.xml", "--seed", "1", "--seed", "2"]
    assert main(["grade", *arguments, *ALLOW, "--csv", "g.csv"]) == 0
    assert capfd.readouterr().out == "places.c      20 of 20  ended\n"
    (row,) = rows(Path("g.csv"))
    assert [name for name in row if "There" in name] == [
        "task seed 1: There", "task seed 2: There", "other seed 1: There", "other seed 2: There"
    ]  # fmt: skip


def test_worlds_and_submissions_with_equal_names_are_distinguished(
    class_of_two: Path, capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Both runs were recorded to one file, and both submissions were called `anna.c`."""
    for name in ("easy/room.xml", "hard/room.xml"):
        Path(name).parent.mkdir()
        Path(name).write_text(WORLD)
    Path("late").mkdir()
    Path("late/anna.c").write_text(good())
    monkeypatch.setattr("crs_cc.cli.grading.grading._MAX_NAME", 4)
    files = ["in/anna.c", "late/anna.c", "easy/room.xml", "hard/room.xml"]
    options = ["--max-time", "1", "--jobs", "1", "--runs", "runs", "--csv", "g.csv"]
    assert main(["grade", *files, *options]) == 0
    assert [line.split()[0] for line in capfd.readouterr().out.splitlines()] == [
        "in/anna.c", "late/anna.c"
    ]  # fmt: skip
    (first, _) = rows(Path("g.csv"))
    assert [name for name in first if "There" in name] == [
        "easy/room.xml: There", "hard/room.xml: There"
    ]  # fmt: skip
    assert len(list(Path("runs").glob("*.mcap"))) == 4
    cases = [Case(name, Path(name), None, ()) for name in ("Room", "room")]
    assert file_names(0, Submission("anna.c", Path("anna.c")), cases) == [
        "001-anna-1-Room.mcap", "001-anna-2-room.mcap"
    ]  # fmt: skip


def test_grades_are_shown_where_a_file_cannot_be_written(
    class_of_two: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """An unwritable table, or a folder of runs on another drive, cost the whole grading."""

    def fails(path: str, start: str) -> str:
        raise ValueError(f"path is on mount {path!r}, start on mount {start!r}")

    real = Path.write_text

    def write(path: Path, text: str, encoding: str) -> int:
        if path.suffix == ".csv":  # as where a spreadsheet has opened it
            raise PermissionError(errno.EACCES, "Permission denied", str(path))
        return real(path, text, encoding)

    monkeypatch.setattr("os.path.relpath", fails)
    monkeypatch.setattr(Path, "write_text", write)
    targets = ["--csv", "g.csv", "--html", "g.html", "--runs", "runs"]
    assert main(["grade", "in/anna.c", "task.xml", "--max-time", "1", *targets]) != 0
    told = capsys.readouterr()  # not capfd, whose own file would be muted
    assert told.out.startswith("anna.c")
    assert "g.csv" in told.err
    assert "internal" not in told.err
    page = Path("g.html").read_text("utf-8")
    assert f'href="{Path("runs").resolve().as_uri()}/001-anna_c-task.mcap"' in page


def test_a_copy_is_found_where_its_first_run_was_stopped_from_outside() -> None:
    stopped, done = GradedRun("limit", "took too long"), GradedRun("ended", "", fingerprint="f")
    assert identical_programs([[stopped, done], [done, done]], ["a", "b"]) == [("b",), ("a",)]


@pytest.mark.parametrize(
    ("arguments", "text", "status"),
    [
        (["in"], "no world: name at least one .xml file with goals.", 2),
        (["task.xml"], "no submissions: name a folder.", 2),
        (["empty", "task.xml"], "no submissions in empty.", 2),
        (["nowhere", "task.xml"], "nowhere: No such file or directory.", 2),
        (["in", "task.xml", "--allow", "fly"], "--allow: unknown function 'fly' (known: ", 2),
        (["in", "task.xml", "--csv", "no/g.csv"], "cannot write 'no/g.csv': no such folder.", 2),
        (["in", "task.xml", "--seed", "1", "--seed", "1"], "--seed 1 is given twice.", 2),
        (["in", "in/../in", "task.xml"], "in is given twice.", 2),
        (["in", "task.xml", "--file", "no.txt"], "--file 'no.txt': no such file", 2),
        (["in", "task.xml", "--robot", "r2d2"], "unknown robot 'r2d2' (known: ", 2),
        (["in", "plain.xml"], "plain.xml: error: the world has no goals", 122),
        (["in", "manned.xml"], "manned.xml: error: the world names a program for every robot", 122),
        (["in", "broken.xml"], "broken.xml:4: error: goal, robots: unknown robot 'r' (known:", 122),
    ],
)
def test_grading_errors_are_reported_once(
    arguments: list[str],
    text: str,
    status: int,
    class_of_two: Path,
    capfd: pytest.CaptureFixture[str],
) -> None:
    Path("empty").mkdir()
    Path("plain.xml").write_text(re.sub(r"<goal.*</goal>", "", WORLD, flags=re.DOTALL))
    Path("manned.xml").write_text(WORLD.replace("<robot ", '<robot program="in/anna.c" '))
    Path("broken.xml").write_text(WORLD.replace("<goal ", '<goal robots="r" ', 1))
    assert main(["grade", *arguments]) == status
    err = capfd.readouterr().err
    assert text in err
    assert err.count("rror: ") == 1


READS = """#include <stdio.h>
#include "Nclient.h"
int main(void)
{
    char line[80];
    FILE *map = fopen("map.txt", "r"), *own = fopen("sub/own.txt", "r");
    printf("%d\\n", fopen("secret.dat", "r") == 0);
    connect_robot(1);
    if (map && own && fgets(line, 80, map) && line[0] == 't')
        place_robot(1181, 393, 0, 0);
    gs();
    return 0;
}
"""


def test_programs_read_files_of_the_assignment_and_of_their_own(
    class_of_two: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    for name in ("reads/sub/own.txt", "reads/map.txt", "reads/secret.dat", "map"):
        Path(name).parent.mkdir(parents=True, exist_ok=True)
        Path(name).write_text("the teacher's" if name == "map" else "mine")
    Path("reads/main.c").write_text(READS)
    files = ["--file", "map.txt=map", "--data", "*.txt"]
    Path("all").mkdir()
    Path("reads").rename("all/reads")
    arguments = ["all", "task.xml", *ALLOW, *files, "--runs", "runs"]
    assert main(["grade", *arguments]) == 0
    assert capfd.readouterr().out == "reads        4 of 4  ended\n"
    assert main(["grade", "all", "task.xml", *ALLOW, "--runs", "runs"]) == 0
    assert capfd.readouterr().out == "reads        1 of 4  ended\n"
    Path("all/reads/main.c").write_text("int")
    assert main(["grade", "all", "task.xml", "--runs", "runs", "--quiet"]) == 0
    assert not list(Path("runs").iterdir())  # nothing is left of the earlier gradings


def test_robot_and_setup_are_those_that_are_wanted(
    class_of_two: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    Path("in/model.c").write_text(
        '#include <stdlib.h>\n#include "Nclient.h"\n'
        "int main(void) { connect_robot(1); get_sn(); if (!get_ir()) abort(); return 0; }\n"
    )
    assert main(["grade", "in/model.c", "task.xml", "--robot", "nomad200"]) == 0
    assert main(["grade", "in/model.c", "task.xml", "--setup", "noisy"]) == 0
    shown = capfd.readouterr().out.splitlines()
    assert [line.split("  ")[-1] for line in shown] == ["ended", "model.c:3: abort called"]
