"""The device registry: which rows it accepts, and the numbers that it assigns."""

from __future__ import annotations

from dataclasses import replace

import pytest

from crs_cc.core.errors import DeviceError
from crs_cc.core.quantity import MASS
from crs_cc.requests import CODES, REGISTERED, REQUESTS
from crs_cc.sim.model import registry
from crs_cc.sim.model.device import Device, Value
from crs_cc.sim.model.registry import device, devices

ROW = replace(device("altitude"), name="depth", element="sounder", number=-1, code=-1, stream=-1)


def found_with(row: object, monkeypatch: pytest.MonkeyPatch) -> tuple[Device, ...]:
    """Return all devices as if a package had this row; the tables of requests do not change."""
    before = {name: code for name, code in CODES.items() if code not in REGISTERED}
    monkeypatch.setattr(registry, "CODES", before)
    monkeypatch.setattr(registry, "_of_other_packages", lambda: [("package:DEVICE", row)])
    monkeypatch.setattr(registry, "register", lambda _request: None)
    return devices.__wrapped__()


@pytest.mark.parametrize(
    ("row", "reason"),
    [
        ("a text", "not a crs_cc.sim.model.device.Device"),
        (replace(ROW, name="tilt"), "duplicate device name"),
        (replace(ROW, name="camera"), "the name is that of a request"),
        (replace(ROW, element="gps"), "duplicate device element"),
        (replace(ROW, number=6), "duplicate sensor number"),
        (replace(ROW, name="Depth"), "must be lower-case words"),
        (replace(ROW, values=()), "the names of its values"),
        (replace(ROW, values=(Value("int", "a depth"),)), "reserved in C"),
        (replace(ROW, values=(Value("a", "one"), Value("a", "other"))), "must be distinct"),
        (replace(ROW, values=tuple(Value(f"v{n}", "") for n in range(9))), "more than 8 values"),
        (replace(ROW, kind=MASS), "LENGTH or ANGLE"),
        (replace(ROW, model=Value), "lacks rate_hz or period_s"),
    ],
)
def test_an_invalid_row_is_rejected_with_the_reason(
    row: object, reason: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(DeviceError, match=reason):
        found_with(row, monkeypatch)


def test_another_device_changes_no_number_of_ours(monkeypatch: pytest.MonkeyPatch) -> None:
    """Noise and cached programs depend on these."""
    found = found_with(ROW, monkeypatch)
    assert found[:-1] == devices()
    assert found[-1].code == REGISTERED[100]
    assert len({row.stream for row in found}) == len(found)
    assert {row.code for row in devices()} <= REQUESTS.keys()
