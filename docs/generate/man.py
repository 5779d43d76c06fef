r"""The man pages of `crs` and its commands, from the same tables as their help.

Escapes are those of groff_char(7): `\-` is a minus that can be copied, and a line must not begin
with a dot or an apostrophe.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Final

import click

from crs_cc import __version__
from crs_cc.cli.main import crs
from docs.generate import DOCS

MAN: Final = DOCS / "man"


def pages() -> dict[str, str]:
    """Return the text of each man page, by file name."""
    return {f"{name.replace(' ', '-')}.1": _page(name, one) for name, one in _commands("crs", crs)}


def _commands(name: str, command: click.Command) -> Iterator[tuple[str, click.Command]]:
    yield name, command
    if isinstance(command, click.Group):
        for part, each in sorted(_subcommands(command)):
            yield from _commands(f"{name} {part}", each)


def _subcommands(group: click.Group) -> Iterator[tuple[str, click.Command]]:
    context = click.Context(group)
    for name in group.list_commands(context):
        command = group.get_command(context, name)
        assert command is not None
        yield name, command


def _page(name: str, command: click.Command) -> str:
    context = _context(name, command)
    title = name.replace(" ", "-")
    usage = " ".join(command.collect_usage_pieces(context))
    lines = [
        f'.TH {_escaped(title.upper())} 1 "" "crs {__version__}" "crs"',
        *(".SH NAME", f"{_escaped(title)} \\- {_escaped(_summary(command))}"),
        *(".SH SYNOPSIS", f".B {_escaped(name)}", _escaped(usage)),
        *(".SH DESCRIPTION", *_paragraphs(command.help or "")),
        *_options(command, context),
        *_parts(name, command),
        *_epilog(command.epilog or ""),
        *_see_also(name, command),
    ]
    return "\n".join(lines) + "\n"


def _context(name: str, command: click.Command) -> click.Context:
    return click.Context(
        command, info_name=name, help_option_names=["-h", "--help"], terminal_width=78
    )


def _summary(command: click.Command) -> str:
    text = command.get_short_help_str(200).rstrip(".")
    return text[:1].lower() + text[1:]


def _options(command: click.Command, context: click.Context) -> Iterator[str]:
    records = [each.get_help_record(context) for each in command.get_params(context)]
    if any(records):
        yield ".SH OPTIONS"
    for names, text in filter(None, records):
        yield from (".TP", f".B {_escaped(names)}", _escaped(text))


def _parts(name: str, command: click.Command) -> Iterator[str]:
    if isinstance(command, click.Group):
        yield ".SH COMMANDS"
        for part, each in _subcommands(command):
            yield from (".TP", f".B {_escaped(f'{name} {part}')}", _escaped(_summary(each)))


def _epilog(text: str) -> Iterator[str]:
    """Yield the sections of an epilog, each of which has a title and lines as they are."""
    for section in filter(str.strip, text.split("\b\n")):
        title, *lines = section.strip("\n").split("\n")
        shown = (_escaped(line.removeprefix("  ")) for line in lines if line.strip())
        yield from (f".SH {title.rstrip(':').upper()}", ".nf", *shown, ".fi")


def _see_also(name: str, command: click.Command) -> Iterator[str]:
    others = [each for each, _ in _commands("crs", crs)] if command is crs else ["crs"]
    named = [f".BR {_escaped(each.replace(' ', '-'))} (1)" for each in others if each != name]
    yield from (".SH SEE ALSO", " ,\n".join(named))
    yield from (".PP", "crs docs shows the documentation.")


def _paragraphs(text: str) -> Iterator[str]:
    for number, paragraph in enumerate(re.split(r"\n\s*\n", text.strip())):
        if number:
            yield ".PP"
        yield _escaped(" ".join(paragraph.split()))


def _escaped(text: str) -> str:
    r"""Return text for troff.

    >>> print(_escaped(".c --json"))
    \&.c \-\-json
    """
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("~", "\\(ti").replace("^", "\\(ha")
    text = text.replace("'", "\\(aq").replace("`", "\\(ga").replace("\b", "")
    return f"\\&{text}" if text.startswith(".") else text
