"""`-W` options and other options of gcc."""

import json
import re
from pathlib import Path

import pytest

import crs_cc
from crs_cc.cli.main import main
from crs_cc.core.warning_names import WARNINGS

DOUBTFUL = """
int twice(int n) { 2 * n; }
int main(void) { return 2 == 2 && twice; }
"""

pytestmark = pytest.mark.usefixtures("elsewhere")


@pytest.fixture
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("doubtful.c").write_text(DOUBTFUL)


def checked(*options: str) -> tuple[int, list[tuple[str, str]]]:
    """Return the exit status of `crs check`, and the severity and name of each message."""
    import contextlib
    import io

    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        status = main(["check", "--json", *options, "doubtful.c"])
    return status, [(each["severity"], each["flag"]) for each in json.loads(out.getvalue())]


def test_warnings_are_selected_by_name() -> None:
    warned = [("warning", "unused-value"), ("warning", "return-type")]
    assert checked() == (0, warned)
    assert checked("-Wall", "-Wextra", "-O2", "-g", "-ansi", "-lm", "-Wshadow") == (0, warned)
    assert checked("-Wno-unused") == (0, [("warning", "return-type")])
    assert checked("-w") == (0, [])
    assert checked("-Wno-all", "-Wreturn-type") == (0, [("warning", "return-type")])


def test_warnings_are_made_errors() -> None:
    mixed = [("warning", "unused-value"), ("error", "return-type")]
    assert checked("-Werror=return-type") == (121, mixed)
    assert checked("-Werror", "-Wno-error=unused-value") == (121, mixed)
    assert checked("-Werror", "-Wno-all") == (0, [])
    assert main(["run", "-q", "-Werror", "doubtful.c"]) == 121
    assert main(["compile", "-q", "-Werror", "doubtful.c"]) == 121


def test_messages_name_their_warning(capfd: pytest.CaptureFixture[str]) -> None:
    main(["check", "doubtful.c", "-Wno-retrun-type"])
    text = capfd.readouterr().err
    assert "expression result unused [-Wunused-value]" in text
    assert "-Wno-retrun-type: no such warning (did you mean 'return-type'?)" in text


def test_every_warning_of_the_sources_has_a_known_name() -> None:
    paths = Path(crs_cc.__file__).parent.rglob("*.py")
    text = "".join(path.read_text("utf-8") for path in paths if path.name != "warning_names.py")
    assert set(re.findall(r'flag="([^"]+)"', text)) <= WARNINGS.keys()
    assert [name for name in WARNINGS if f'"{name}"' not in text] == []
