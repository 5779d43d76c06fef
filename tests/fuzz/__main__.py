"""Compares random programs with gcc: `make fuzz`, or `python -m tests.fuzz`.

Half of the programs are from csmith if it is installed (with its header files); the others are from
a generator of our own, for what csmith leaves out. The seed determines the programs. A program
that shows a difference is kept in the directory `--keep`, complete and reduced.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from tests.fuzz.compare import difference, is_defined, meaning, our_results
from tests.fuzz.generator.program import generate
from tests.fuzz.reduce import reduced
from tests.gcc import why_not

CSMITH_HEADERS = Path(os.environ.get("CSMITH_HOME", "/usr") + "/include/csmith")

MISSING = (
    "this compares with gcc -m32, which does not work here"
    " (on Debian and Ubuntu: apt install gcc-multilib)"
)
MAX_TRIES = 3
"""How many programs are tried for each one to be compared; some are undefined for gcc."""


@dataclass
class Fuzzer:
    """One run of the comparison.

    Attributes:
        folder: the directory for the current programs.
        keep: the directory for programs that show a difference.
        counts: the number of programs for each outcome.
    """

    folder: Path
    keep: Path
    reduce: bool
    counts: Counter[str] = field(default_factory=Counter)

    def tried(self) -> int:
        """Return the number of programs so far."""
        return self.counts["compared"] + self.counts["without meaning"]

    def own(self, seed: int) -> None:
        """Compare a program of our own generator."""
        self._compare(f"own_{seed}", generate(seed), ())

    def csmith(self, seed: int) -> None:
        """Compare a program of csmith."""
        command = ["csmith", "--seed", str(seed)]  # it leaves a file where it runs
        done = subprocess.run(command, check=True, capture_output=True, text=True, cwd=self.folder)
        text = done.stdout
        self._compare(f"csmith_{seed}", text, (CSMITH_HEADERS,))

    def _compare(self, name: str, text: str, headers: tuple[Path, ...]) -> None:
        found = self._difference(name, text, headers)
        if found is None:
            return
        self.counts["different"] += 1
        print(f"{name}: {found}", flush=True)
        self.keep.mkdir(parents=True, exist_ok=True)
        (self.keep / f"{name}.c").write_text(text)
        if self.reduce:
            (self.keep / f"{name}.reduced.c").write_text(self._reduced(text, headers, found))

    def _difference(self, name: str, text: str, headers: tuple[Path, ...]) -> str | None:
        source = self.folder / f"{name}.c"
        source.write_text(text)
        wanted = meaning(source, [f"-I{path}" for path in headers])
        if wanted is None:
            self.counts["without meaning"] += 1
            return None
        self.counts["compared"] += 1
        return difference(wanted, our_results(source, headers))

    def _reduced(self, text: str, headers: tuple[Path, ...], found: str) -> str:
        source, options = self.folder / "shorter.c", [f"-I{path}" for path in headers]
        kind = re.split("[,']", found, maxsplit=1)[0]

        def shows(shorter: str) -> bool:
            source.write_text(shorter)
            wanted = meaning(source, options)
            if wanted is None:
                return False
            now = difference(wanted, our_results(source, headers))
            return now is not None and now.startswith(kind) and is_defined(source, options)

        return reduced(text, shows)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--count", type=int, default=100, help="programs (default 100)")
    parser.add_argument("--seed", type=int, default=1, help="of the first one (default 1)")
    parser.add_argument("--only", choices=["own", "csmith"], help="programs of one kind only")
    parser.add_argument("--keep", type=Path, default=Path("build/fuzz"), help="folder for findings")
    parser.add_argument("--no-reduce", dest="reduce", action="store_false")
    options = parser.parse_args()
    if why_not():
        print(f"{MISSING}: {why_not()}", file=sys.stderr)
        return 2
    kinds = ["own", "csmith"] if options.only is None else [options.only]
    if not (shutil.which("csmith") and CSMITH_HEADERS.is_dir()):
        print("csmith or its headers are not installed: our own programs only", file=sys.stderr)
        kinds = ["own"]
    with tempfile.TemporaryDirectory() as folder:
        fuzzer = Fuzzer(Path(folder), options.keep, options.reduce)
        seed = options.seed
        tries = MAX_TRIES * options.count
        while fuzzer.counts["compared"] < options.count and fuzzer.tried() < tries:
            for kind in kinds:
                getattr(fuzzer, kind)(seed)
            for path in Path(folder).iterdir():
                path.unlink()
            seed += 1
    counts = fuzzer.counts
    print(
        f"seeds {options.seed} to {seed - 1}: {counts['compared']} programs compared,"
        f" {counts['different']} differ, {counts['without meaning']} have no meaning for gcc itself"
    )
    if counts["compared"] < options.count:
        print(f"gave up after {fuzzer.tried()} programs", file=sys.stderr)
        return 1
    return 1 if counts["different"] else 0


if __name__ == "__main__":
    sys.exit(main())
