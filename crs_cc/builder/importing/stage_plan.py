"""Worlds of Stage (rtv.github.io/Stage): boxes, polygons, floor plans from pictures, robots.

A model has a size, a pose of its middle, a colour, and a shape: its own blocks, a bitmap, or all of
its box. Definitions are followed. Included files are not read.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Final

from crs_cc.builder.importing.drawn import PlanElements, Point
from crs_cc.builder.importing.png_plan import dark_boxes
from crs_cc.builder.importing.stage_tokens import Block, parse
from crs_cc.sim.model.world import Pose

_DEEPEST: Final = 16
_ROBOTS: Final = frozenset({"position", "pioneer2dx", "pioneer3dx", "amigobot"})
_NO_MODELS: Final = frozenset({"window", "include", "ranger", "laser", "sensor", "gripper"})


def read_stage(text: str, picture: Callable[[str], bytes]) -> PlanElements:
    """Return the elements of a Stage world.

    Args:
        text: the file.
        picture: returns the contents of a picture that it names.

    Raises:
        ValueError: it is not such a file, or too large.
    """
    drawn = PlanElements()
    kinds: dict[str, Block] = {}
    for block in parse(text):
        if block.word == "define":
            kinds[block.name] = block
        elif block.word in _NO_MODELS:
            drawn.omit(block.word)
        else:
            _model(drawn, kinds, block, picture)
    return drawn


def _chain(kinds: Mapping[str, Block], block: Block) -> tuple[list[Block], str]:
    """Return a block and the definitions that it is based on, and the name of the last base."""
    chain, word = [block], block.word
    while word in kinds and len(chain) < _DEEPEST:
        chain.append(kinds[word])
        word = kinds[word].base
    return chain, word


def _model(
    drawn: PlanElements, kinds: Mapping[str, Block], block: Block, picture: Callable[[str], bytes]
) -> None:
    chain, base = _chain(kinds, block)
    values = {name: value for each in reversed(chain) for name, value in each.values.items()}
    pose = _numbers(values.get("pose", ()), 4)
    centre, heading_rad = (pose[0], pose[1]), math.radians(pose[3])
    if base in _ROBOTS or any(each.word in _ROBOTS for each in chain):
        drawn.robot(centre, heading_rad)
        return
    size = _numbers(values.get("size", ()), 3)
    if "size" not in values:
        size = [1.0, 1.0, 1.0]  # the default of models
    more = {"colour": _colour(values["color"][0])} if values.get("color") else {}
    more = {name: value for name, value in more.items() if value}
    shapes = [inner for each in chain for inner in each.blocks if inner.word == "block"]
    for each in chain:
        for inner in each.blocks:
            if inner.word != "block":
                drawn.omit(inner.word, "inside of a model")
    if values.get("bitmap"):
        try:
            boxes = dark_boxes(picture(values["bitmap"][0]), 0.5)
        except ValueError as wrong:
            drawn.omit("bitmap", f"{values['bitmap'][0][:80]}: {wrong}")
        else:
            _bitmap(drawn, boxes, size, Pose(*centre, heading_rad), more)
    elif shapes:
        _blocks(drawn, shapes, size, Pose(*centre, heading_rad), more)
    else:
        drawn.box(centre, (size[0], size[1]), heading_rad, more)


def _bitmap(
    drawn: PlanElements,
    boxes: Sequence[tuple[float, float, float, float]],
    size: Sequence[float],
    place: Pose,
    more: dict[str, str],
) -> None:
    """Add the dark areas of a picture, which has the size of the model."""
    for left, bottom, right, top in boxes:
        middle = ((left + right) / 2 - 0.5) * size[0], ((bottom + top) / 2 - 0.5) * size[1]
        own = Pose(*middle).within(place)
        across = (right - left) * size[0], (top - bottom) * size[1]
        drawn.box((own.x_m, own.y_m), across, place.heading_rad, more)


def _blocks(
    drawn: PlanElements,
    shapes: Sequence[Block],
    size: Sequence[float],
    place: Pose,
    more: dict[str, str],
) -> None:
    """Add the blocks of a model, which are scaled together to its size."""
    chains: list[list[Point]] = []
    for shape in shapes:
        points = [
            _numbers(value, 2) for name, value in shape.values.items() if name.startswith("point")
            and name != "points"
        ]  # fmt: skip
        chains.append([(x, y) for x, y in points])
    xs = [x for chain in chains for x, _ in chain] or [0.0]
    ys = [y for chain in chains for _, y in chain] or [0.0]
    width, height = max(xs) - min(xs) or 1.0, max(ys) - min(ys) or 1.0
    for chain in chains:
        placed = []
        for x, y in chain:
            own = Pose(
                ((x - min(xs)) / width - 0.5) * size[0], ((y - min(ys)) / height - 0.5) * size[1]
            ).within(place)
            placed.append((own.x_m, own.y_m))
        drawn.polygon(placed, more)


def _colour(text: str) -> str:
    return text if text.isalpha() else ""


def _numbers(words: Sequence[str], count: int) -> list[float]:
    """Return numbers; those that are missing are 0.

    Raises:
        ValueError: one is invalid.
    """
    found = [float(word) for word in words[:count]]
    if not all(map(math.isfinite, found)):
        raise ValueError("a number is not finite")
    return found + [0.0] * (count - len(found))
