"""Drawings in braille characters."""

import numpy as np
import pytest

from crs_cc.debug.world.canvas import Canvas, clipped


def text(canvas: Canvas) -> list[str]:
    return ["".join(piece for piece, _ in row) for row in canvas.pieces()]


@pytest.mark.parametrize(
    ("x", "y", "character"),
    [(0, 0, "⠁"), (0, 1, "⠂"), (0, 2, "⠄"), (0, 3, "⡀"),
     (1, 0, "⠈"), (1, 1, "⠐"), (1, 2, "⠠"), (1, 3, "⢀")],
)  # fmt: skip
def test_each_dot_sets_its_bit_in_a_cell(x, y, character) -> None:
    canvas = Canvas(2, 2)
    canvas.dots(np.array([2.0 + x]), np.array([4.0 + y]), "", 0)
    assert text(canvas) == ["  ", f" {character}"]


def test_dots_outside_are_clipped() -> None:
    canvas = Canvas(1, 1)
    canvas.dots(np.array([-0.1, 2.0, 0.0, 1.9]), np.array([0.0, 0.0, -0.5, 3.9]), "", 0)
    canvas.put(-1, 0, "abc", "", 1)
    assert text(canvas) == ["b"]
    canvas.circles(np.array([[1e9, 1e9, 1e9]]), "", 0)
    canvas.lines(np.array([[-1e9, -1e9, -1e9, 1e9]]), "", 0)


def test_visible_lines_keep_their_styles_when_others_are_clipped() -> None:
    canvas = Canvas(1, 1)
    ends = np.array([[-9.0, 0.0, -5.0, 3.0], [9.0, 0.0, 9.0, 3.0], [0.0, 0.0, 1.0, 0.0]])
    canvas.lines(ends, ["a", "b", "c"], 0)
    assert canvas.pieces() == [[("⠉", "c")]]
    canvas.lines(ends, "d", 1)
    assert canvas.pieces() == [[("⠉", "d")]]


def test_a_cell_has_the_style_of_the_highest_rank() -> None:
    for order in ((0, 1), (1, 0)):
        canvas = Canvas(1, 1)
        for number in order:
            canvas.dots(np.array([float(number)]), np.array([0.0]), ["low", "high"][number], number)
        assert canvas.pieces() == [[("⠉", "high")]]


def test_a_text_does_not_overwrite_higher_ranks() -> None:
    canvas = Canvas(4, 1)
    canvas.put(1, 0, "→", "robot", 5)
    assert [canvas.is_free(column, 0, 2) for column in range(4)] == [False, False, True, False]
    canvas.put(0, 0, "abcd", "label", 1)
    assert canvas.pieces() == [[("a", "label"), ("→", "robot"), ("cd", "label")]]


def test_lines_are_solid_and_dotted_lines_have_gaps() -> None:
    canvas = Canvas(4, 1)
    canvas.lines(np.array([[0.0, 0.0, 7.0, 3.0]]), "", 0)
    assert sum((ord(character) - 0x2800).bit_count() for character in text(canvas)[0]) == 8
    dotted = Canvas(4, 1)
    dotted.lines(np.array([[0.0, 0.0, 7.0, 0.0]]), "", 0, gap=2)
    assert text(dotted) == ["⠁⠁⠁⠁"]


def test_clipping_keeps_the_inner_part_of_lines() -> None:
    random = np.random.default_rng(1)
    ends = random.uniform(-10.0, 20.0, (500, 4))
    share = np.linspace(0.0, 1.0, 4001)[:, None]
    for line in ends:
        points = line[:2] + share * (line[2:] - line[:2])
        inside = ((points >= 0.0) & (points <= [8.0, 6.0])).all(axis=1)
        _, kept = clipped(line[None], 8.0, 6.0)
        assert len(kept) == inside.any() or len(kept) == 1  # it may just touch a corner
        if inside.any():
            assert np.allclose(kept[0, :2], points[inside][0], atol=0.01)
            assert np.allclose(kept[0, 2:], points[inside][-1], atol=0.01)
