"""`crs samples`: list the sample programs and worlds, and copy them."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from itertools import groupby
from pathlib import Path
from textwrap import shorten
from typing import TYPE_CHECKING, Final

import click
from click.shell_completion import CompletionItem

if TYPE_CHECKING:
    from crs_cc.cli.sample_files import Sample

_TITLES: Final = {
    "scout_c": "Programs",
    "plugins": "Devices in packages of their own",
    "python": "Scripts in Python",
    "swarm": "Experiments with many robots (crs docs swarms)",
    "tutorial": "The program and the world of the tutorial (crs docs tutorial-debugging)",
    "worlds": "Worlds",
}
_EXAMPLES: Final = """
\b
Examples:
  crs samples                              list them
  crs samples copy wander.c room.xml .     copy a program and a world
  crs run wander.c room.xml --max-time 60  run them
"""


@click.group(
    epilog=_EXAMPLES,
    short_help="List the sample programs and worlds, and copy them.",
    invoke_without_command=True,
)
@click.pass_context
def samples(context: click.Context) -> int:
    """List the sample programs and worlds of crs, with a one-line description of each."""
    if context.invoked_subcommand is not None:
        return 0
    from crs_cc.cli.sample_files import all_samples

    listed = all_samples()
    width = max(len(each.name) for each in listed)
    room = shutil.get_terminal_size((100, 24)).columns - width - len("    ")
    for group, found in groupby(listed, lambda each: each.group):
        click.echo(f"{_TITLES.get(group, group)}:")
        for each in found:
            click.echo(f"  {each.name:{width}}  {shorten(each.summary(), max(room, 20))}")
        click.echo()
    click.echo("Copy some to a folder with: crs samples copy NAME... FOLDER")
    return 0


def _complete(
    _context: click.Context, _parameter: click.Parameter, start: str
) -> list[CompletionItem]:
    from crs_cc.cli.sample_files import all_samples

    names = [each.name for each in all_samples() if each.name.startswith(start)]
    return [*map(CompletionItem, names)] or [CompletionItem(start, type="dir")]


@samples.command(epilog=_EXAMPLES, short_help="Copy samples to a folder.")
@click.argument(
    "names", nargs=-1, required=True, metavar="NAME... FOLDER", shell_complete=_complete
)
def copy(names: Sequence[str]) -> int:
    """Copy samples to a folder, with the files that they need; never overwrite a file."""
    *chosen, folder = names
    target = Path(folder)
    if not chosen or not target.is_dir():
        raise click.UsageError(
            f"'{folder}' is not a folder: name the folder to copy to last, such as '.'."
        )
    files = {below: file for name in chosen for file, below in _sample(name).files()}
    for below in files:
        if (target / below).exists() or (target / below).is_symlink():
            raise click.UsageError(f"'{target / below}' already exists.")
    for below, file in files.items():
        try:
            (target / below).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, target / below)
        except OSError as error:
            raise click.UsageError(f"cannot write '{target / below}': {error.strerror}.") from None
        click.echo(f"wrote {target / below}")
    return 0


def _sample(name: str) -> Sample:
    """Return the sample or file with a name, which may lack its ending or have its folder.

    Raises:
        click.UsageError: there is none, or several.
    """
    from crs_cc.cli.sample_files import all_samples, other_files
    from crs_cc.core.suggest import closest

    known = all_samples()
    last = Path(name).name
    found = [each for each in known if each.name == last and each.path.match(name)]
    found = found or [each for each in known if each.path.stem == name]
    found = found or [each for each in other_files() if each.path.match(name)]
    if len(found) == 1:
        return found[0]
    if found:
        choices = " or ".join(f"'{each.path.parent.name}/{each.name}'" for each in found)
        raise click.UsageError(f"several samples are named '{name}': choose {choices}.")
    near = closest(last, [each.name for each in known])
    near = near or closest(Path(last).stem, [each.path.stem for each in known])
    hint = f"did you mean '{near}'?" if near else "'crs samples' lists them."
    raise click.UsageError(f"unknown sample '{name}': {hint}")
