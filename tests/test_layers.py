"""Which part may import which: the order that ARCHITECTURE.md draws, held by reading the source.

A module may import its own package and those that stand in an earlier row. Some third-party
packages may be imported in one place only, so that they can be replaced there.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "crs_cc"
MAX_LINES = 500

ROWS: tuple[frozenset[str], ...] = tuple(
    frozenset(row.split())
    for row in (
        "core",
        "requests robot_api",
        "ir",
        "frontend runtime sim",
        "session",
        "record debug",
        "net workbench sweep",
        "api",
        "cli",
        "__main__",
    )
)
RANK = {part: rank for rank, row in enumerate(ROWS) for part in row}
MEET = {"requests", "robot_api"}  # their files may use each other

INSIDE = {
    "frontend": [
        *("error_limit", "other_language_hint", "preprocess", "parse", "check", "lower", "warn"),
        *("body", "dialect", "unit", "expression"),
    ],
    "sim": [
        *("model", "geometry", "files", "state", "kernels"),
        *("physics", "devices", "comms", "engine"),
    ],
}
"""Packages whose own packages and modules have an order, each before those that may import it."""

CONFINED = {
    "pycparser": ("frontend/",),
    "wasmtime": ("runtime/",),
    "pymunk": ("sim/physics/",),
    "PIL": ("sim/files/image.py",),
    "lxml": ("sim/files/xml_document.py", "cli/svg.py"),
    "rich": ("cli/", "debug/"),
    "click": ("cli/",),
    "textual": ("debug/tui/",),
}
ANYWHERE = {"numpy"}


def modules() -> list[Path]:
    return sorted(PACKAGE.rglob("*.py"))


def name_of(path: Path) -> str:
    parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imports(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Yield line and full name of everything imported, of `from a import b` both a and a.b."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((node.lineno, alias.name) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"line {node.lineno}: relative import"
            assert node.module
            yield node.lineno, node.module
            yield from ((node.lineno, f"{node.module}.{alias.name}") for alias in node.names)


def part_of(name: str) -> str:
    """Gives the part of the product that a module belongs to: `ir` for `crs_cc.ir.text`."""
    return name.split(".")[1] if "." in name else ""


def wrong_layer(importer: str, imported: str) -> bool:
    mine, theirs = part_of(importer), part_of(imported)
    if mine == theirs and mine in INSIDE:
        return wrong_inside(INSIDE[mine], importer.split("."), imported.split("."))
    if mine == theirs or not mine or theirs not in RANK:
        return False  # its own package, the package itself, or a name in crs_cc/__init__.py
    return RANK[theirs] >= RANK[mine] and not (mine in MEET and theirs in MEET)


def wrong_inside(order: list[str], importer: list[str], imported: list[str]) -> bool:
    """Return whether an import inside a package goes against the order of its packages."""
    if len(importer) < 3 or len(imported) < 3:
        return False
    mine, theirs = importer[2], imported[2]
    return mine not in order or theirs not in order or order.index(theirs) > order.index(mine)


@pytest.mark.parametrize("path", modules(), ids=name_of)
def test_a_module_imports_only_what_stands_before_it(path: Path) -> None:
    name = name_of(path)
    assert part_of(name) in RANK or not part_of(name), f"{name} is in no row of the import order"
    for line, imported in imports(ast.parse(path.read_text())):
        if imported.split(".")[0] == "crs_cc":
            assert not wrong_layer(name, imported), f"{path}:{line}: {name} imports {imported}"


@pytest.mark.parametrize("path", modules(), ids=name_of)
def test_third_party_packages_stay_where_they_belong(path: Path) -> None:
    inside = path.relative_to(PACKAGE).as_posix()
    for line, imported in imports(ast.parse(path.read_text())):
        package = imported.split(".")[0]
        if package in {"crs_cc", *sys.stdlib_module_names, *ANYWHERE}:
            continue
        assert package in CONFINED, f"{path}:{line}: {package} is no dependency"
        assert inside.startswith(CONFINED[package]), (
            f"{path}:{line}: {package} does not belong here"
        )


def import_graph(paths: list[Path]) -> dict[str, set[str]]:
    """Return for each of these modules those of them that it imports, in whatever way."""
    names = {name_of(path) for path in paths if path.name != "__init__.py"}
    return {
        name_of(path): {
            imported
            for _, imported in imports(ast.parse(path.read_text()))
            if imported in names and imported != name_of(path)
        }
        for path in paths
        if name_of(path) in names
    }


KNOWN_CYCLES = ("crs_cc.frontend.", "crs_cc.debug.", "crs_cc.ir.", "crs_cc.cli.")


def test_no_modules_import_each_other_in_a_circle() -> None:
    """Imports for types and inside functions count, too."""
    graph = import_graph(modules())
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(f"import cycle: {' -> '.join(error.args[1])}")


@pytest.mark.parametrize("path", modules(), ids=name_of)
def test_a_file_is_short_enough_to_be_read(path: Path) -> None:
    assert len(path.read_text().splitlines()) <= MAX_LINES


def test_the_rules_can_fail() -> None:
    tree = ast.parse("def f():\n    from crs_cc.runtime import link\nimport wasmtime\n")
    found = [name for _, name in imports(tree)]
    assert sorted(found) == ["crs_cc.runtime", "crs_cc.runtime.link", "wasmtime"]
    assert wrong_layer("crs_cc.frontend.parse.parser", "crs_cc.runtime.link")
    assert wrong_layer("crs_cc.ir.text", "crs_cc.cli.main")
    assert not wrong_layer("crs_cc.cli.run", "crs_cc.session.session")
    assert not wrong_layer("crs_cc.core.errors", "crs_cc.core.source")
    assert wrong_layer("crs_cc.sim.state.drive", "crs_cc.sim.devices.drive")
    assert not wrong_layer("crs_cc.sim.devices.drive", "crs_cc.sim.state.drive")
    assert wrong_layer("crs_cc.frontend.check.checker", "crs_cc.frontend.unit")
