"""The simulation's mathematical functions: accuracy, shapes, and the checked build."""

from __future__ import annotations

import threading
from typing import Any

import numpy as np
import pytest

from crs_cc.sim.kernels import exact, program
from crs_cc.sim.kernels.program import BLOCK, Kernels

UNARY = ("sin", "cos", "tan", "arcsin", "arccos", "arctan", "exp", "exp2", "log")
BINARY = ("arctan2", "power", "hypot")


def arguments(count: int) -> tuple[Any, Any]:
    random = np.random.default_rng(5)
    return random.uniform(0.01, 1.0, count), random.uniform(-3.0, 3.0, count)


@pytest.mark.parametrize("name", UNARY)
def test_functions_of_one_number_are_those_of_numpy(name: str) -> None:
    x, _ = arguments(1000)
    np.testing.assert_array_max_ulp(getattr(exact, name)(x), getattr(np, name)(x), 4)
    assert getattr(exact, name)(float(x[7])) == getattr(exact, name)(x)[7]


@pytest.mark.parametrize("name", BINARY)
def test_functions_of_two_numbers_are_those_of_numpy(name: str) -> None:
    x, y = arguments(1000)
    found = getattr(exact, name)(x, y)
    np.testing.assert_array_max_ulp(found, getattr(np, name)(x, y), 4)
    assert getattr(exact, name)(float(x[7]), float(y[7])) == found[7]


def test_complex_functions_are_those_of_numpy() -> None:
    x, y = arguments(500)
    z = x + 1j * y
    np.testing.assert_allclose(exact.product(z, z[::-1]), z * z[::-1], rtol=1e-15)
    np.testing.assert_allclose(exact.turn(y), np.exp(1j * y), rtol=1e-15)
    np.testing.assert_array_max_ulp(exact.magnitude(z), np.abs(z), 2)
    np.testing.assert_array_max_ulp(exact.angle(z), np.angle(z), 2)
    one = complex(z[3])
    assert exact.product(one, 2 - 1j) == exact.product(z, 2 - 1j)[3]
    assert exact.turn(0.5) == exact.turn(np.array([0.5]))[0]
    assert exact.magnitude(one) == exact.magnitude(z)[3]


def test_directions_are_cosine_and_sine_to_the_bit() -> None:
    random, odd = np.random.default_rng(6), [0.0, -0.0, 1e-9, -1e-9, np.inf, -np.inf, np.nan]
    turns = np.arange(-9, 10) * np.pi / 4
    x = np.concatenate([random.uniform(-9, 9, 5000), turns, random.normal(0, 1e9, 500), odd])
    found = exact.turn(x)
    assert np.ascontiguousarray(found.real).tobytes() == exact.cos(x).tobytes()
    assert np.ascontiguousarray(found.imag).tobytes() == exact.sin(x).tobytes()


def test_arrays_broadcast_and_keep_their_shapes() -> None:
    column, row = np.ones((3, 1)), np.arange(4.0)
    assert exact.arctan2(column, row).shape == (3, 4)
    assert exact.product(column + 0j, row + 0j).tolist() == [[0, 1, 2, 3]] * 3
    assert exact.sin(np.zeros((2, 0))).shape == (2, 0)
    assert exact.sin(np.array(0.0)).shape == ()
    assert exact.cos(np.array([0, 1])).shape == (2,)
    assert exact.sin(np.arange(8.0)[::-2]).tolist() == exact.sin(np.arange(8.0))[::-2].tolist()


def test_arrays_may_be_longer_than_a_block() -> None:
    long = np.linspace(-3.0, 3.0, 2 * BLOCK + 5).reshape(-1, 1)
    found = exact.sin(long)
    assert found.shape == long.shape
    np.testing.assert_allclose(found, np.sin(long), atol=1e-15)
    assert exact.arctan2(long, 1.0)[-1, 0] == exact.arctan2(3.0, 1.0)


def test_infinities_and_what_is_no_number() -> None:
    assert np.isnan(exact.sin(np.inf))
    assert exact.exp2(-np.inf) == 0.0
    assert np.isnan(exact.arccos(np.array([2.0, 0.5]))).tolist() == [True, False]


def test_every_thread_has_an_instance_of_its_own() -> None:
    found: list[Kernels] = []
    thread = threading.Thread(target=lambda: found.append(program.kernels()))
    thread.start()
    thread.join()
    assert found[0] is not program.kernels()
    assert program.kernels() is program.kernels()


def test_the_checked_build_computes_the_same_without_an_error(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    x, y = arguments(200)
    ours = [getattr(exact, name)(x) for name in UNARY]
    ours += [getattr(exact, name)(x, y) for name in BINARY] + [exact.turn(y)]
    checked = Kernels(checked=True)
    monkeypatch.setattr(exact, "kernels", lambda: checked)
    theirs = [getattr(exact, name)(x) for name in UNARY]
    theirs += [getattr(exact, name)(x, y) for name in BINARY] + [exact.turn(y)]
    assert all((one == other).all() for one, other in zip(ours, theirs, strict=True))
