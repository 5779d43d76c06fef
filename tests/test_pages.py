"""The generated pages of `docs/` are those of their templates and of the code.

`--update-goldens` rewrites them, as `make docs` does.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest

from crs_cc.cli.main import COMMANDS
from docs.generate import DOCS, ROOT, fill, man, page_names, page_path, page_text
from docs.generate.editors import EXTENSION, extension_text

TEXTS = [
    *sorted(ROOT.glob("*.md")),
    ROOT / "samples" / "README.md",
    *sorted(DOCS.glob("*.md")),
    *sorted((DOCS / "adr").glob("*.md")),
]
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)
LINK = re.compile(r"\]\(\s*([^)#\s]*)(?:#([^)\s]+))?\)")


@pytest.mark.parametrize("name", page_names())
def test_generated_page_is_up_to_date(
    name: str, check_golden: Callable[[Path, bytes], None]
) -> None:
    check_golden(page_path(name), page_text(name).encode())


def test_extension_manifest_is_up_to_date(check_golden: Callable[[Path, bytes], None]) -> None:
    check_golden(EXTENSION, extension_text().encode())


@pytest.mark.parametrize("name", man.pages())
def test_man_page_is_up_to_date(name: str, check_golden: Callable[[Path, bytes], None]) -> None:
    check_golden(man.MAN / name, man.pages()[name].encode())


def test_there_is_a_man_page_for_each_command_and_no_other() -> None:
    assert {path.name for path in man.MAN.iterdir()} == man.pages().keys()
    assert {f"crs-{name}.1" for name in COMMANDS} < man.pages().keys()


def test_the_index_by_task_names_every_page() -> None:
    named = {Path(name).name for name, _ in LINK.findall((DOCS / "README.md").read_text())}
    assert {path.name for path in DOCS.glob("*.md")} - {"README.md"} <= named


def test_unknown_placeholder_is_an_error() -> None:
    with pytest.raises(KeyError):
        fill("{{nonsense}}", {})


def anchors(path: Path) -> set[str]:
    """Return the anchors that GitHub makes of a page's headings."""
    text = re.sub(r"```.*?```", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
    titles = (re.sub(r"[^\w\- ]", "", title.lower()) for title in HEADING.findall(text))
    return {title.replace(" ", "-") for title in titles}


@pytest.mark.parametrize("page", TEXTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_every_link_leads_to_a_file_and_a_heading(page: Path) -> None:
    text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    for name, anchor in LINK.findall(re.sub(r"`[^`\n]*`", "", text)):
        if name.startswith("http"):
            continue
        target = page.parent / name if name else page
        assert target.exists(), name
        if anchor:
            assert anchor in anchors(target), f"{name}#{anchor}"
