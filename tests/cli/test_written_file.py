"""Files that cannot be written: the error names the file, and half of one is not left."""

from __future__ import annotations

import errno
from pathlib import Path

import pytest

from crs_cc.cli.main import main
from crs_cc.cli.written_file import written_file
from tests.recorded import recorded

__all__ = ["recorded"]


def test_a_full_disk_leaves_no_partial_file_and_names_it(tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text("half")
    full = pytest.raises(OSError, match=r"No space left on device: .*page\.html'")
    with full as caught, written_file(path):
        raise OSError(errno.ENOSPC, "Error writing bytes to file")
    assert caught.value.filename == str(path)
    assert not path.exists()


def test_a_file_that_may_not_be_written_stays(tmp_path: Path) -> None:
    path = tmp_path / "page.html"
    path.write_text("yours")
    with pytest.raises(PermissionError, match=r"page\.html"), written_file(path):
        raise OSError(errno.EACCES, "Permission denied")
    assert path.read_text() == "yours"


@pytest.mark.parametrize("option", ["--html", "--plot", "--recover"])
def test_exports_name_the_file_of_a_full_disk(
    option: str, recorded: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    assert main(["replay", str(recorded), option, "/dev/full"]) == 1
    assert capfd.readouterr().err == "crs: error: No space left on device: /dev/full\n"
