"""The overview of a large package names each of its files and packages, and nothing else."""

import re
from pathlib import Path
from types import ModuleType

import pytest

from crs_cc import builder, debug, sim


@pytest.mark.parametrize("package", [builder, debug, sim], ids=lambda package: package.__name__)
def test_each_file_and_package_is_named(package: ModuleType):
    folder = Path(package.__file__ or "").parent
    files = {path.stem for path in folder.glob("*.py") if path.stem != "__init__"}
    packages = {f"{path.name}/" for path in folder.iterdir() if path.is_dir()}
    named = re.findall(r"`([a-z_]+/?)`", package.__doc__ or "")
    assert set(named) == {name for name in files | packages if name != "__pycache__/"}
