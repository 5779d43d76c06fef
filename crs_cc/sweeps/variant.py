"""From parameters to a world and the programs of its robots.

Files are found from the current directory, which is the folder of the experiment: so messages,
`__FILE__` and state hashes do not depend on where that is.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Final

from crs_cc.builder.changes import path_of, schema_of
from crs_cc.builder.world_builder import WorldBuilder
from crs_cc.core.errors import CompileError
from crs_cc.core.input_files import logged, note
from crs_cc.core.source import Diagnostics, Location
from crs_cc.core.suggest import unknown
from crs_cc.session.build import build_executable
from crs_cc.session.host import CLIENTS
from crs_cc.sim.files.known_robots import ROBOTS, known_robots
from crs_cc.sim.files.schema_properties import properties
from crs_cc.sim.files.world_xml import load_world
from crs_cc.sweeps.experiment import Experiment, ExperimentError, Value
from crs_cc.sweeps.targets import place_of
from crs_cc.toolchain.fingerprint import PACKAGE

if TYPE_CHECKING:
    from crs_cc.frontend.preprocess.options import Dialect
    from crs_cc.runtime.executable import Executable
    from crs_cc.sim.model.world import Robot, WorldModel
    from crs_cc.sweeps.plan import Parameters

_ATTRIBUTE: Final = re.compile(r"([\w-]+)=(\S+)")
_LINKS: Final = ("serial", "ideal")


@dataclass(frozen=True, slots=True)
class Variant:
    """The world and programs of a combination of parameters.

    Attributes:
        parameters: the combination.
        world: the world.
        executables: each robot's program.
        arguments: of programs that the world does not name.
        defines: the macros of the program.
        robot: the kind of robots for which the world names none.
        setup: the setup of all robots.
        link: `serial` or `ideal`.
        client: the client library.
        files: what it was loaded from, without our own files; the world's file as it is after the
            changes.
    """

    parameters: Parameters
    world: WorldModel
    executables: tuple[Executable, ...]
    arguments: tuple[str, ...]
    defines: tuple[str, ...]
    robot: str
    setup: str
    link: str
    client: str
    files: Mapping[Path, bytes]


class VariantLoader:
    """Loads the variants of an experiment; programs are compiled once for all that share them."""

    def __init__(self, experiment: Experiment, folder: Path) -> None:
        """Set the parameters.

        Args:
            experiment: the experiment.
            folder: for robot definitions that are varied.
        """
        self._experiment, self._folder = experiment, folder
        self._compiled: dict[object, tuple[Executable, dict[Path, bytes]]] = {}

    @cached_property
    def scatters(self) -> bool:
        """Whether the world depends on the seed, as it scatters robots or objects."""
        root = WorldBuilder(self._experiment.world).document.root
        return any(each.tag == "scatter" for each in root.children)

    def load(self, parameters: Parameters, seed: int | None = None) -> Variant:
        """Return the variant of a combination of parameters, and of a seed if the world scatters.

        Raises:
            ExperimentError: a parameter is invalid.
            WorldError: the world is.
            CompileError: a program is.
        """
        experiment = self._experiment

        def chosen(name: str, usual: str, known: Sequence[str]) -> str:
            value = str(parameters.get(name, usual))
            if name in parameters and value not in known:
                raise self._error(unknown(name, value, known))
            return value

        setup = str(parameters.get("setup", experiment.setup))
        robot = self._robot(parameters)
        link = chosen("link", experiment.link, _LINKS)
        client = chosen("client", experiment.client, CLIENTS)
        with logged() as files:
            text = self._world_text(parameters)
            note(experiment.world, text)
            world = load_world(experiment.world, setup, robot, text, seed)
        if link == "ideal":
            world = world.with_ideal_link()
        self._check_robot(parameters, world, robot)
        defines = self._defines(parameters)
        found = [self._executable(each, defines) for each in world.robots]
        for _, read in found:
            files |= read
        return Variant(
            parameters,
            world,
            tuple(executable for executable, _ in found),
            self._arguments(parameters),
            defines,
            robot,
            setup,
            link,
            client,
            {path: content for path, content in files.items() if not _is_bundled(path)},
        )

    def _error(self, text: str, hint: str = "") -> ExperimentError:
        return ExperimentError.at(Location(str(self._experiment.path)), text, hint)

    # -- the world -------------------------------------------------------------------------------

    def _world_text(self, parameters: Parameters) -> bytes:
        """Return the text of the world file with all changes."""
        builder = WorldBuilder(self._experiment.world)
        if "robots" in parameters:
            self._keep_robots(builder, parameters["robots"])
        self._change(builder, "world", parameters)
        for fault in str(parameters.get("fault", "")).split(";"):
            if fault.strip():
                self._add_fault(builder, fault)
        return builder.document.text

    def _keep_robots(self, builder: WorldBuilder, count: Value) -> None:
        names = builder.names("robot")
        if not isinstance(count, int) or not 1 <= count <= len(names):
            text = f"robots = {count!r}: expected a whole number from 1 to {len(names)}"
            raise self._error(text, f"{self._experiment.world.name} has {len(names)} robots")
        if names[count:]:
            builder.remove(names[count:])

    def _change(self, builder: WorldBuilder, kind: str, parameters: Parameters) -> None:
        """Change attributes in a world file or a robot definition."""
        for name, value in parameters.items():
            if not name.startswith(f"{kind}."):
                continue
            element, attribute = place_of(name)
            shown = str(value).lower() if isinstance(value, bool) else str(value)
            try:
                tags = path_of(builder.element(element))
            except ValueError as error:
                raise self._error(f"{name}: {error}") from None
            known = [row.name for row in properties(schema_of(builder.document), tags)]
            if attribute not in known:
                raise self._error(f"{name}: {unknown('attribute', attribute, known)}")
            try:
                builder.set(element, {attribute: shown})
            except ValueError as error:
                raise self._error(f"{name}: {error}") from None

    def _add_fault(self, builder: WorldBuilder, fault: str) -> None:
        words = fault.split()
        found = [_ATTRIBUTE.fullmatch(word) for word in words]
        if not all(found):
            word = next(word for word, each in zip(words, found, strict=True) if not each)
            text = f"fault: {word!r} is not NAME=VALUE, such as device=sonar"
            raise self._error(text, "see docs/degradation.md")
        builder.add("degradation", {each[1]: each[2] for each in found if each})

    # -- the robot -------------------------------------------------------------------------------

    def _robot(self, parameters: Parameters) -> str:
        """Return the kind of robot, or the file of its changed definition."""
        robot = str(parameters.get("robot", self._experiment.robot))
        if robot not in known_robots() and not robot.endswith(".xml"):
            raise self._error(unknown("robot", robot, known_robots()))
        if robot.endswith(".xml"):
            robot = str(Path(robot))
        changes = {name: each for name, each in parameters.items() if name.startswith("robot.")}
        if not changes:
            return robot
        path = Path(robot) if robot.endswith(".xml") else ROBOTS / f"{robot}.xml"
        builder = WorldBuilder(path)
        self._change(builder, "robot", changes)
        text = builder.document.text
        changed = self._folder / f"{path.stem}-{hashlib.sha256(text).hexdigest()[:16]}.xml"
        if not changed.exists():
            self._folder.mkdir(parents=True, exist_ok=True)
            changed.write_bytes(text)
        return str(changed)

    def _check_robot(self, parameters: Parameters, world: WorldModel, robot: str) -> None:
        """Refuse to vary a definition that no robot has."""
        names = [name for name in parameters if name == "robot" or name.startswith("robot.")]
        if names and not any(each.model.definition == robot for each in world.robots):
            text = f"{names[0]}: the world names another definition for every robot"
            raise self._error(
                text, f"vary it in the world, as world.{world.robots[0].id}.definition"
            )

    # -- programs --------------------------------------------------------------------------------

    def _defines(self, parameters: Parameters) -> tuple[str, ...]:
        macros = {name.partition(".")[2]: each for name, each in parameters.items()
                  if name.startswith("define.")}  # fmt: skip
        return (
            *(each for each in self._experiment.defines if each.partition("=")[0] not in macros),
            *(f"{name}={_in_c(value)}" for name, value in macros.items()),
        )

    def _arguments(self, parameters: Parameters) -> tuple[str, ...]:
        found = list(self._experiment.arguments)
        for name, value in sorted(_numbered(parameters)):
            if name > len(found) + 1:
                text = f"argument.{name}: there is no argument {len(found) + 1} before it"
                raise self._error(text, "give the arguments before it in 'arguments'")
            found[name - 1 : name] = [str(value)]
        return tuple(found)

    def _executable(
        self, robot: Robot, defines: tuple[str, ...]
    ) -> tuple[Executable, dict[Path, bytes]]:
        """Return the program of a robot, and the files that it was compiled from."""
        sources = (Path(robot.program),) if robot.program else self._experiment.programs
        if not sources:
            world = self._experiment.world.name
            raise self._error(f"no program for '{robot.id}'", f"name 'programs': {world} has none")
        key = sources, robot.dialect, defines
        if key not in self._compiled:
            self._compiled[key] = self._build(sources, robot.dialect, defines)
        return self._compiled[key]

    def _build(
        self, sources: tuple[Path, ...], dialect: Dialect | None, defines: tuple[str, ...]
    ) -> tuple[Executable, dict[Path, bytes]]:
        diagnostics = Diagnostics()
        for path in sources:
            if not path.is_file():
                raise CompileError.at(Location(str(path)), "no such file")
        executable = build_executable(
            sources,
            diagnostics,
            include_paths=self._experiment.include_paths,
            defines=defines,
            dialect=dialect,
        )
        files = [path for path in map(Path, diagnostics.digests) if not _is_bundled(path)]
        return executable, {path: path.read_bytes() for path in files if path.is_file()}


def unused_macros(parameters: Parameters, variant: Variant) -> Iterator[str]:
    """Yield the macros among parameters that no C file names: varying them changes nothing."""
    sources = b"\n".join(
        content for path, content in variant.files.items() if path.suffix not in (".xml", ".png")
    )
    for name in parameters:
        kind, _, macro = name.partition(".")
        if kind == "define" and not re.search(rb"\b" + macro.encode() + rb"\b", sources):
            yield macro


def _numbered(parameters: Parameters) -> Iterator[tuple[int, Value]]:
    for name, value in parameters.items():
        kind, _, number = name.partition(".")
        if kind == "argument":
            yield int(number), value


def _in_c(value: Value) -> str:
    return str(int(value)) if isinstance(value, bool) else str(value)


def _is_bundled(path: Path) -> bool:
    return path.is_absolute() and path.is_relative_to(PACKAGE)
