"""The elements `<source>` and `<nest>` of world files: values, defaults and errors."""

from __future__ import annotations

import math

import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.foraging import Nest, Source
from crs_cc.sim.model.world import WorldModel


def world(places: str) -> WorldModel:
    area = '<area length="6m" width="6m"/>'
    text = f'<world version="1">{area}\n{places}<robot x="1m" y="1m"/></world>'
    return parse_world(text.encode(), "test")


def test_places_have_defaults():
    found = world('<source x="1m" y="2m"/><nest x="3m" y="50cm"/>')
    assert found.sources == (Source("source0", 1.0, 2.0, 0.3, None, math.inf),)
    assert found.nests == (Nest("nest0", 3.0, 0.5, 0.3),)


def test_places_have_values():
    given = '<source id="food" x="0" y="0" radius="1m" items="7" refill="60s"/>'
    assert world(given).sources == (Source("food", 0.0, 0.0, 1.0, 7, 60.0),)


@pytest.mark.parametrize(
    ("places", "text"),
    [
        ('<source x="1m"/>', "attribute 'y'"),
        ('<source x="1m" y="1m" items="0"/>', "is not an integer from 1 to"),
        ('<source x="1m" y="1m" items="1e9"/>', "items"),
        ('<source x="1m" y="1m" items="1000000001"/>', "is not an integer from"),
        ('<source x="1m" y="1m" refill="1s"/>', "never runs out, as it has no items='...'"),
        ('<source x="1m" y="1m" items="3" refill="0s"/>', "must be greater than 0"),
        ('<nest x="1m" y="1m" radius="-1m"/>', "must be greater than 0"),
        ('<nest x="1m" y="1m" items="3"/>', "items"),
        ('<nest id="a" x="1m" y="1m"/><source id="a" x="1m" y="1m"/>', "duplicate id 'a'"),
        (1001 * '<nest x="1m" y="1m"/>', "more than 1000 places of this kind (<nest>)"),
    ],
)
def test_impossible_places_are_refused_with_their_line(places, text):
    with pytest.raises(WorldError) as caught:
        world(places)
    assert text in str(caught.value)
    assert ":2:" in str(caught.value) or "line 2" in str(caught.value)
