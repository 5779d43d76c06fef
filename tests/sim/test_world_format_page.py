"""The schemas are documented: `docs/world-format.md` is made of that."""

from __future__ import annotations

import pytest

from docs.generate.schema import XS, Schema, documentation


@pytest.mark.parametrize("name", ["world.xsd", "robot.xsd"])
def test_every_type_of_the_schema_is_documented(name: str) -> None:
    schema = Schema(name)
    missing = [
        each.get("name")
        for each in schema.root.iter(f"{XS}complexType")
        if each.get("name") and not documentation(each)
    ]
    assert not missing


@pytest.mark.parametrize("name", ["world.xsd", "robot.xsd"])
def test_every_attribute_of_the_schema_is_documented(name: str) -> None:
    attributes = [each for each in Schema(name).root.iter(f"{XS}attribute") if each.get("name")]
    missing = [each.get("name") for each in attributes if not documentation(each)]
    assert attributes
    assert not missing
