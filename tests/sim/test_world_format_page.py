"""Every type of the schemas has documentation, of which `docs/world-format.md` is made."""

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
