"""Builds what pyproject.toml describes, and copies samples, worlds and pages into the package.

They stand beside the package in a checkout, where `crs_cc/core/shared_files.py` finds them; an
editable installation uses them there.
"""

from __future__ import annotations

from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py

ROOT = Path(__file__).parent
FILES = ("samples/**/*", "worlds/**/*", "docs/*.md", "docs/tutorial/**/*")
ENDINGS = frozenset(
    [".c", ".csv", ".grid", ".h", ".map", ".md", ".png", ".py", ".toml", ".txt", ".xml"]
)


class BuildWithShared(build_py):
    """Builds the package with the folder `share`."""

    def run(self) -> None:
        """Build the package, and copy the files that belong to it."""
        super().run()
        if self.editable_mode:
            return
        for file in (file for pattern in FILES for file in sorted(ROOT.glob(pattern))):
            if file.suffix in ENDINGS:
                target = Path(self.build_lib, "crs_cc", "share", file.relative_to(ROOT))
                self.mkpath(str(target.parent))
                self.copy_file(str(file), str(target))


setup(cmdclass={"build_py": BuildWithShared})
