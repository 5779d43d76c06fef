"""The library of objects: definitions beside a world, in the user's folder, and those of crs_cc.

An object of a file in the world's folder is included, so that the world follows when that file is
changed; one from elsewhere is copied into the world with what it needs.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Final

from crs_cc.builder import clips
from crs_cc.builder.addresses import ids, unused_name
from crs_cc.builder.composition import definitions
from crs_cc.builder.document import Document
from crs_cc.builder.shapes import Shape, shapes
from crs_cc.builder.world_builder import WorldBuilder
from crs_cc.core.errors import WorldError
from crs_cc.core.shared_files import shared_folder
from crs_cc.sim.files.xml_document import read_file

MAX_FILES: Final = 40
MAX_OBJECTS: Final = 200

_FOLDER: Final = "lib"


@dataclass(frozen=True, slots=True)
class LibraryObject:
    """An object that can be put into worlds.

    Attributes:
        name: the name of its definition.
        file: the file with it.
        shapes: what it looks like from above, in its own frame.
    """

    name: str
    file: Path
    shapes: Sequence[Shape]


def user_folder() -> Path:
    """Return the folder of the user's own objects, `crs_cc/lib` among the user's data."""
    data = os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share"
    return Path(data) / "crs_cc" / _FOLDER


def library(folder: Path | None) -> list[LibraryObject]:
    """Return the objects that can be put into a world.

    Args:
        folder: the world's folder; None if it has none yet.
    """
    own = [] if folder is None else [folder / _FOLDER]
    found: list[LibraryObject] = []
    for path in list(_files([*own, user_folder(), shared_folder("worlds") / _FOLDER]))[:MAX_FILES]:
        try:
            found += _objects(path, read_file(path))
        except WorldError:
            continue  # an object that cannot be read cannot be put down
    return found[:MAX_OBJECTS]


def _files(folders: Sequence[Path]) -> Iterator[Path]:
    """Yield the files in folders, each once."""
    seen = set[Path]()
    for folder in folders:
        for path in sorted(folder.glob("*.xml")):
            if path.resolve() not in seen:
                seen.add(path.resolve())
                yield path


@cache
def _objects(path: Path, text: bytes) -> tuple[LibraryObject, ...]:
    home = Document(text, str(path))
    if home.root.tag != "definitions":
        return ()
    names = list(definitions(home.root))[:MAX_OBJECTS]
    return tuple(LibraryObject(name, path, _picture(home, path, name)) for name in names)


def _picture(home: Document, path: Path, name: str) -> Sequence[Shape]:
    sheet = WorldBuilder.new(1.0, 1.0)
    sheet.set("area", origin="centre", edge=0)
    sheet.paste(_clip(home, path, name))
    own = sheet.add("object", ref=name, x=0, y=0)
    world = sheet.visible()
    return () if world is None else shapes(sheet.document, world).get(own, ())


def _clip(home: Document, path: Path, name: str) -> str:
    included = list(clips.included_files(home, path.parent))
    return clips.clip(home, [definitions(home.root)[name]], included)


def put_object(builder: WorldBuilder, obj: LibraryObject, x_m: float, y_m: float) -> str:
    """Put an object of the library into a world; return its id.

    Raises:
        ValueError: the world has another definition of this name.
        WorldError: the file of the object cannot be read.
    """
    home = Document(read_file(obj.file), str(obj.file))
    with builder.together("add"):
        known = [builder.document, *builder.library()]
        there = [each for each in known if obj.name in definitions(each.root)]
        if there and not any(_is_same(each, home, obj.name) for each in there):
            raise ValueError(f"the world has another definition {obj.name!r}: rename one of them")
        if not there:
            folder = None if builder.path is None else builder.path.parent
            if folder is not None and obj.file.is_relative_to(folder):
                file = obj.file.relative_to(folder).as_posix()
                builder.add("include", {"file": file})
            else:
                builder.paste(_clip(home, obj.file, obj.name))
        own_id = unused_name(obj.name, ids(builder.document.root))
        return builder.add("object", id=own_id, ref=obj.name, x=x_m, y=y_m)


def _is_same(one: Document, other: Document, name: str) -> bool:
    """Return whether two definitions are the same but for spaces and comments."""
    first, second = definitions(one.root)[name], definitions(other.root)[name]
    return [(each.tag, each.attributes) for each in first.all()] == [
        (each.tag, each.attributes) for each in second.all()
    ]
