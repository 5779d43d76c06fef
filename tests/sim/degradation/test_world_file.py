"""Degradations in world files: units, elements by number and name, and what is refused."""

import math

import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.model.degradation import Degradation
from tests.sim.driver import open_world

ROBOT = '<robot x="0" y="0"/>'


def read(attributes: str, robot: str = ROBOT) -> Degradation:
    (degradation,) = open_world(f"{robot}<degradation {attributes}/>").degradations
    return degradation


def test_all_attributes_are_read_in_the_units_of_the_device():
    told = read(
        'id="worn" robot="robot0" device="sonar" element="3" gain="0.5" bias="10in" noise="2cm"'
        ' step="1in" stuck="1ft" delay="200ms" dropouts="0.25" onset="10s" duration="5s"'
        ' recovery="500ms"'
    )
    assert told == Degradation(
        "robot0", "sonar", 3, 0.254, 0.5, 0.02, 0.0254, pytest.approx(0.3048), 0.2, 0.25,
        dead=False, onset_s=10.0, duration_s=5.0, recovery_s=0.5, id="worn",
    )  # fmt: skip


def test_what_is_not_given_is_sound_and_for_ever():
    assert read('robot="robot0" device="bumper" dead="yes"') == Degradation(
        "robot0", "bumper", dead=True, id="degradation0"
    )


@pytest.mark.parametrize(
    ("element", "number", "bias"), [("steering", 1, math.pi), ("2", 2, math.pi), ("0", 0, 180.0)]
)
def test_an_element_decides_the_unit_of_its_values(element, number, bias):
    nomad = '<robot x="0" y="0" definition="nomad200"/>'
    unit = "m/s" if number == 0 else "deg/s"
    told = read(f'robot="robot0" device="drive" element="{element}" bias="180{unit}"'
                .replace("180m", "100m"), nomad)  # fmt: skip
    assert (told.element, told.bias) == (number, pytest.approx(min(bias, 100.0)))


@pytest.mark.parametrize(
    ("attributes", "said"),
    [
        ('robot="r" device="sonar" dead="yes"', "robot: unknown robot 'r' (known: robot0)"),
        ('robot="robot0" device="radar" dead="yes"', "unknown device 'radar' (known: altitude"),
        ('robot="robot0" device="compass" dead="yes"', "the robot has no compass"),
        ('robot="robot0" device="compass" element="1" dead="yes"', "the robot has no compass"),
        ('robot="robot0" device="sonar" element="16" dead="yes"', "unknown '16' of sonar (known"),
        ('robot="robot0" device="drive" element="up" dead="yes"', "(known: 0 (right), 1 (left))"),
        ('robot="robot0" device="sonar"', "no fault given: set gain, bias"),
        ('robot="robot0" device="sonar" gain="1" bias="0m"', "no fault given"),
        ('robot="robot0" device="sonar" bias="3kg"', "bias: '3kg' is not a length"),
        ('robot="robot0" device="drive" bias="1m"', "bias: '1m' is not a speed"),
        ('robot="robot0" device="sonar" stuck="here"', "stuck: 'here' is not a length"),
        ('robot="robot0" device="sonar" noise="-1m"', "noise must be a number from 0"),
        ('robot="robot0" device="sonar" dropouts="1.5"', "dropouts must be a number from 0 to 1"),
        ('robot="robot0" device="sonar" delay="61s"', "delay must be a number from 0 to 60"),
        ('robot="robot0" device="sonar" gain="1e9"', "too large"),
        ('robot="robot0" device="sonar" dead="yes" onset="-1s"', "onset must be a number from 0"),
        ('robot="robot0" device="sonar" dead="yes" duration="-1s"', "duration must be a number"),
        ('robot="robot0" device="sonar" dead="perhaps"', "dead"),
        ('robot="robot0" dead="yes"', "missing attribute 'device' in <degradation>"),
        ('id="robot0" robot="robot0" device="sonar" dead="yes"', "duplicate id"),
    ],
)  # fmt: skip
def test_mistakes_are_told_with_their_line(attributes, said):
    with pytest.raises(WorldError) as wrong:
        open_world(f"{ROBOT}\n<degradation {attributes}/>")
    (message,) = wrong.value.diagnostics
    assert message.location.line == 2
    assert said in message.render()


def test_a_value_for_axes_of_different_units_needs_an_element():
    nomad = '<robot x="0" y="0" definition="nomad200"/>'
    with pytest.raises(WorldError, match=r"differ in unit .known: 0 \(translation\), 1"):
        read('robot="robot0" device="drive" bias="0.1m/s"', nomad)
    assert read('robot="robot0" device="drive" gain="0.5"', nomad).gain == 0.5


def test_too_many_for_our_memory_are_refused():
    laser = '<robot x="0" y="0" definition="nomad200"/>'
    one = '<degradation robot="robot0" device="sonar" delay="1s"/>'
    with pytest.raises(WorldError, match="too many degradations"):
        open_world(laser + one * 4200)
