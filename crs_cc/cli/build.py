"""`crs build`: the world builder in the browser."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import click

from crs_cc.cli.page_options import page_options

_EXAMPLES: Final = """
\b
Examples:
  crs build room.xml                    draw and change a world
  crs build                             a new world
  crs build room.xml wander.c           and try it with this program
  crs build room.xml --no-open          print the address only
"""


@click.command(epilog=_EXAMPLES, short_help="Draw or edit a world in the browser.")
@click.argument("world", required=False, type=click.Path(path_type=Path))
@click.argument("program", required=False, type=click.Path(exists=True, path_type=Path))
@page_options
def build(world: Path | None, program: Path | None, port: int, *, opens: bool) -> int:
    """Draw or edit a world in the browser: walls, objects, ramps, robots.

    The file is edited in place: comments, order and units are preserved. It is saved when it is
    valid. The button Try runs the world with the programs that it names, or with the one given
    here. The page is served to this machine only; anyone who has the printed URL can change the
    world.
    """
    from crs_cc.cli.start_build import serve_builder

    return serve_builder(world, program, port, opens=opens)
