"""Notes about macro definitions for errors in their replacements.

Such an error has the location of the macro call, which does not show the cause. Neither does a
hint with such a location: `to close the '(' at a.c:3:5`, where there is only a macro.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final

from crs_cc.core.source import Diagnostic, Diagnostics, Location
from crs_cc.frontend.preprocess.macros import Macro
from crs_cc.frontend.preprocess.preprocessor import Preprocessed

_LOCATION: Final = re.compile(r"\bat (\S+:\d+:\d+)")
_QUOTED: Final = re.compile(r"'([^']+)'")


def add_macro_notes(
    diagnostics: Diagnostics, source: Preprocessed, headers: Sequence[Path]
) -> None:
    """Add a note to the first error in the replacement of each macro.

    Args:
        diagnostics: the messages about the file.
        source: the file.
        headers: the directories of the headers that come with crs; their macros are not shown.
    """
    uses = {str(location): macros for location, macros in source.macro_uses().items()}
    messages, noted = list(diagnostics.messages), set[str]()
    diagnostics.messages.clear()
    for message in messages:
        diagnostics.messages.append(message)
        note = _note(message, uses, source) if message.severity == "error" else None
        if note is None or note[1] in noted or _is_below(note[0], headers):
            continue
        noted.add(note[1])
        diagnostics.add("note", *note)


def _note(
    message: Diagnostic, uses: Mapping[str, Sequence[Macro]], source: Preprocessed
) -> tuple[Location, str] | None:
    locations = [str(message.location), *_LOCATION.findall(message.hint)]
    macros = next((uses[location] for location in locations if location in uses), None)
    if macros is None:
        return None
    macro = _blamed(message.text, macros)
    if not macro.position:
        return None  # a predefined macro
    first = f", which '{macros[0].name}' uses," if macro is not macros[0] else ""
    return source.definition(macro), f"macro '{macro.name}'{first} is defined here"


def _blamed(text: str, macros: Sequence[Macro]) -> Macro:
    """Return the macro whose definition contains the cause of a message, or the one called."""
    quoted = set(_QUOTED.findall(text))
    return next(
        (each for each in macros if any(token.text in quoted for token in each.body)), macros[0]
    )


def _is_below(location: Location, folders: Sequence[Path]) -> bool:
    return any(Path(location.file).is_relative_to(folder) for folder in folders)
