"""Animations of runs and recordings: what is on their pictures, and how many there are."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from crs_cc.cli.main import main
from crs_cc.plot.raster import blank, draw, smaller
from crs_cc.plot.svg import Page

PROGRAM = """
#include <Nclient.h>
#include <stdlib.h>
#include <unistd.h>
int main(int count, char **words)
{
    int speed = atoi(words[1]);
    connect_robot(1);
    vm(speed, speed, 0);
    sleep(atoi(words[2]));
    return 0;
}
"""
WORLD = """<world version="1" timestep="100ms"><area length="8m" width="2m"/>
  <box id="crate" x="2m" y="1m" length="0.4m" width="0.4m" mass="1kg"/>
  <robot x="1m" y="1m"/>
</world>
"""
BLUE = (0, 114, 178)  # of the first robot
CRATE = (217, 184, 138)


def film(folder: Path, name: str, words: list[str], *options: str) -> Any:
    (folder / "drive.c").write_text(PROGRAM)
    (folder / "room.xml").write_text(WORLD)
    files = [str(folder / each) for each in ("drive.c", "room.xml")]
    assert (
        main(["run", *files, *options, "--quiet", "--plot", str(folder / name), "--", *words]) == 0
    )
    return Image.open(folder / name)


def columns(image: Image.Image, paint: tuple[int, ...]) -> list[int]:
    """Return in which columns there is a colour."""
    pixels = np.array(image.convert("RGB").crop((60, 60, 560, image.height)))
    found: list[int] = np.flatnonzero((pixels == paint).all(axis=2).any(axis=0)).tolist()
    return found


def test_a_run_is_an_animation_and_its_recording_the_same_one(tmp_path: Path) -> None:
    recorded = str(tmp_path / "run.mcap")
    made = film(tmp_path, "run.gif", ["400", "3"], "--record", recorded)
    assert made.size[0] <= 800
    assert 28 <= made.n_frames <= 36
    made.seek(0)
    first, crate = columns(made, BLUE), columns(made, CRATE)
    made.seek(made.n_frames - 1)
    last, pushed = columns(made, BLUE), columns(made, CRATE)
    assert last[-1] > first[-1] + 80
    assert abs(first[0] - last[0]) <= 3  # its path begins where it was
    assert crate[0] + 30 < pushed[0]
    assert made.convert("RGB").getpixel((1, 1)) == (255, 255, 255)
    assert main(["replay", recorded, "--plot", str(tmp_path / "again.apng")]) == 0
    again: Any = Image.open(tmp_path / "again.apng")
    assert again.n_frames == made.n_frames
    again.seek(again.n_frames - 1)
    assert columns(again, BLUE) == last


def test_a_long_run_is_shown_faster(tmp_path: Path) -> None:
    made = film(tmp_path, "run.gif", ["1", "25"])
    assert 100 < made.n_frames < 150


def test_other_pictures_are_rejected(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["run", "x.c", "--plot", str(tmp_path / "x.png")]) == 2
    assert "name it x.svg, or x.gif or x.apng for an animation" in capfd.readouterr().err
    assert main(["run", "x.c", "--plot", str(tmp_path / "x.gif"), "--plot-sensors"]) == 2


def test_lines_are_dashed_and_texts_anchored() -> None:
    page = Page(100, 40, "")
    page.line((0, 10), (100, 10), stroke="black", stroke_width=2.0, stroke_dasharray="10 10")
    page.text((100, 30), "mm", text_anchor="end", fill="red", font_size=12.0)
    image = blank(page)
    draw(page, image)
    pixels = np.array(smaller(image))
    assert (pixels[10, [5, 15, 25, 35], 0] < 128).tolist() == [True, False, True, False]
    _, reds = np.nonzero(pixels[20:, :, 1] < 128)
    assert reds.min() > 70
    assert reds.max() <= 99
