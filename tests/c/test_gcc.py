"""What the valid cases must print is what gcc makes them print, and nobody else writes it.

`--update-goldens` writes the `.out` files here, from gcc's output; elsewhere they are only read.
Two comments in a case change that: `// gcc options: ...` are options for it, and `// without gcc:
reason` says why gcc cannot tell; the `.out` file is then written by hand.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests import gcc
from tests.c.execution import cases, mark, name, sources

TIMEOUT_S = 20.0


@pytest.mark.parametrize(
    "path", [path for path in cases("valid") if not mark(path, "without gcc")], ids=name
)
def test_what_is_stored_is_what_gcc_says(
    path: Path, tmp_path: Path, check_gcc_golden: Callable[[Path, bytes], None]
) -> None:
    if gcc.why_not():
        pytest.skip(f"gcc -m32: {gcc.why_not()}")
    options = ["-w", "-O0", *mark(path, "gcc options").split()]
    assert gcc.complaint(sources(path), tmp_path / "case", options) == ""
    result = gcc.run(tmp_path / "case", TIMEOUT_S)
    assert result is not None, "the program does not end"
    assert result.end == f"exit {mark(path, 'exit') or 0}"
    check_gcc_golden(path.with_suffix(".out"), result.output)


def test_our_own_output_never_becomes_gccs(check_golden: Callable[[Path, bytes], None]) -> None:
    for stored in (cases("valid")[0].with_suffix(".out"), Path(__file__).parents[1] / "fuzz/x.out"):
        with pytest.raises(ValueError, match="only gcc"):
            check_golden(stored, b"")
