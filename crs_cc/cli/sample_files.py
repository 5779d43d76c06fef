"""The sample programs and worlds of crs, and which of them belong together.

A sample is a file, or a folder whose files belong together. A sample that is a file brings those
that it names: a world its pictures and robot definitions, a program the files that it reads.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from crs_cc.core.shared_files import shared_folder

_MAIN: Final = (".c", ".py")
"""Endings of samples that are one file."""

_COMMENT: Final = {
    ".c": re.compile(r"/\*(.*?)\*/", re.DOTALL),
    ".xml": re.compile(r"<!--(.*?)-->", re.DOTALL),
    ".py": re.compile(r'"""(.*?)"""', re.DOTALL),
    ".md": re.compile(r"\n\n(.*?)\n\n", re.DOTALL),
}
_OWN_NAME: Final = re.compile(r"^[\w.]+ - ")
_SENTENCE: Final = re.compile(r"(.*?)(?:[.;?] |\.?$)")
_FILE_NAME: Final = re.compile(r"[\w-]+(?:/[\w-]+)*\.\w+")


@dataclass(frozen=True, slots=True)
class Sample:
    """One sample.

    Attributes:
        name: its name, that of the file or folder.
        group: what it is one of: `scout_c`, `worlds`.
        path: the file or folder.
    """

    name: str
    group: str
    path: Path

    def summary(self) -> str:
        """Return its description: one sentence from its first comment."""
        source = _described_by(self.path) if self.path.is_dir() else self.path
        return first_sentence(source.read_text("utf-8"), source.suffix)

    def files(self) -> list[tuple[Path, Path]]:
        """Return the files to copy: where each is, and its path below the target folder."""
        if self.path.is_dir():
            inside = (each for each in sorted(self.path.rglob("*")) if each.is_file())
            top = self.path.parent
            return [(each, each.relative_to(top)) for each in inside if each.suffix != ".pyc"]
        samples = {each.path for each in all_samples()}
        found = [self.path]
        for file in found:  # grows
            named = (each for each in _named_in(file) if each not in samples)
            found += [each for each in dict.fromkeys(named) if each not in found]
        return [(each, _below(self.path.parent, each)) for each in found]


def all_samples() -> list[Sample]:
    """Return all samples, programs first."""
    groups = (each for each in sorted(shared_folder("samples").iterdir()) if each.is_dir())
    programs = [sample for group in groups for sample in _in_folder(group, group.name)]
    tutorial = Sample("tutorial", "tutorial", shared_folder("docs") / "tutorial")
    worlds = sorted(shared_folder("worlds").glob("*.xml"))
    return [*programs, tutorial, *(Sample(each.name, "worlds", each) for each in worlds)]


def other_files() -> list[Sample]:
    """Return the files that are no samples of their own, such as those that programs read."""
    known = {each.path for each in all_samples()}
    top = (shared_folder("samples"), shared_folder("worlds"))
    found = (file for folder in top for file in sorted(folder.rglob("*")) if file.is_file())
    return [Sample(each.name, each.parent.name, each) for each in found if each not in known]


def first_sentence(text: str, ending: str) -> str:
    r"""Return the first sentence of a file's first comment, without the file's name.

    >>> first_sentence("/*\n * a.c - drives\n * on. Then it stops.\n */", ".c")
    'Drives on'
    """
    comment = _COMMENT[ending].search(text)
    words = " ".join(comment[1].replace("*", " ").split()) if comment else ""
    sentence = _SENTENCE.match(_OWN_NAME.sub("", words))
    return sentence[1][:1].upper() + sentence[1][1:] if sentence else ""


def _in_folder(folder: Path, group: str) -> Iterator[Sample]:
    for each in sorted(folder.iterdir()):
        if each.is_dir() and any(file.is_file() for file in each.iterdir()):
            if any(file.suffix in _COMMENT for file in each.iterdir()):  # no results, no caches
                yield Sample(each.name, group, each)
        elif each.is_dir():
            yield from _in_folder(each, group)
        elif each.suffix in _MAIN:
            yield Sample(each.name, group, each)


def _described_by(folder: Path) -> Path:
    """Return the file that describes a folder best."""
    for name in ("README.md", f"{folder.name}.c", f"{folder.name}.xml", "main.c"):
        if (folder / name).is_file():
            return folder / name
    return min(each for each in folder.iterdir() if each.suffix in _COMMENT)


def _named_in(file: Path) -> Iterator[Path]:
    """Yield the files that a file names, beside it or in the folder of worlds."""
    if file.suffix not in _COMMENT:
        return
    for name in _FILE_NAME.findall(file.read_text("utf-8")):
        for folder in (file.parent, shared_folder("worlds")):
            if (folder / name).is_file():
                yield folder / name
                break


def _below(folder: Path, file: Path) -> Path:
    return file.relative_to(folder) if file.is_relative_to(folder) else Path(file.name)
