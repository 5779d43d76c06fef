"""The overview of the package names each of its files and packages, once, and nothing else."""

import re
from pathlib import Path

from crs_cc import sim


def test_each_file_and_package_is_named_once():
    folder = Path(sim.__file__).parent
    files = [path.stem for path in folder.glob("*.py") if path.stem != "__init__"]
    packages = [f"{path.name}/" for path in folder.iterdir() if path.is_dir()]
    named = re.findall(r"`([a-z_]+/?)`", sim.__doc__ or "")
    assert sorted(named) == sorted(name for name in files + packages if name != "__pycache__/")
