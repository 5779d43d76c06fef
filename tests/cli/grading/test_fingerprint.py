"""Programs that differ in names and comments only have the same fingerprint, others have not."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.cli.grading.fingerprint import fingerprint
from crs_cc.cli.grading.source_tokens import tokens_of
from tests.cli.grading.handed_in import good


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def mark(*texts: str) -> str:
    for number, text in enumerate(texts):
        Path(f"f{number}.c").write_text(text)
    return fingerprint([tokens_of(Path(f"f{number}.c")) for number in range(len(texts))])


def test_names_comments_white_space_and_macros_do_not_matter() -> None:
    first = mark(good())
    assert first
    assert mark(good(name="counter", comment="quite another text")) == first
    assert mark(good().replace("    ", "\t").replace("{", "\n{ // here\n")) == first
    assert mark("#define FAST 250\n" + good().replace("250", "FAST")) == first


def test_numbers_and_calls_matter() -> None:
    texts = [good(), good(249), good().replace("gs();", "get_sn();"), good().replace("<", "<=")]
    assert len({mark(text) for text in texts}) == len(texts)


def test_names_must_be_replaced_consistently() -> None:
    swapped = "int a, b;\n" + good().replace("800", "a + b")
    assert mark(swapped) != mark(swapped.replace("a + b", "a + a"))


def test_the_order_of_files_does_not_matter() -> None:
    assert mark(good(), good(100)) == mark(good(100), good())


def test_very_short_programs_are_not_compared() -> None:
    assert mark("int main(void) { return 0; }") == ""
