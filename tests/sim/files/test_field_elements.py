"""The elements `<field>` of world files: values, defaults and errors."""

from __future__ import annotations

import math

import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.fields import Field
from crs_cc.sim.model.world import WorldModel


def world(fields: str, size: str = "6m") -> WorldModel:
    area = f'<area length="{size}" width="{size}"/>'
    text = f'<world version="1">{area}{fields}<robot x="1m" y="1m"/></world>'
    return parse_world(text.encode(), "test")


def test_field_has_defaults_of_its_own():
    assert world('<field name="a"/>').fields == (Field("a", 0.05, math.inf, 0.0, 1e6),)
    given = '<field name="b" cell="1in" evaporation="2500ms" diffusion="5cm2/s" saturation="7"/>'
    assert world(given).fields[0] == Field("b", 0.0254, 2.5, 5e-4, 7.0)


@pytest.mark.parametrize(
    ("fields", "text"),
    [
        (
            '<field name="a" diffusion="0.0126"/>',
            "unstable for this cell and timestep (most: 0.01",
        ),
        ('<field name="a" diffusion="-1"/>', "must not be negative"),
        ('<field name="a" cell="1mm"/>', "36000000 cells in the area (most: 33554432)"),
        ('<field name="a" evaporation="99ms"/>', "must be 100ms or more"),
        ('<field name="a" saturation="0"/>', "must be greater than 0"),
        ('<field name="a" saturation="1e7"/>', "too large"),
        ('<field name="a"/><field name="a"/>', "duplicate field 'a' (first defined in line 1)"),
        ("".join(f'<field name="f{n}"/>' for n in range(5)), "more than 4 fields"),
        ("<field/>", "name"),
    ],
)
def test_impossible_fields_are_refused(fields, text):
    with pytest.raises(WorldError) as caught:
        world(fields)
    assert text in str(caught.value)
