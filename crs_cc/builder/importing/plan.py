"""The reader of a plan, by the ending of its name."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Final

from crs_cc.builder.importing.drawn import PlanElements
from crs_cc.builder.importing.png_plan import read_png
from crs_cc.builder.importing.sdf_plan import read_sdf
from crs_cc.builder.importing.stage_plan import read_stage
from crs_cc.builder.importing.svg_plan import read_svg
from crs_cc.core.errors import WorldError
from crs_cc.core.source import Location
from crs_cc.core.suggest import unknown
from crs_cc.sim.files.image import MAX_BYTES
from crs_cc.sim.files.nearby import read_below
from crs_cc.sim.files.xml_document import read_file

THICKNESS_M: Final = 0.1


def read_plan(
    path: Path, scale_m: float | None = None, thickness_m: float = THICKNESS_M
) -> PlanElements:
    """Return the elements of a plan: SVG, PNG, a world of Stage, or SDF.

    Args:
        path: the file.
        scale_m: the size of a pixel, or of a unit of SVG; by default the physical size of SVG.
        thickness_m: the thickness of walls that are lines.

    Raises:
        WorldError: it cannot be read; the message is the reason.
    """
    text, file = read_file(path), str(path)
    readers: dict[str, Callable[[], PlanElements]] = {
        ".svg": lambda: read_svg(text, file, scale_m, thickness_m),
        ".png": lambda: read_png(text, scale_m),
        ".world": lambda: read_stage(
            text.decode(errors="replace"),
            lambda name: read_below(path.parent, name, ".png", MAX_BYTES),
        ),
        ".sdf": lambda: read_sdf(text, file),
    }
    reader = readers.get(path.suffix.lower())
    place = Location(file)
    if reader is None:
        raise WorldError.at(place, unknown("kind of plan", path.suffix, tuple(readers)))
    try:
        drawn = reader()
    except (ValueError, OverflowError) as wrong:
        raise WorldError.at(place, f"cannot be imported: {wrong}") from None
    if not drawn.elements:
        left = ", ".join(drawn.omissions()) or "it is empty"
        raise WorldError.at(place, f"nothing in it can be imported ({left})")
    return drawn
