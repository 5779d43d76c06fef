"""The device registry: which rows it accepts, and the numbers that it assigns."""

from __future__ import annotations

from dataclasses import dataclass, replace

import pytest

from crs_cc.core.errors import DeviceError
from crs_cc.core.quantity import LENGTH, MASS
from crs_cc.requests import CODES, REGISTERED, REQUESTS
from crs_cc.sim.devices.number_sensor import Value, number_sensor
from crs_cc.sim.model import registry
from crs_cc.sim.model.attribute import period, rate
from crs_cc.sim.model.device import Device
from crs_cc.sim.model.registry import devices


@dataclass(frozen=True, slots=True)
class Sounder:
    """An echo sounder."""

    rate_hz: float = rate("1Hz")
    period_s: float = period()


FIELDS = {
    "name": "depth", "title": "Echo sounder", "element": "sounder", "summary": "Measures depth",
    "does": "measures the depth", "model": Sounder, "values": (Value("depth", "depth"),),
    "kind": LENGTH, "measure": None,
}  # fmt: skip
ROW = number_sensor(**FIELDS)


def found_with(row: object, monkeypatch: pytest.MonkeyPatch) -> tuple[Device, ...]:
    """Return all devices as if a package had this row; the tables of requests do not change."""
    of_devices = {request.name for device in devices() for request in device.requests}
    before = {name: code for name, code in CODES.items() if name not in of_devices}
    monkeypatch.setattr(registry, "CODES", before)
    monkeypatch.setattr(registry, "_of_other_packages", lambda: [("package:DEVICE", row)])
    monkeypatch.setattr(registry, "register", lambda _request: None)
    return devices.__wrapped__()


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ("a text", "not a crs_cc.sim.model.device.Device"),
        (replace(ROW, name="tilt"), "duplicate device name"),
        (number_sensor(**FIELDS | {"name": "age"}), "duplicate request name"),
        (replace(ROW, element="gps"), "duplicate device element"),
        (replace(ROW, number=6), "duplicate sensor number"),
        (replace(ROW, name="Depth"), "must be lower-case words"),
        (replace(ROW, element=""), "must be lower-case words"),
    ],
)
def test_an_invalid_row_is_rejected_with_the_reason(
    row: object, reason: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(DeviceError, match=reason):
        found_with(row, monkeypatch)


@pytest.mark.parametrize(
    ("field", "reason"),
    [
        ({"values": ()}, "the names of values"),
        ({"name": "Depth"}, "must be lower-case words"),
        ({"values": (Value("int", "a depth"),)}, "reserved in C"),
        ({"values": (Value("a", "one"), Value("a", "other"))}, "must be distinct"),
        ({"values": tuple(Value(f"v{n}", "") for n in range(9))}, "more than 8 values"),
        ({"kind": MASS}, "LENGTH or ANGLE"),
        ({"model": Value}, "lacks rate_hz or period_s"),
    ],
)
def test_an_invalid_sensor_is_rejected_with_the_reason(
    field: dict[str, object], reason: str
) -> None:
    with pytest.raises(ValueError, match=reason):
        number_sensor(**FIELDS | field)


def test_another_device_changes_no_number_of_ours(monkeypatch: pytest.MonkeyPatch) -> None:
    """Noise and cached programs depend on these."""
    found = found_with(ROW, monkeypatch)
    ours = [(row.name, row.number, row.stream, row.requests) for row in devices()]
    assert [row.name for row in found[:-1]] == [name for name, *_ in ours]
    for row, (_, number, stream, requests) in zip(found, ours, strict=False):
        assert (row.number, row.stream) == (number, stream)
        assert [each.code for each in row.requests] == [each.code for each in requests]
    assert found[-1].requests[0].code == REGISTERED[100]
    assert len({row.stream for row in found}) == len(found)
    codes = {request.code for row in devices() for request in row.requests}
    assert codes <= REQUESTS.keys()
