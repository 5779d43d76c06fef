"""The elements `<field>` of a world file, read and written."""

from __future__ import annotations

import math
from typing import Final

from crs_cc.core.quantity import AMOUNT, DIFFUSIVITY, LENGTH, TIME
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.fields import (
    MAX_AMOUNT,
    MAX_CELLS,
    MAX_FIELDS,
    MIN_EVAPORATION_S,
    NEVER_S,
    STABLE,
    Field,
)
from crs_cc.sim.model.world import Area

_USUAL: Final = Field("")
_MIN_M: Final = 0.001


def fields_of(root: Element, area: Area, timestep_s: float, reader: Reader) -> tuple[Field, ...]:
    """Return the pheromone fields of a world file; errors go to the reader."""
    found: dict[str, Element] = {}
    fields = []
    for element in root.all("field"):
        name = element.attributes["name"]
        if name in found:
            reader.error(
                element, f"duplicate field {name!r} (first defined in {found[name].place})"
            )
        found.setdefault(name, element)
        fields.append(_field(element, area, timestep_s, reader))
    if len(fields) > MAX_FIELDS:
        reader.error(root, f"more than {MAX_FIELDS} fields (<field>)")
    return tuple(fields[:MAX_FIELDS])


def _field(element: Element, area: Area, timestep_s: float, reader: Reader) -> Field:
    field = Field(
        element.attributes["name"],
        reader.positive(element, "cell", LENGTH, _USUAL.cell_m),
        _evaporation_s(element, reader),
        reader.not_negative(element, "diffusion", DIFFUSIVITY),
        reader.positive(element, "saturation", AMOUNT, MAX_AMOUNT),
    )
    cells = math.ceil(area.length_m / field.cell_m) * math.ceil(area.width_m / field.cell_m)
    if field.cell_m < _MIN_M or cells > MAX_CELLS:
        reader.refuse(element, f"cell: too small: {cells} cells in the area (most: {MAX_CELLS})")
    elif field.share(timestep_s) > STABLE:
        most = STABLE * field.cell_m * field.cell_m / timestep_s
        shown = f"{DIFFUSIVITY.show(math.floor(most * 1e8) / 1e8)}"
        reader.refuse(
            element,
            f"diffusion: unstable for this cell and timestep (most: {shown}, cell^2 / 4 timesteps)",
        )
    return field


def _evaporation_s(element: Element, reader: Reader) -> float:
    """Return the evaporation time of a field's element."""
    value_s = reader.positive(element, "evaporation", TIME, NEVER_S)
    if value_s < MIN_EVAPORATION_S:
        reader.refuse(element, "evaporation: must be 100ms or more")
        return NEVER_S
    return value_s


def field_element(field: Field) -> Element:
    """Return the element of a field."""
    attributes = {
        "name": field.name,
        "cell": LENGTH.exact(field.cell_m),
        "diffusion": DIFFUSIVITY.exact(field.diffusion_m2ps),
        "saturation": AMOUNT.exact(field.saturation),
    }
    if field.evaporation_s != NEVER_S:
        attributes["evaporation"] = TIME.exact(field.evaporation_s)
    return Element("field", 0, attributes)
