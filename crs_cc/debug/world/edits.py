"""Commands that change the world: `move robot0 to 1 2 90`.

Each is validated before anything changes. Numbers are in metres and degrees, or have a unit as
in world files. `EDITS` is the table of changes; the help is generated from it.

>>> from crs_cc.sim.engine.environment import Environment
>>> from crs_cc.sim.files.world_xml import empty_world
>>> environment = Environment(empty_world(), seed=1)
>>> edit(environment, "move robot0 to 1 2 90")
'robot0 is now at 1.000, 2.000 m, 90.0 deg'
>>> edit(environment, "degrade robot0 sonar.3 noise 5cm dropouts 0.1")
'robot0: sonar 3, noise 0.05m, dropouts 0.1 (degradation0)'
>>> edit(environment, "heal robot0")
'robot0 no longer has degradation0'
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

from crs_cc.core.quantity import ANGLE, HEAT, TIME
from crs_cc.core.source import Diagnostics
from crs_cc.core.suggest import unknown
from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.edit import Edit, Words, find_robot, pose_of
from crs_cc.debug.world.message_edits import MESSAGES
from crs_cc.debug.world.rows import angle, instant, pose_text
from crs_cc.debug.world.steering_edits import STEERING
from crs_cc.sim.files.degradation_elements import degradation
from crs_cc.sim.files.document import Element, Reader
from crs_cc.sim.model.degradation import Degradation, degradables, described
from crs_cc.sim.model.fields import MIN_EVAPORATION_S, NEVER_S
from crs_cc.sim.model.world import Pose, Robot

if TYPE_CHECKING:
    from crs_cc.sim.engine.environment import Environment

_MAX_WORDS: Final = 40
_MAX_LENGTH: Final = 60
_FLAGS: Final = {"dead": "yes", "stuck": "hold"}
_VALUES: Final = (
    "bias", "gain", "noise", "step", "stuck", "delay", "dropouts", "onset", "duration", "recovery",
)  # fmt: skip

FAULTS: Final = (*_VALUES, "dead", "for")
"""The keywords of faults and their times."""


def edit(environment: Environment, text: str) -> str:
    """Change the world; return a description of the change.

    Args:
        environment: the world, anywhere in a timestep.
        text: a change, as `EDITS` has them.

    Raises:
        DebugError: it is invalid or impossible; nothing has changed.
    """
    words = words_of(text)
    if not words:
        raise DebugError(f"missing change ({_choice()})")
    if len(words) > _MAX_WORDS:
        raise DebugError(f"a change has at most {_MAX_WORDS} words")
    if words[0] not in EDITS:
        raise DebugError(f"{words[0][:_MAX_LENGTH]!r} is not a change of the world ({_choice()})")
    wanted = EDITS[words[0]]
    try:
        return wanted.do(environment, words[1:])
    except ValueError as wrong:
        raise DebugError(str(wrong)) from None


def words_of(text: str) -> list[str]:
    """Return the words of a change; the content of a message, after a colon, is one.

    >>> words_of("message a to b: go = now"), words_of("degrade a sonar gain=0.5")
    (['message', 'a', 'to', 'b', 'go = now'], ['degrade', 'a', 'sonar', 'gain', '0.5'])
    """
    head, colon, content = text.partition(":")
    if colon and head.split()[:1] == ["message"]:
        return [*head.split(), content.strip()]
    return text.replace("=", " ").split()


def _choice() -> str:
    return f"expected {', '.join(EDITS)}"


def _wrong_words(name: str) -> ValueError:
    return ValueError(f"expected: {name} {EDITS[name].syntax}")


# -- poses -----------------------------------------------------------------------------------------


def _move(environment: Environment, words: Words) -> str:
    if len(words) not in (4, 5) or words[1] != "to":
        raise _wrong_words("move")
    name = _name(environment, words[0])
    place = pose_of(words[2:], _heading_rad(environment, name))
    environment.teleport(name, place)
    return f"{name} is now at {pose_text(place.x_m, place.y_m, place.heading_rad)}"


def _turn(environment: Environment, words: Words) -> str:
    if len(words) != 3 or words[1] != "to":
        raise _wrong_words("turn")
    name = _name(environment, words[0])
    place = _pose(environment, name, ANGLE.parse(words[2]))
    environment.teleport(name, place)
    return f"{name} now has heading {angle(place.heading_rad)}"


def _remove(environment: Environment, words: Words) -> str:
    if len(words) != 1:
        raise _wrong_words("remove")
    name, robots = words[0], [robot.id for robot in environment.world.robots]
    if name in robots:
        environment.dismiss_robot(robots.index(name))
        return f"{name} leaves the world at {instant(environment.end_s)}"
    environment.remove_obstacle(name)
    return f"{name} is removed"


def _name(environment: Environment, name: str) -> str:
    """Return the name of a robot or movable object; refuse others."""
    known = (*(robot.id for robot in environment.world.robots), *environment.pushables)
    if name not in known:
        if name in environment.names:
            raise ValueError(f"{name!r} cannot be moved (movable: {', '.join(known[:20])})")
        raise ValueError(unknown("robot or movable object", name, known))
    return name


def _pose(environment: Environment, name: str, heading_rad: float) -> Pose:
    """Return the position of a movable object with a new heading."""
    x_m, y_m = environment.state.bodies.position_m[environment.names.index(name)].tolist()
    return Pose(x_m, y_m, heading_rad)


def _heading_rad(environment: Environment, name: str) -> float:
    state, body = environment.state, environment.names.index(name)
    is_robot = body < len(environment.world.robots)
    return float((state.heading_rad if is_robot else state.bodies.angle_rad)[body])


# -- what is wrong with devices --------------------------------------------------------------------


def _degrade(environment: Environment, words: Words) -> str:
    if len(words) < 3:
        raise _wrong_words("degrade")
    robot = find_robot(environment, words[0])
    attributes = {"robot": robot.id, **_device(words[1]), **_faults(words[2:])}
    diagnostics = Diagnostics()
    element = Element("degrade", 1, attributes)
    found = degradation(element, robot.model, Reader("", diagnostics))
    if found is None:
        texts = (each.text.removeprefix("degrade, ") for each in diagnostics.messages)
        raise ValueError("\n".join(texts))
    name = environment.degradations.add(found)
    return f"{robot.id}: {described(found, robot.model)} ({name})"


def _faults(words: Words) -> dict[str, str]:
    """Return the attributes of a `<degradation>` for some words."""
    attributes: dict[str, str] = {}
    left = list(words)
    while left:
        word = left.pop(0)
        if word not in FAULTS:
            raise ValueError(unknown("fault", word, FAULTS))
        has_value = bool(left) and left[0] not in FAULTS
        if word in _FLAGS and not has_value:
            attributes[word] = _FLAGS[word]
        elif word == "dead" or not has_value:
            raise ValueError(f"'{word}' {'takes no' if word == 'dead' else 'needs a'} value")
        else:
            attributes["duration" if word == "for" else word] = left.pop(0)
    return attributes


def _device(text: str) -> dict[str, str]:
    """Return the attributes for a device, `sonar`, or for one of its elements, `sonar.3`."""
    device, dot, element = text.partition(".")
    return {"device": device, "element": element} if dot else {"device": device}


def _heal(environment: Environment, words: Words) -> str:
    """Remove degradations: one by its name, or all of a robot, a device or an element."""
    if len(words) not in (1, 2):
        raise _wrong_words("heal")
    control = environment.degradations
    own = [each for each in control.all() if each.id == words[0]] if len(words) == 1 else []
    if own:
        robot = find_robot(environment, own[0].robot)
    else:
        robot = find_robot(environment, words[0])
        own = [each for each in control.all() if each.robot == robot.id]
        if len(words) == 2:
            own = [each for each in own if _concerns(each, robot, words[1])]
    if not own:
        raise ValueError(f"no degradation of {robot.id}{''.join(f' {x}' for x in words[1:])}")
    for each in own:
        control.remove(each.id)
    return f"{robot.id} no longer has {', '.join(each.id for each in own)}"


def _concerns(each: Degradation, robot: Robot, text: str) -> bool:
    """Return whether a degradation concerns a device or its element."""
    device, _, element = text.partition(".")
    if device not in degradables():
        raise ValueError(unknown("device", device, tuple(degradables())))
    if each.device != device:
        return False
    names = degradables()[device].elements(robot.model)
    own = "" if each.element is None else names[each.element]
    return not element or element in {own, str(each.element)}


# -- energy and heat ------------------------------------------------------------------------


def _charge(environment: Environment, words: Words) -> str:
    if len(words) != 2:
        raise _wrong_words("charge")
    robot = find_robot(environment, words[0])
    text = words[1].removesuffix("%")
    percent = float(text) if text.replace(".", "", 1).isdigit() else math.nan
    if not 0.0 <= percent <= 100.0:
        text = f"{words[1][:_MAX_LENGTH]!r} is not a state of charge (expected 0 to 100 percent)"
        raise ValueError(text)
    environment.charge(environment.world.robots.index(robot), percent / 100)
    return f"{robot.id}'s motor battery is now at {percent:g}%"


def _heat(environment: Environment, words: Words) -> str:
    if len(words) != 2:
        raise _wrong_words("heat")
    name = words[0]
    if name not in environment.names:
        raise ValueError(unknown("object", name, environment.names))
    heat = HEAT.parse(words[1])
    if heat < 0.0:
        raise ValueError("heat must not be negative")
    environment.set_heat(name, heat)
    return f"{name} now has a heat of {heat:g}"


def _evaporate(environment: Environment, words: Words) -> str:
    if len(words) != 2:
        raise _wrong_words("evaporate")
    evaporation_s = NEVER_S if words[1] == "never" else TIME.parse(words[1])
    if evaporation_s < MIN_EVAPORATION_S:
        raise ValueError(f"the evaporation time must be {TIME.show(MIN_EVAPORATION_S)} or more")
    environment.set_evaporation(words[0], evaporation_s)
    how = "no longer evaporates" if words[1] == "never" else f"now evaporates in {words[1]}"
    return f"field {words[0]} {how}"


EDITS: Final = {
    "move": Edit(
        "NAME to X Y [HEADING]",
        "Move a robot or a movable object to a free place.",
        "As if by hand: a robot's odometry does not change, its motors keep running, and what"
        " it holds stays behind. X and Y are in metres, HEADING in degrees counter-clockwise from"
        " the x axis; all may have units.",
        _move,
    ),
    "turn": Edit(
        "NAME to HEADING", "Turn a robot or a movable object in place.", "As if by hand.", _turn
    ),
    "remove": Edit(
        "NAME",
        "Remove an object or a robot from the world.",
        "Objects vanish at once; a robot leaves at the end of the timestep, and its program ends.",
        _remove,
    ),
    "degrade": Edit(
        "ROBOT DEVICE[.ELEMENT] FAULT...",
        "Degrade a device of a robot: degrade robot0 sonar.3 dead.",
        "Faults and units are as in world files: dead, stuck [VALUE], bias VALUE, gain VALUE,"
        " noise VALUE, step VALUE, delay TIME, dropouts FRACTION; timing: onset TIME, for TIME,"
        " recovery TIME.",
        _degrade,
    ),
    "heal": Edit(
        "ROBOT [DEVICE[.ELEMENT]]",
        "Remove the degradations of a robot or of one of its devices.",
        "A single degradation can be removed by its name.",
        _heal,
    ),
    "charge": Edit(
        "ROBOT PERCENT", "Set the state of charge of a robot's motor battery.", "", _charge
    ),
    "heat": Edit("NAME HEAT", "Set the heat of a robot or an object.", "", _heat),
    "evaporate": Edit(
        "FIELD TIME", "Set the evaporation time of a pheromone field, or `never`.", "", _evaporate
    ),
    **STEERING,
    **MESSAGES,
}
"""All changes by name."""
