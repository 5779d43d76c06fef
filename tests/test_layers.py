"""Which part may import which: the order that ARCHITECTURE.md draws, held by reading the source.

A module may import its own package and those that stand in an earlier row. Some third-party
packages may be imported in one place only, so that they can be replaced there. Imports for typing
and inside functions count as any other.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Callable, Iterator
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path
from typing import TypeAlias

import pytest

Imports: TypeAlias = list[tuple[int, str]]

PACKAGE = Path(__file__).parents[1] / "crs_cc"
MAX_LINES = 500

ROWS: tuple[frozenset[str], ...] = tuple(
    frozenset(row.split())
    for row in (
        "core",
        "requests robot_api",
        "ir",
        "frontend runtime",
        "toolchain",
        "sim",
        "session plot",
        "recording builder jobs",
        "debug",
        "net workbench",
        "api",
        "sweeps",
        "cli",
        "__main__",
    )
)
RANK = {part: rank for rank, row in enumerate(ROWS) for part in row}
COMPILES = "crs_cc.sim.kernels."
"""The only part of the simulation that may import those that compile and run C programs."""
MEET = {"requests", "robot_api"}  # their files may use each other

INSIDE = {
    "frontend": [
        *("error_limit", "other_language_hint", "preprocess", "parse", "check", "lower", "warn"),
        *("body", "dialect", "unit", "expression"),
    ],
    "sim": [
        *("kernels", "model", "geometry", "files", "state"),
        *("physics", "devices", "comms", "engine"),
    ],
}
"""Packages whose own parts have an order: each may import itself and those before it."""

CONFINED = {
    "pycparser": ("frontend/",),
    "wasmtime": ("runtime/",),
    "pymunk": ("sim/physics/",),
    "zstandard": (
        "recording/mcap_reader.py",
        "recording/mcap_writer.py",
        "session/snapshot_file.py",
    ),
    "PIL": ("sim/files/image.py", "plot/raster.py"),
    "lxml": ("sim/files/xml_document.py", "sim/files/device_schema.py", "plot/svg.py"),
    "pyarrow": ("cli/columnar.py",),
    "gymnasium": ("api/gym_env.py", "api/spaces.py"),
    "pettingzoo": ("api/parallel_env.py",),
    "rich": ("cli/", "debug/"),
    "click": ("cli/",),
    "distributed": ("jobs/cluster.py",),
    "optuna": ("sweeps/search.py",),
    "cmaes": ("sweeps/search.py",),
    "pandas": ("sweeps/table.py",),
    "polars": ("sweeps/table.py",),
    "scipy": ("sweeps/report/",),
    "matplotlib": ("sweeps/report/figures.py",),
    "textual": ("debug/tui/",),
    "websockets": ("workbench/server.py",),
}
ANYWHERE = {"numpy"}


def modules() -> list[Path]:
    return sorted(PACKAGE.rglob("*.py"))


def name_of(path: Path) -> str:
    parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def statements(tree: ast.AST) -> Iterator[ast.AST]:
    """Yield all statements; unlike `ast.walk`, it does not look into expressions."""
    for field in ("body", "handlers", "cases", "orelse", "finalbody"):
        for each in getattr(tree, field, ()):
            yield each
            yield from statements(each)


def imports_in(text: str) -> Imports:
    """Return line and full name of everything imported, of `from a import b` both a and a.b."""
    found = []
    for node in statements(ast.parse(text)):
        if isinstance(node, ast.Import):
            found += [(node.lineno, alias.name) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"line {node.lineno}: relative import"
            assert node.module
            found.append((node.lineno, node.module))
            found += [(node.lineno, f"{node.module}.{alias.name}") for alias in node.names]
    return found


@cache
def imports_of(path: Path) -> Imports:
    """Return the imports of a file; its tree, which is a thousand times as large, is not kept."""
    return imports_in(path.read_text())


def part_of(name: str) -> str:
    """Return the part of the product that a module belongs to: `ir` for `crs_cc.ir.text`."""
    return name.split(".")[1] if "." in name else ""


def wrong_layer(importer: str, imported: str) -> bool:
    mine, theirs = part_of(importer), part_of(imported)
    if mine == theirs and mine in INSIDE:
        return wrong_inside(INSIDE[mine], importer.split("."), imported.split("."))
    if mine == theirs or not mine or theirs not in RANK:
        return False  # its own package, the package itself, or a name in crs_cc/__init__.py
    if mine == "sim" and RANK["frontend"] <= RANK[theirs] < RANK["sim"]:
        return not importer.startswith(COMPILES)
    return RANK[theirs] >= RANK[mine] and not (mine in MEET and theirs in MEET)


def wrong_inside(order: list[str], importer: list[str], imported: list[str]) -> bool:
    """Return whether an import inside a package goes against the order of its packages."""
    if len(importer) < 3 or len(imported) < 3:
        return False
    mine, theirs = importer[2], imported[2]
    return mine not in order or theirs not in order or order.index(theirs) > order.index(mine)


def layer_faults(path: Path, imports: Imports) -> Iterator[str]:
    name = name_of(path)
    if part_of(name) and part_of(name) not in RANK:
        yield f"{path}: {name} is in no row of the import order"
        return
    for line, imported in imports:
        if imported.split(".")[0] == "crs_cc" and wrong_layer(name, imported):
            yield f"{path}:{line}: {name} imports {imported}"


def third_party_faults(path: Path, imports: Imports) -> Iterator[str]:
    inside = path.relative_to(PACKAGE).as_posix()
    for line, imported in imports:
        package = imported.split(".")[0]
        if package in {"crs_cc", *sys.stdlib_module_names, *ANYWHERE}:
            continue
        if package not in CONFINED:
            yield f"{path}:{line}: {package} is no dependency"
        elif not inside.startswith(CONFINED[package]):
            yield f"{path}:{line}: {package} does not belong here"


def faults(find: Callable[[Path, Imports], Iterator[str]]) -> str:
    """Return what is wrong with all modules, one line for each fault."""
    return "\n".join(fault for path in modules() for fault in find(path, imports_of(path)))


def test_modules_import_only_earlier_layers() -> None:
    assert faults(layer_faults) == ""


def test_third_party_packages_stay_where_they_belong() -> None:
    assert faults(third_party_faults) == ""


def test_there_are_no_import_cycles() -> None:
    paths = {name_of(path): path for path in modules() if path.name != "__init__.py"}
    graph = {
        name: {imported for _, imported in imports_of(path) if imported in paths} - {name}
        for name, path in paths.items()
    }
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(f"import cycle: {' -> '.join(error.args[1])}")


def test_files_are_short_enough_to_be_read() -> None:
    lengths = {path: len(path.read_text().splitlines()) for path in modules()}
    long = [f"{path}: {count} lines" for path, count in lengths.items() if count > MAX_LINES]
    assert not long, "\n".join(long)


def test_the_rules_can_fail() -> None:
    source = "def f():\n    from crs_cc.runtime import link\nimport wasmtime\n"
    found = {name for _, name in imports_in(source)}
    assert found == {"crs_cc.runtime", "crs_cc.runtime.link", "wasmtime"}
    assert wrong_layer("crs_cc.frontend.parse", "crs_cc.runtime.link")
    assert wrong_layer("crs_cc.ir.text", "crs_cc.cli.main")
    assert not wrong_layer("crs_cc.cli.run", "crs_cc.session.session")
    assert not wrong_layer("crs_cc.core.errors", "crs_cc.core.source")
    assert wrong_layer("crs_cc.sim.state.drive", "crs_cc.sim.devices.drive")
    assert wrong_layer("crs_cc.sim.state.drive", "crs_cc.runtime.fleet")
    assert not wrong_layer("crs_cc.sim.kernels.program", "crs_cc.toolchain.kernels")
    assert not wrong_layer("crs_cc.sim.devices.drive", "crs_cc.sim.state.drive")
    misplaced = imports_in("import lxml\nimport requests\nfrom crs_cc.cli import main\n")
    path = PACKAGE / "ir" / "text.py"
    assert list(third_party_faults(path, misplaced)) == [
        f"{path}:1: lxml does not belong here", f"{path}:2: requests is no dependency"
    ]  # fmt: skip
    assert [fault.rpartition(" ")[2] for fault in layer_faults(path, misplaced)] == [
        "crs_cc.cli", "crs_cc.cli.main"
    ]  # fmt: skip
    lost = PACKAGE / "elsewhere" / "module.py"
    assert "in no row" in next(layer_faults(lost, misplaced))
    assert wrong_layer("crs_cc.frontend.check.checker", "crs_cc.frontend.unit")
