"""Takes away what only Unix has: imported when Python starts, before everything else.

Each Python started with this folder on its path lacks it. Children of `multiprocessing` are
spawned.
"""

import multiprocessing
import os
import platform
import select
import socket
import sys
from typing import Any

from unix_names import MODULES, NAMES

os.environ["NUMPY_MADVISE_HUGEPAGE"] = "1"  # numpy would ask os.uname, as sys.platform is linux
platform.uname()  # kept, as Windows has it; it is made of os.uname here
wait = select.select


def wait_for_sockets(*lists: Any) -> Any:
    """Wait as `select` on Windows does."""
    for each in (each for some in lists[:3] for each in some):
        if not isinstance(each, socket.socket):
            raise OSError(10038, "not a socket")
    return wait(*lists)


select.select = wait_for_sockets
for module in MODULES:
    sys.modules[module] = None  # type: ignore[assignment]
for name in NAMES:
    if hasattr(os, name):
        delattr(os, name)
os.supports_dir_fd = set()
multiprocessing.set_start_method("spawn")
