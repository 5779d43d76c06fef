"""`crs grade`: run many submissions in worlds with goals, and write a table of grades."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

import click

from crs_cc.cli import program_options
from crs_cc.cli.inputs import Inputs, is_world, make_folder, parse_named_files
from crs_cc.cli.messages import is_terminal, printable
from crs_cc.cli.path_options import written_file, written_folder
from crs_cc.cli.program_options import ProgramOptions
from crs_cc.core.errors import WorldError
from crs_cc.core.source import Location
from crs_cc.core.suggest import unknown

if TYPE_CHECKING:
    from crs_cc.cli.grading.grades import Case, Grade
    from crs_cc.cli.grading.grading import Settings
    from crs_cc.cli.grading.job import Robots
    from crs_cc.cli.grading.submissions import Submission

_MIB: Final = 2**20
_BYTE_ORDER_MARK: Final = "\ufeff"
_EXAMPLES: Final = """
\b
Examples:
  crs grade submissions/ course.xml
  crs grade submissions/ course.xml --html grades.html --csv grades.csv --runs runs
  crs grade anna.c ben.c easy.xml hard.xml --seed 1 --seed 2
"""


@dataclass(frozen=True, slots=True)
class _Targets:
    """Where to write the grades to.

    Attributes:
        csv: the table; None for none.
        for_excel: whether it begins with a byte order mark.
        html: the page; None for none.
        runs: the folder of pictures and recordings; None for none.
        quiet: write nothing to stdout.
    """

    csv: Path | None
    for_excel: bool
    html: Path | None
    runs: Path | None
    quiet: bool


@click.command(
    epilog=_EXAMPLES,
    short_help="Grade many programs in worlds with goals.",
    options_metavar="[OPTIONS]",
)
@click.argument("files", nargs=-1, required=True, metavar="SUBMISSIONS... WORLD.xml...")
@written_file("--csv", "Write a table, with a line for each submission and a column for each goal.")
@click.option(
    "--excel",
    is_flag=True,
    help="Start the table with a byte order mark, so that Excel detects UTF-8.",
)
@written_file("--html", "Write a page with the table, and a picture of each run.")
@written_folder("--runs", "Write a picture and a recording of each run to DIR.")
@click.option(
    "--seed",
    "seeds",
    type=click.IntRange(min=0),
    multiple=True,
    metavar="N",
    help="Random seed; may be repeated, for several runs in each world. Default: the world's.",
)
@click.option(
    "--allow",
    "allowed",
    multiple=True,
    metavar="FUNCTION",
    help="Allow a function that only the vendor's simulator has, such as place_robot.",
)
@program_options.READS
@click.option(
    "--data",
    multiple=True,
    metavar="PATTERN",
    help="Let a program read the files of its own submission whose names match, such as '*.txt'.",
)
@click.option(
    "--jobs",
    type=click.IntRange(1, 64),
    default=lambda: min(os.cpu_count() or 1, 64),
    metavar="N",
    help="Run N programs at a time. Default: the number of processors.",
)
@click.option(
    "--max-time",
    "max_time_s",
    type=click.FloatRange(min=0, min_open=True),
    metavar="S",
    help="Simulated time of a run. Default: the world's duration, else 120 s.",
)
@click.option(
    "--max-fuel",
    type=click.IntRange(min=1),
    default=2_000_000_000,
    show_default=True,
    metavar="N",
    help="Instructions that a program may execute.",
)
@click.option(
    "--max-output",
    type=click.IntRange(min=0),
    default=1_000_000,
    show_default=True,
    metavar="BYTES",
    help="Bytes that a program may print.",
)
@click.option(
    "--max-memory",
    type=click.IntRange(min=512),
    default=1024,
    show_default=True,
    metavar="MIB",
    help="Memory limit for compiling a program, on Linux: a last resort. A running program has "
    "16 MiB.",
)
@click.option(
    "--max-compile",
    "compile_s",
    type=click.FloatRange(min=1),
    default=60.0,
    show_default=True,
    metavar="S",
    help="Real-time limit for compiling: a last resort.",
)
@click.option(
    "--max-wall",
    "wall_s",
    type=click.FloatRange(min=1),
    default=300.0,
    show_default=True,
    metavar="S",
    help="Real-time limit of a run, excluding compilation: a last resort.",
)
@program_options.robot_options
@click.option("-q", "--quiet", is_flag=True, help="Do not write the grades to stdout.")
def grade(
    *, files: Sequence[str], csv: Path | None, excel: bool, html: Path | None, runs: Path | None,
    seeds: Sequence[int], allowed: tuple[str, ...], named_files: Sequence[str],
    data: tuple[str, ...], jobs: int, max_time_s: float | None, max_fuel: int, max_output: int,
    max_memory: int, compile_s: float, wall_s: float, quiet: bool, **robots: Any,
) -> int:  # fmt: skip
    """Run many programs in worlds with goals, and add up the points of the goals they meet.

    SUBMISSIONS are folders: each C file and each folder in one is a submission, a folder being one
    program of several files. C files can be named, too. Each submission runs in each world with
    each seed, in a process of its own, as the program of the robots for which the world names none.
    Links are not followed, and outside a submission, only files named by --file can be read.

    The same submissions get the same grades on every machine, unless a run exceeds a limit of real
    time, a last resort; the grade then says so. The exit status is 0 regardless of the grades.
    """
    from crs_cc.cli.grading.grading import Settings
    from crs_cc.cli.grading.job import Limits, Robots

    limits = Limits(max_time_s, max_fuel, max_output, max_memory * _MIB, compile_s, wall_s)
    _check_allowed(allowed)
    _check_once("--seed ", seeds)
    _check_once("", list(map(os.path.realpath, files)))
    worlds = [Path(name) for name in files if is_world(name)]
    if not worlds:
        raise click.UsageError("no world: name at least one .xml file with goals.")
    inputs, wanted = parse_named_files(named_files), Robots(**robots)
    if wanted.robot.endswith(".xml"):
        wanted = replace(wanted, robot=os.path.realpath(wanted.robot))
    cases = [
        case
        for each, name in zip(worlds, _world_names(worlds), strict=True)
        for case in _cases(each, name, seeds, wanted, several=len(worlds) > 1)
    ]
    submissions = _submissions([Path(name) for name in files if not is_world(name)])
    if excel and csv is None:
        raise click.UsageError("--excel requires --csv FILE.")
    for path in (csv, html):
        _check_target(path)
    if runs is not None:
        make_folder(runs)
    settings = Settings(jobs, allowed, limits, runs, wanted, inputs, data)
    grades = _grade_all(submissions, cases, settings, quiet=quiet)
    targets = _Targets(csv, excel, html, runs, quiet)
    _write(grades, " and ".join(world.name for world in worlds), targets)
    return 0


def _check_allowed(allowed: Sequence[str]) -> None:
    from crs_cc.cli.grading.refused_calls import REFUSED

    for name in allowed:
        if name not in REFUSED:
            raise click.UsageError(f"--allow: {unknown('function', name, REFUSED)}.")


def _check_once(option: str, values: Sequence[object]) -> None:
    """Refuse what would count twice."""
    for number, value in enumerate(values):
        if value in values[:number]:
            raise click.UsageError(f"{option}{value} is given twice.")


def _world_names(worlds: Sequence[Path]) -> list[str]:
    """Return a name for each world: that of its file, or its path where worlds have equal names.

    >>> _world_names([Path("easy/room.xml"), Path("hard/room.xml")])
    ['easy/room.xml', 'hard/room.xml']
    """
    stems = [path.stem for path in worlds]
    return stems if len(set(stems)) == len(stems) else list(map(str, worlds))


def _cases(
    path: Path, name: str, seeds: Sequence[int], robots: Robots, *, several: bool
) -> list[Case]:
    """Return a world with each seed.

    Args:
        path: the world file.
        name: the world's name.
        seeds: the seeds.
        robots: the kind of robots, where the world leaves it open.
        several: whether there are other worlds.

    Raises:
        WorldError: it is invalid, or there is nothing to grade in it.
        click.UsageError: the robot is unknown.
    """
    from crs_cc.cli.grading.grades import Case
    from crs_cc.cli.load import load_world_of

    options = ProgramOptions(Inputs((), path), **asdict(robots))
    world = load_world_of(options)
    if not world.goals:
        raise WorldError.at(
            Location(str(path)), "the world has no goals", "add <goal>, see docs/teaching.md"
        )
    if all(robot.program for robot in world.robots):
        text = "the world names a program for every robot, so that none is left to grade"
        raise WorldError.at(Location(str(path)), text)
    if len(seeds) < 2:
        return [Case(name, path, seeds[0] if seeds else None, world.goals)]
    prefix = f"{name} " if several else ""
    return [Case(f"{prefix}seed {seed}", path, seed, world.goals) for seed in seeds]


def _submissions(paths: Sequence[Path]) -> list[Submission]:
    from crs_cc.cli.grading.submissions import find

    try:
        found = find(paths)
    except OSError as error:
        raise click.UsageError(f"{error.filename}: {error.strerror}.") from None
    if not found:
        names = ", ".join(printable(str(path)) for path in paths)
        raise click.UsageError(f"no submissions{f' in {names}' if names else ': name a folder'}.")
    return found


def _check_target(path: Path | None) -> None:
    """Check, as far as possible without writing, that a result can be written."""
    if path is not None and not path.absolute().parent.is_dir():
        raise click.UsageError(f"cannot write '{path}': no such folder.")


def _grade_all(
    submissions: Sequence[Submission], cases: Sequence[Case], settings: Settings, *, quiet: bool
) -> list[Grade]:
    """Run everything, with a progress bar on a terminal."""
    from crs_cc.cli.grading.grading import grade_all

    if quiet or not is_terminal(sys.stderr):
        return grade_all(submissions, cases, settings, lambda: None)
    total = len(submissions) * len(cases)
    with click.progressbar(length=total, label="grading", file=sys.stderr) as bar:
        return grade_all(submissions, cases, settings, lambda: bar.update(1))


def _write(grades: Sequence[Grade], worlds: str, targets: _Targets) -> None:
    """Write the grades wherever they are wanted, and can be: what cannot does not cost the rest.

    Raises:
        OSError: a file cannot be written.
    """
    from crs_cc.cli.grading.page import as_page, link_to
    from crs_cc.cli.grading.tables import as_csv, as_lines

    texts: list[tuple[Path, str]] = []
    mark = _BYTE_ORDER_MARK if targets.for_excel else ""
    if targets.csv is not None:
        texts.append((targets.csv, mark + as_csv(grades)))
    if targets.html is not None:
        runs = None if targets.runs is None else link_to(targets.runs, targets.html)
        texts.append((targets.html, as_page(grades, f"Grades: {worlds}", runs)))
    failed: OSError | None = None
    for path, text in texts:
        try:
            path.write_text(text, "utf-8")
        except OSError as error:  # such as a table that is open in a spreadsheet
            failed = failed or error
    if not targets.quiet:
        for line in as_lines(grades):
            click.echo(line)
    if failed is not None:
        raise failed
