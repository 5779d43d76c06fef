"""`docs/errors.md` explains each kind of error, and the README shows a real report."""

from __future__ import annotations

import re

from crs_cc.requests import ERROR_KINDS
from docs.generate import ROOT, template
from docs.generate.errors import example

NOT_ON_THE_PAGE = {"none", "internal trap"}
"""Not an error, and an error of crs itself."""


def test_every_kind_of_error_is_explained() -> None:
    titles = re.findall(r"^## (.*)$", template("errors"), re.MULTILINE)
    kinds = [kind for kind in ERROR_KINDS if kind not in NOT_ON_THE_PAGE]
    assert [f"{kind[0].upper()}{kind[1:]}" for kind in kinds] == titles


def test_the_readme_shows_a_real_report() -> None:
    _, _, report = example("students/one_sonar_too_many").partition("\n```\n\n```\n")
    assert report in (ROOT / "README.md").read_text(encoding="utf-8")
