"""What programs draw is in plots, animations and pages of their recordings as it was in the run."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from PIL import Image

from crs_cc.cli.main import main
from crs_cc.recording.marks import at_time, drawn_marks
from crs_cc.recording.recording import Recording
from tests.recording.test_replay import rewritten_event

PROGRAM = r"""
#include <Nclient.h>
#include <unistd.h>

int main(void)
{
    int i;
    connect_robot(1);
    draw_line(0, 0, 100, 100, 1);          /* is erased with all others */
    usleep(500000);
    refresh_all();
    usleep(500000);
    draw_line(0, 0, 400, 0, 18);           /* red; drawn again below, so it disappears */
    draw_arc(-200, 200, 400, 400, 0, 3600, 3);
    draw_robot(100, 300, 900, 450, 2);     /* with an arrow */
    usleep(500000);
    for (i = 0; i < 2; i++)
        draw_line(0, 0, 0, 400, 1);        /* stays, once */
    draw_line(0, 0, 400, 0, 18);
    draw_line(300, -300, 300, 300, 17);    /* orange-red */
    usleep(500000);
    return 0;
}
"""


@pytest.fixture(scope="module")
def drawn(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the recording; beside it are the plot of the run and its page."""
    folder = tmp_path_factory.mktemp("drawn")
    (folder / "draw.c").write_text(PROGRAM)
    options = ["--record", str(folder / "run.mcap"), "--plot", str(folder / "run.svg"), "--quiet"]
    assert main(["run", str(folder / "draw.c"), *options]) == 0
    return folder / "run.mcap"


def strokes(path: Path) -> list[str]:
    return re.findall(r'<polyline points="[^"]*" stroke="[^"]*"/>', path.read_text())


def test_a_plot_of_the_recording_equals_that_of_the_run(drawn: Path, tmp_path: Path) -> None:
    path = tmp_path / "again.svg"
    assert main(["replay", str(drawn), "--plot", str(path)]) == 0
    found = strokes(path)
    assert found == strokes(drawn.with_suffix(".svg"))
    assert len(found) == 8  # an arc, four of a robot with its arrow, two lines, and the path
    recording = Recording(drawn)
    marked = drawn_marks(recording)
    recording.close()
    assert [len(at_time(marked, time_s)) for time_s in (0.3, 0.8, 1.3, 1.9)] == [1, 0, 4, 5]
    colours = [each.colour for each in at_time(marked, 1.3)]
    assert "Red" in colours


def test_animations_and_pages_show_marks_while_they_were_visible(
    drawn: Path, tmp_path: Path
) -> None:
    film, page = tmp_path / "run.apng", tmp_path / "run.html"
    assert main(["replay", str(drawn), "--plot", str(film), "--html", str(page)]) == 0
    red = []
    with Image.open(film) as pictures:
        for number in (3, 13, 18):
            pictures.seek(number)
            colours = pictures.convert("RGB").getcolors(10**6)
            assert colours is not None
            red.append(sum(n for n, (r, g, b) in colours if r > 200 and g < 90 and b < 60))
    assert red[0] < red[1]
    assert red[2] > red[0]
    text = page.read_text()
    found = re.search(r'<script type="application/json" id="run">(.*?)</script>', text, re.DOTALL)
    assert found is not None
    marks = json.loads(found[1])["marks"]
    assert len(marks) == 9
    assert [0.0, "#000000"] in [[round(each[0], 1), each[2]] for each in marks]


@pytest.mark.parametrize("mark", [[1, 2], [9] * 8, [1, 0, 0, 0, 0, 0, 0, 2**40], "line", [1.5] * 8])
def test_an_invalid_mark_is_rejected(
    drawn: Path, tmp_path: Path, capfd: pytest.CaptureFixture[str], mark: object
) -> None:
    other = tmp_path / "other.mcap"
    rewritten_event(drawn, other, {"mark": mark})
    assert main(["replay", str(other), "--plot", str(tmp_path / "a.svg")]) == 120
    assert capfd.readouterr().err.count("error:") == 1
