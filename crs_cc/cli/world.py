"""`crs world`: edit a world file from the command line, one operation of the builder at a time."""

from __future__ import annotations

import functools
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

import click

from crs_cc.builder.table import OPERATIONS, Field, Operation
from crs_cc.cli.messages import say
from crs_cc.core.quantity import Kind

_EXAMPLES: Final = """
\b
Examples:
  crs world list room.xml                         the names of all elements
  crs world add room.xml box x=1m y=2m length=40cm width=30cm
  crs world move room.xml crate --x 50cm          by half a metre
  crs world set room.xml crate mass=3kg heat=     set one attribute, remove another
  crs world array room.xml shelf --columns 5 --x 1.2m
  crs world group room.xml top leg0 leg1 --name table
  crs world copy canteen.xml p1 | crs world paste room.xml -
  crs world import office.xml plan.svg            a new world from a floor plan
  crs world export room.xml room.sdf              for Gazebo
  crs world turn room.xml table --angle 30deg --diff
"""


@click.group(
    epilog=_EXAMPLES,
    short_help="Edit a world file from the command line.",
    no_args_is_help=True,
)
def world() -> None:
    """Edit a world file, a robot definition or a file of definitions.

    Comments, order, spaces and units are preserved; only what changes is rewritten. The file is
    replaced atomically, and only if the result is valid (crs check). Elements are
    named by their ids, or by their paths: crate, surface/ramp[1], define[table]/leg0.
    """


@world.command(name="list", short_help="List the names of all elements.")
@click.argument("file", type=click.Path(path_type=Path))
@click.argument("name", required=False, default="")
def list_(file: Path, name: str) -> int:
    """List the names of the elements of a file, or of those in one of its elements."""
    from crs_cc.cli.edit_world import element_list

    for line in element_list(file, name):
        click.echo(line)
    return 0


@world.command(short_help="Print elements for crs world paste.")
@click.argument("file", type=click.Path(path_type=Path))
@click.argument("names", nargs=-1, required=True)
def copy(file: Path, names: tuple[str, ...]) -> int:
    """Print elements as XML with the definitions that they need, for crs world paste."""
    from crs_cc.cli.edit_world import copy_elements

    click.echo(copy_elements(file, names))
    return 0


@world.command(name="import", short_help="Insert a plan: SVG, PNG, Stage or SDF.")
@click.argument("file", type=click.Path(path_type=Path))
@click.argument("plan", type=click.Path(path_type=Path))
@click.option("--scale", metavar="LENGTH", help="Size of a pixel, or of an SVG unit, such as 5cm.")
@click.option("--thickness", metavar="LENGTH", default="10cm", help="Thickness of walls.")
@click.option("--x", metavar="LENGTH", default="0", help="Position of the plan's x = 0.")
@click.option("--y", metavar="LENGTH", default="0", help="Position of the plan's y = 0.")
def import_(file: Path, plan: Path, **given: Any) -> int:
    """Insert the walls and objects of a plan into a world, or create a new world from them.

    A plan is an SVG drawing (lines, polylines, polygons, rectangles, circles, paths of straight
    segments), a PNG picture whose dark pixels are walls, a Stage world (.world), or SDF with boxes
    and cylinders. Whatever is omitted is listed. A new world gets an area that fits the plan.
    """
    from crs_cc.cli.edit_world import import_plan

    for line in import_plan(file, plan, given):
        say(line)
    return 0


@world.command(short_help="Write a world as SVG, PNG or SDF.")
@click.argument("file", type=click.Path(path_type=Path))
@click.argument("target", type=click.Path(path_type=Path))
def export(file: Path, target: Path) -> int:
    """Write a picture of a world (.svg, .png), or its walls, boxes and cylinders for Gazebo (.sdf).

    Whatever is omitted is listed.
    """
    from crs_cc.cli.edit_world import export_world

    for line in export_world(file, target):
        say(line)
    return 0


def _edit(row: Operation, file: Path, output: Path | None, *, diff: bool, **given: Any) -> int:
    from crs_cc.cli.edit_world import edit

    for name in edit(row, file, output, given, diff=diff):
        click.echo(name)
    return 0


def _command(row: Operation) -> click.Command:
    """Return the subcommand of an operation."""
    function: Callable[..., int] = functools.partial(_edit, row)
    parameters: list[click.Parameter] = [
        click.Argument(["file"], type=click.Path(path_type=Path)),
    ]
    is_alone = row.elements == "none"
    parameters += [
        click.Argument([field.name]) for field in row.fields if is_alone and field.required
    ]
    if row.elements == "one":
        parameters.append(click.Argument(["names"], nargs=1, metavar="NAME"))
    if row.elements == "some" or row.attributes:
        words = "NAME..." if not row.attributes else "NAME=VALUE..."
        several = (
            "NAME... ATTRIBUTE=VALUE..." if row.elements == "some" and row.attributes else words
        )
        parameters.append(click.Argument(["words"], nargs=-1, required=True, metavar=several))
    parameters += [_option(field) for field in row.fields if not (is_alone and field.required)]
    parameters.append(
        click.Option(
            ["-o", "--output"],
            type=click.Path(path_type=Path),
            metavar="FILE",
            help="Write the result to this new file, and leave FILE unchanged.",
        )
    )
    parameters.append(
        click.Option(["--diff"], is_flag=True, help="Print the changes, and write nothing.")
    )
    return click.Command(
        row.name,
        callback=function,
        params=parameters,
        help=row.summary,
        short_help=row.summary,
    )


def _option(field: Field) -> click.Option:
    kind: click.ParamType[Any] = click.STRING
    metavar = "TEXT"
    if isinstance(field.kind, tuple):
        kind, metavar = click.Choice(field.kind), "|".join(field.kind)
    elif isinstance(field.kind, Kind):
        metavar = field.kind.name.split()[-1].upper()
    elif field.kind in (int, float):
        metavar = "COUNT" if field.kind is int else "NUMBER"
    return click.Option(
        [f"--{field.name}"], type=kind, metavar=metavar, required=field.required, help=field.help
    )


for _row in OPERATIONS.values():
    world.add_command(_command(_row))
