"""`crs new`: writes a commented start of a world, a kind of robot, or a program."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Final

import click

_TEMPLATES: Final = Path(__file__).parent / "templates"
_NAME: Final = re.compile(r"[A-Za-z_][A-Za-z0-9_.\-]{0,63}")
_ENDINGS: Final = {"world": ".xml", "robot": ".xml", "program": ".c"}
_EXAMPLES: Final = """
\b
Examples:
  crs new world room            writes room.xml
  crs new robot rover           writes rover.xml, a kind of robot
  crs new program wander        writes wander.c
"""


@click.command(epilog=_EXAMPLES, short_help="Write a commented start of a world, robot or program.")
@click.argument("kind", type=click.Choice(list(_ENDINGS)))
@click.argument("name")
def new(kind: str, name: str) -> int:
    """Write a file to start from, which can be checked and run as it is; never over another."""
    path = Path(name)
    if path.name and path.suffix.lower() != _ENDINGS[kind]:
        path = path.with_name(path.name + _ENDINGS[kind])
    if not _NAME.fullmatch(path.stem):
        raise click.UsageError(
            f"'{path.stem}' is no name: letters, digits, _ . - only, no digit first, at most 64."
        )
    text = (_TEMPLATES / f"{kind}{_ENDINGS[kind]}").read_text(encoding="utf-8")
    try:
        with path.open("x", encoding="utf-8") as file:
            file.write(text.replace("NAME", path.stem))
    except FileExistsError:
        raise click.UsageError(f"'{path}' is there already.") from None
    except OSError as error:
        raise click.UsageError(f"cannot write '{path}': {error.strerror}.") from None
    click.echo(f"{path} written; see what is in it with: crs check {path}")
    return 0
