"""Packages of npm that tests use, installed once in a cache."""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
from pathlib import Path
from typing import Final

import pytest

CACHE: Final = Path(os.environ.get("XDG_CACHE_HOME", Path.home() / ".cache")) / "crs_cc_tests"


def installed(wanted: Path) -> Path:
    """Return `node_modules` with the packages of a folder's lock; skip the test without them."""
    missing = [name for name in ("node", "npm") if shutil.which(name) is None]
    if missing:
        pytest.skip(f"{' and '.join(missing)} not found")
    lock = (wanted / "package-lock.json").read_bytes()
    folder = CACHE / f"npm-{hashlib.sha256(lock).hexdigest()[:16]}"
    if not (folder / "installed").exists():
        folder.mkdir(parents=True, exist_ok=True)
        for name in ("package.json", "package-lock.json"):
            shutil.copy(wanted / name, folder)
        options = ["--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"]
        done = subprocess.run(["npm", "ci", *options], cwd=folder, timeout=120, check=False)
        if done.returncode:
            pytest.skip(f"npm cannot install the packages of {wanted}")
        (folder / "installed").touch()
    return folder / "node_modules"
