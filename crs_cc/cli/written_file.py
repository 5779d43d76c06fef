"""Files that are written as a whole: errors name the file, and no partial file is left."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Final

_FULL: Final = frozenset({errno.ENOSPC, errno.EDQUOT, errno.EFBIG})


@contextmanager
def written_file(path: Path) -> Iterator[None]:
    """Name a file in errors about writing it, and remove the partial file."""
    try:
        yield
    except OSError as error:
        text = error.strerror or str(error)
        if error.errno is None or error.errno not in _FULL:
            raise OSError(error.errno, text, str(path)) from None
        if path.is_file() and not path.is_symlink():
            with suppress(OSError):
                path.unlink()
        raise OSError(error.errno, os.strerror(error.errno), str(path)) from None
