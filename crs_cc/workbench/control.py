"""The control panel: changes of the run, what is in force, and how both are written out.

What the panel changes, it changes at the start of the timestep in which the run stands: so
`crs run --inputs` can make the same changes again, bit for bit. In runs that only go forward,
nothing is taken back.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from crs_cc.core.quantity import RATIO, TIME
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.position import BEGINNING, Position
from crs_cc.debug.world.edits import FAULTS
from crs_cc.sim.files.world_writer import fault_elements
from crs_cc.sim.files.xml_document import document_of
from crs_cc.sim.model.degradation import HOLD, degradables, described
from crs_cc.workbench.devices_in_view import phase_now

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from crs_cc.core.quantity import Kind
    from crs_cc.debug.engine import Debugger
    from crs_cc.debug.stop import Stop
    from crs_cc.debug.timeline.change import Change
    from crs_cc.sim.engine.environment import Environment
    from crs_cc.workbench.context import Context

_MAX_CHANGES: Final = 500
_MAX_FAULTS: Final = 500
_TIME_DIGITS: Final = 9  # far below a timestep, and too few for what rounding adds to a time
_TIMES: Final = frozenset({"delay", "onset", "duration", "recovery"})
_RATIOS: Final = frozenset({"gain", "dropouts"})


def edit(screen: Context, text: str) -> dict[str, str]:
    """Change the run; return what has changed, in words."""
    with screen.working():
        done = screen.run.edit(text, is_playing=screen.player.is_playing)
    return {"text": f"{done}."}


def begin(debugger: Debugger) -> Stop:
    """Go from the start of a run to the first statement, unless the program sleeps there."""
    session, robot = debugger.session, debugger.view.robot
    is_soon = session.state.clock_s[robot] < session.environment.timestep_s
    return debugger.start() if is_soon and session.state.alive[robot] else debugger.stop


def revert(screen: Context, number: int) -> None:
    """Undo a change and all later ones."""
    debugger = screen.run.shell().debugger
    screen.player.pause()
    with screen.working():
        debugger.revert(number)
        if debugger.position == BEGINNING:
            begin(debugger)


def switch(screen: Context, name: str) -> None:
    """Go to another branch of the run."""
    screen.player.pause()
    with screen.working():
        screen.run.switch(name)


def panel(environment: Environment, changes: Sequence[Change]) -> dict[str, Any]:
    """Return the changes, the degradations and the blocked links."""
    first = max(0, len(changes) - _MAX_CHANGES)
    return {
        "changes": [
            {"number": number, "t": _time_s(environment, each), "text": _about(environment, each)}
            for number, each in enumerate(changes[first:], first)
        ],
        "faults": list(_faults(environment))[:_MAX_FAULTS],
        "outages": [
            {"at": at_s, "until": until_s, "channel": channel, "from": sender, "to": receiver}
            for at_s, until_s, channel, sender, receiver in environment.communication.outages()
        ][:_MAX_FAULTS],
        "channels": [each.name for each in environment.world.communication.channels],
    }


def _faults(environment: Environment) -> Iterator[dict[str, Any]]:
    models = {robot.id: robot.model for robot in environment.world.robots}
    for each in environment.degradations.all():
        yield {
            "id": each.id,
            "robot": each.robot,
            "device": each.device,
            "element": each.element,
            "text": described(each, models[each.robot]),
            "phase": phase_now(environment, each),
            "onset": each.onset_s,
            "duration": each.duration_s,
            "recovery": each.recovery_s,
        }


def _about(environment: Environment, change: Change) -> str:
    is_variable = change.robot >= 0
    return f"{_name(environment, change.robot)}: {change.text}" if is_variable else change.text


def _name(environment: Environment, robot: int) -> str:
    """Return a robot's name; empty before it joins."""
    robots = environment.world.robots
    return robots[robot].id if robot < len(robots) else ""


def _time_s(environment: Environment, change: Change) -> float:
    return change.position.timestep * environment.world.timestep_s


def form(screen: Context, robot: int) -> dict[str, Any]:
    """Return the degradable devices of a robot and their laws: the fields of a form."""
    robots = screen.run.world.robots
    if not 0 <= robot < len(robots):
        raise DebugError(f"no robot {robot}")
    model = robots[robot].model
    found = []
    for device in degradables().values():
        names = device.elements(model)
        if not any(names):
            continue
        found.append(
            {
                "name": device.name,
                "title": device.title,
                "acts": device.acts,
                "nothing": device.nothing,
                "elements": [
                    [number, name, device.unit or device.kind_of(name).default]
                    for number, name in enumerate(names)
                    if name
                ],
                "example": device.kind.example,
            }
        )
    return {
        "robot": robots[robot].id,
        "devices": found,
        "fields": [_field(each) for each in FAULTS if each != "for"],
    }


def _field(name: str) -> dict[str, Any]:
    """Return a field of the form: its kind is that of the device unless it has its own."""
    own: Kind | None = TIME if name in _TIMES else RATIO if name in _RATIOS else None
    return {
        "name": name,
        "kind": "flag" if name == "dead" else "value",
        "unit": None if own is None else own.default,
        "word": HOLD if name == "stuck" else "",
        "is_time": name in {"onset", "duration", "recovery"},
    }


def export(screen: Context, form: str) -> dict[str, str]:
    """Return the changes as a script for `crs run --inputs`, or as XML for a world file."""
    environment = screen.run.session().environment
    if form == "xml":
        return {"name": "changes.xml", "text": _xml(environment)}
    if form == "inputs":
        return {"name": "changes.txt", "text": _script(environment, screen.run.changes())}
    raise DebugError(f"unknown form '{form[:20]}' (known: xml, inputs)")


def _xml(environment: Environment) -> str:
    known = {each.id for each in environment.world.degradations}
    more = [each for each in environment.degradations.all() if each.id not in known]
    own = fault_elements(environment.world, more, environment.communication.outages())
    return "".join(document_of(each).decode().partition("\n")[2] for each in own)


def _script(environment: Environment, changes: Sequence[Change]) -> str:
    """Return the changes as lines; those that cannot be repeated by it as comments that say so."""
    lines = ["# What was changed; to be made again by: crs run --inputs THIS-FILE PROGRAM WORLD"]
    for each in changes:
        line = f"{round(_time_s(environment, each), _TIME_DIGITS)}s: {each.text}"
        place = each.position
        if each.robot >= 0:
            name = _name(environment, each.robot)
            line = f"# a variable of {name}, only in recordings: {line}"
        elif place != Position(place.timestep, 0):
            line = f"# inside a timestep, only in recordings: {line}"
        lines.append(line)
    return "\n".join(lines) + "\n"
