"""Preprocessing of C snippets in tests: results and messages.

The snippets are in files of `data`: each has a title after `===`, the source, and the expected
tokens after `--- gives`, or the expected messages after `--- says`.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.preprocess.preprocessor import Preprocessed, preprocess_text
from crs_cc.frontend.preprocess.tokens import tokenise

DATA = Path(__file__).parent / "data"


def run(source: str, options: Options | None = None) -> tuple[Preprocessed, Diagnostics]:
    """Return the preprocessed text and all messages."""
    diagnostics = Diagnostics()
    return preprocess_text(source, "a.c", options or Options(), diagnostics), diagnostics


def tokens(text: str) -> list[str]:
    """Return the tokens of a text, without white space."""
    return [token.text for line in text.split("\n") for token in tokenise(line, 0)]


def result(source: str, options: Options | None = None) -> list[str]:
    """Return the preprocessed tokens of a text without errors and warnings."""
    program, diagnostics = run(source, options)
    assert [message.render() for message in diagnostics.messages] == []
    return tokens(program.text)


def without_attributes(text: str) -> str:
    """Return a text with GNU attributes, which pycparser does not know, replaced by spaces."""
    group = r"__attribute__\s*\(\s*\((?:[^()]|\([^()]*\))*\)\s*\)"
    return re.sub(group, lambda found: re.sub(r"\S", " ", found[0]), text)


def messages(source: str, options: Options | None = None) -> list[str]:
    """Return the messages about a text, each as `line:column: severity: text`."""
    _, diagnostics = run(source, options)
    return [
        message.render().split("\n")[0].removeprefix("a.c:") for message in diagnostics.messages
    ]


def cases(file: str, kind: str) -> list[object]:
    """Return the cases of a file as parameters, source and expectation, of one kind."""
    text = (DATA / file).read_text(encoding="utf-8")
    pattern = r"^=== (.*)\n((?:.*\n)*?)--- (gives|says)\n((?:(?!=== ).*\n)*)"
    found = re.findall(pattern, text, re.MULTILINE)
    assert len(found) == text.count("\n=== ") + text.startswith("=== "), f"{file} is malformed"
    return [
        pytest.param(source, expected, id=title)
        for title, source, which, expected in found
        if which == kind
    ]
