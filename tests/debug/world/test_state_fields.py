"""State[] with names and units, held to the vendor's header."""

import re
from pathlib import Path

import pytest

from crs_cc.debug.world.state_fields import state_fields

INCLUDE = Path(__file__).parents[3] / "crs_cc" / "runtime" / "lib" / "include"


@pytest.mark.parametrize(
    ("dialect", "header"), [("nomad", "Nclient.h"), ("report", "crs/report.h")]
)
@pytest.mark.parametrize("synchro", [False, True])
def test_every_field_has_the_index_of_the_header(dialect, header, synchro) -> None:
    text = (INCLUDE / header).read_text()
    constants = dict(re.findall(r"#define\s+(STATE_\w+)\s+(\d+)", text))
    size = int(re.search(r"#define\s+NUM_STATE\s+(\d+)", text)[1])
    fields = state_fields(dialect, synchro=synchro)
    assert [field.index for field in fields] == list(range(size))
    known = [field for field in fields if field.name in constants]
    assert all(int(constants[field.name]) == field.index for field in known)
    assert len(known) >= 27


def told(values: list[int], dialect: str = "nomad") -> dict[str, str]:
    fields = state_fields(dialect)
    return {field.name: field.text(value) for field, value in zip(fields, values, strict=True)}


def test_values_are_shown_in_vendor_and_si_units() -> None:
    values = [0] * 45
    values[17], values[18], values[33], values[34], values[36] = 100, 255, 5, -393, 900
    values[38], values[39], values[41], values[1] = 100, -50, 3, 15
    shown = told(values)
    assert shown["STATE_SONAR_0"] == "100 in = 2.540 m"
    assert shown["STATE_SONAR_1"] == "no echo"
    assert shown["STATE_BUMPER"] == "bits 0, 2"
    assert shown["STATE_CONF_X"] == "-393 0.1in = -0.998 m"
    assert shown["STATE_CONF_STEER"] == "900 0.1deg = 90.0 deg"
    assert shown["STATE_VEL_RIGHT"] == "100 0.1in/s = 0.254 m/s"
    assert shown["STATE_VEL_LEFT"] == "-50 0.1in/s = -0.127 m/s"
    assert shown["STATE_MOTOR_STATUS"] == "bits 0, 1"
    assert shown["STATE_IR_0"] == "nothing near"
    assert shown["STATE_SIM_SPEED"] == "0"


def test_the_reports_dialect_has_its_own_units_and_the_heat() -> None:
    values = [0] * 46
    values[17], values[18], values[33], values[45] = 1000, -1, 1, 12
    shown = told(values, "report")
    assert shown["STATE_SONAR_0"] == "1000 0.1in = 2.540 m"
    assert shown["STATE_SONAR_1"] == "no echo"
    assert (shown["STATE_BUMPER"], shown["STATE_HEAT"]) == ("1", "12")
