"""Which part may import which: the order that ARCHITECTURE.md draws, held by reading the source.

A module may import its own package and those that stand in an earlier row. Some third-party
packages may be imported in one place only, so that they can be replaced there.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Callable, Iterator
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[1] / "crs_cc"
MAX_LINES = 500

ROWS: tuple[frozenset[str], ...] = tuple(
    frozenset(row.split())
    for row in (
        "errors garbage source units requests robot_api",
        "ir",
        "frontend runtime sim",
        "session",
        "record debug",
        "net viewer sweep",
        "cli",
        "__main__",
    )
)
RANK = {part: rank for rank, row in enumerate(ROWS) for part in row}
MEET = ROWS[0]  # their files may use each other

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


@cache
def parsed(path: Path) -> ast.AST:
    return ast.parse(path.read_text())


def name_of(path: Path) -> str:
    parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imports(tree: ast.AST, *, only_at_import: bool = False) -> Iterator[tuple[int, str]]:
    """Gives line and full name of everything imported, of `from a import b` both a and a.b."""
    for node in ast.iter_child_nodes(tree):
        if only_at_import and isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.If):
            if isinstance(node, ast.If) and "TYPE_CHECKING" not in ast.unparse(node.test):
                yield from imports(node, only_at_import=True)
        elif isinstance(node, ast.Import):
            yield from ((node.lineno, alias.name) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"line {node.lineno}: relative import"
            assert node.module
            yield node.lineno, node.module
            yield from ((node.lineno, f"{node.module}.{alias.name}") for alias in node.names)
        else:
            yield from imports(node, only_at_import=only_at_import)


def part_of(name: str) -> str:
    """Gives the part of the product that a module belongs to: `ir` for `crs_cc.ir.text`."""
    return name.split(".")[1] if "." in name else ""


def wrong_layer(importer: str, imported: str) -> bool:
    mine, theirs = part_of(importer), part_of(imported)
    if mine == theirs or not mine or theirs not in RANK:
        return False  # its own package, the package itself, or a name in crs_cc/__init__.py
    return RANK[theirs] >= RANK[mine] and not (mine in MEET and theirs in MEET)


def layer_faults(path: Path, tree: ast.AST) -> Iterator[str]:
    name = name_of(path)
    if part_of(name) and part_of(name) not in RANK:
        yield f"{path}: {name} is in no row of the import order"
        return
    for line, imported in imports(tree):
        if imported.split(".")[0] == "crs_cc" and wrong_layer(name, imported):
            yield f"{path}:{line}: {name} imports {imported}"


def third_party_faults(path: Path, tree: ast.AST) -> Iterator[str]:
    inside = path.relative_to(PACKAGE).as_posix()
    for line, imported in imports(tree):
        package = imported.split(".")[0]
        if package in {"crs_cc", *sys.stdlib_module_names, *ANYWHERE}:
            continue
        if package not in CONFINED:
            yield f"{path}:{line}: {package} is no dependency"
        elif not inside.startswith(CONFINED[package]):
            yield f"{path}:{line}: {package} does not belong here"


def faults(find: Callable[[Path, ast.AST], Iterator[str]]) -> str:
    """Return what is wrong with all modules, one line for each fault."""
    return "\n".join(fault for path in modules() for fault in find(path, parsed(path)))


def test_modules_import_only_what_stands_before_them() -> None:
    assert faults(layer_faults) == ""


def test_third_party_packages_stay_where_they_belong() -> None:
    assert faults(third_party_faults) == ""


def import_graph(paths: list[Path], *, only_at_import: bool) -> dict[str, set[str]]:
    """Gives for each of these modules those of them that it imports."""
    names = {name_of(path) for path in paths if path.name != "__init__.py"}
    return {
        name_of(path): {
            imported
            for _, imported in imports(parsed(path), only_at_import=only_at_import)
            if imported in names and imported != name_of(path)
        }
        for path in paths
        if name_of(path) in names
    }


def hold_no_circle(graph: dict[str, set[str]]) -> None:
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(f"import cycle: {' -> '.join(error.args[1])}")


def test_no_modules_import_each_other_in_a_circle() -> None:
    hold_no_circle(import_graph(modules(), only_at_import=True))


@pytest.mark.parametrize("package", ["runtime", "sim", "session"])
def test_nothing_in_a_package_needs_itself_by_a_late_import_or_for_its_types(package: str) -> None:
    paths = sorted((PACKAGE / package).rglob("*.py"))
    hold_no_circle(import_graph(paths, only_at_import=False))


def test_files_are_short_enough_to_be_read() -> None:
    lengths = {path: len(path.read_text().splitlines()) for path in modules()}
    long = [f"{path}: {count} lines" for path, count in lengths.items() if count > MAX_LINES]
    assert not long, "\n".join(long)


def test_the_rules_can_fail() -> None:
    tree = ast.parse("def f():\n    from crs_cc.runtime import link\nimport wasmtime\n")
    found = [name for _, name in imports(tree)]
    assert found == ["crs_cc.runtime", "crs_cc.runtime.link", "wasmtime"]
    assert [name for _, name in imports(tree, only_at_import=True)] == ["wasmtime"]
    assert wrong_layer("crs_cc.frontend.parse", "crs_cc.runtime.link")
    assert wrong_layer("crs_cc.ir.text", "crs_cc.cli.main")
    assert not wrong_layer("crs_cc.cli.run", "crs_cc.session.session")
    assert not wrong_layer("crs_cc.errors", "crs_cc.source")
    misplaced = ast.parse("import lxml\nimport requests\nfrom crs_cc.cli import main\n")
    path = PACKAGE / "ir" / "text.py"
    assert list(third_party_faults(path, misplaced)) == [
        f"{path}:1: lxml does not belong here", f"{path}:2: requests is no dependency"
    ]  # fmt: skip
    assert [fault.rpartition(" ")[2] for fault in layer_faults(path, misplaced)] == [
        "crs_cc.cli", "crs_cc.cli.main"
    ]  # fmt: skip
    lost = PACKAGE / "elsewhere" / "module.py"
    assert "in no row" in next(layer_faults(lost, misplaced))
