"""The generator of random programs and the reducer; `make fuzz` compares the programs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.fuzz.compare import difference, meaning, our_results
from tests.fuzz.generator.program import TOPICS, generate
from tests.fuzz.reduce import reduced
from tests.gcc import Result, why_not

STORED = Path(__file__).parent / "stored"
SEEDS = range(1, 11)


def test_a_seed_determines_the_program() -> None:
    assert generate(7) == generate(7) != generate(8)


def test_programs_of_a_few_seeds_use_every_topic() -> None:
    text = "".join(generate(seed) for seed in range(20))
    assert all(f"static void {topic}_" in text for topic in TOPICS)


def test_difference_names_the_build_and_the_line() -> None:
    wanted = Result(b"1\n2\n", "exit 0")
    same, other = Result(b"1\n2\n", "exit 0"), Result(b"1\n3\n", "exit 0")
    assert difference(wanted, {"checked": same}) is None
    found = difference(wanted, {"checked": same, "unchecked": other})
    assert found == "unchecked: '3', gcc: '2'"
    refused = {"checked": Result(b"", "refused")}
    assert difference(wanted, refused) == "checked: refused, gcc: exit 0"


def test_reduction_keeps_the_difference() -> None:
    text = generate(3)
    shorter = reduced(text, lambda each: "int main(void) {" in each and "return 0;" in each)
    assert [line.strip() for line in shorter.split("\n")] == ["int main(void) {", "return 0;", "}"]


@pytest.mark.parametrize("seed", SEEDS)
def test_results_are_those_of_gcc(seed: int, tmp_path: Path) -> None:
    source = tmp_path / "program.c"
    source.write_text(generate(seed))
    results = our_results(source)
    wanted = Result((STORED / f"seed_{seed}.out").read_bytes(), "exit 0")
    assert difference(wanted, results) is None


@pytest.mark.parametrize("seed", SEEDS)
def test_stored_results_are_those_of_gcc(
    seed: int, tmp_path: Path, check_gcc_golden: Callable[[Path, bytes], None]
) -> None:
    if why_not():
        pytest.skip(f"gcc -m32: {why_not()}")
    source = tmp_path / "program.c"
    source.write_text(generate(seed))
    wanted = meaning(source)
    assert wanted is not None, "gcc disagrees with itself"
    check_gcc_golden(STORED / f"seed_{seed}.out", wanted.output)
