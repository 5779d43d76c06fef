"""Robots with devices of `crs.h`."""

from __future__ import annotations

from pathlib import Path

from crs_cc.sim.files import world_xml


def scout_with(folder: Path, *devices: str) -> str:
    """Write the definition of a Scout with additional XML elements; return its path."""
    text = (Path(world_xml.__file__).parents[0] / "robots" / "scout.xml").read_text()
    path = folder / "scout-with.xml"
    path.write_text(text.replace("<computer-battery", f"{''.join(devices)}<computer-battery", 1))
    return str(path)
