"""The part of `docs/robot-api.md` about the two dialects."""

from __future__ import annotations

from collections.abc import Iterator

from crs_cc.robot_api.report import CHOICES, COMMANDS, REPORT_STATE


def section() -> Iterator[str]:
    """Gives the lines of the page's part about the dialects."""
    yield "## The two dialects"
    yield ""
    yield (
        "A program that includes `Nclient.h` or has a `main` lives by the vendor's rules. One with"
        " a `runcode` instead, and no such header, lives by those of the CRS report; with"
        " `--dialect report` it may also be just the statements of its body. `--dialect`, and"
        ' `dialect="report"` of a robot in a world file, decide where the program does not look'
        " like what it is. In the report's dialect nothing need be included, `String` is `char *`,"
        " and `boolean`, `true` and `false` are there."
    )
    yield ""
    yield "| in the report's dialect | units | does | the vendor's | report |"
    yield "| --- | --- | --- | --- | --- |"
    for each in COMMANDS:
        vendors = {"": "the same", "-": "none"}.get(each.vendors, each.vendors)
        units = each.units or "-"
        yield f"| `{each.prototype}` | {units} | {each.meaning} | {vendors} | {each.source} |"
    yield ""
    yield "| in State | vendor's | report's |"
    yield "| --- | --- | --- |"
    for index, vendors, reports in REPORT_STATE:
        yield f"| `{index}` | {vendors} | {reports} |"
    yield ""
    yield "Chosen by us:"
    yield ""
    yield CHOICES.rstrip("\n")
