"""`crs new`: write a commented template of a world, a robot model or a program."""

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
  crs new world room            write room.xml
  crs new robot rover           write rover.xml, a robot model
  crs new program wander        write wander.c
"""


@click.command(epilog=_EXAMPLES, short_help="Write a world, robot or program template.")
@click.argument("kind", type=click.Choice(list(_ENDINGS)))
@click.argument("name")
def new(kind: str, name: str) -> int:
    """Write a template that can be checked and run unchanged; never overwrite a file."""
    path = Path(name)
    if path.name and path.suffix.lower() != _ENDINGS[kind]:
        path = path.with_name(path.name + _ENDINGS[kind])
    if not _NAME.fullmatch(path.stem):
        raise click.UsageError(
            f"'{path.stem}' is not a valid name: up to 64 letters, digits, _ . -; no leading digit."
        )
    text = (_TEMPLATES / f"{kind}{_ENDINGS[kind]}").read_text(encoding="utf-8")
    try:
        with path.open("x", encoding="utf-8") as file:
            file.write(text.replace("NAME", path.stem))
    except FileExistsError:
        raise click.UsageError(f"'{path}' already exists.") from None
    except OSError as error:
        raise click.UsageError(f"cannot write '{path}': {error.strerror}.") from None
    click.echo(f"wrote {path}; list its contents with: crs check {path}")
    return 0
