"""Changes to communication: links blocked and unblocked, messages sent by hand."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any, Final

from crs_cc.core.quantity import TIME
from crs_cc.debug.world.edit import Edit, Words
from crs_cc.sim.engine.inject import inject

if TYPE_CHECKING:
    from crs_cc.sim.engine.environment import Environment

_WAY: Final = "[CHANNEL] [from ROBOT] [to ROBOT]"
_SYNTAX: Final = {
    "shut": f"{_WAY} [at TIME] [for TIME]",
    "open": f"{_WAY} [at TIME]",
    "message": "ROBOT [to ROBOT] [on CHANNEL] [type NUMBER]: TEXT",
}
_NUMBER: Final = re.compile(r"-?\d{1,10}")


def _shut(environment: Environment, words: Words) -> str:
    link, times = _link_and_times(words, "shut")
    environment.communication.shut(
        **link, at_s=times.get("at", environment.time_s), duration_s=times.get("for")
    )
    return _status(link, "blocked", times)


def _open(environment: Environment, words: Words) -> str:
    link, times = _link_and_times(words, "open")
    environment.communication.open(**link, at_s=times.get("at"))
    return _status(link, "unblocked", times)


def _link_and_times(words: Words, name: str) -> tuple[dict[str, str], dict[str, float]]:
    """Return the link and the times that words describe: `radio from robot0 to robot1 at 5s`."""
    left, link, times, wrong = list(words), {}, {}, []
    is_all = left[:1] == ["all"]
    if left and left[0] not in ("from", "to", "at", "for"):
        word = left.pop(0)
        link = {} if is_all else {"channel": word}
    for word, role in (("from", "sender"), ("to", "receiver")):
        if len(left) > 1 and left[0] == word:
            link[role] = left[1]
            del left[:2]
    for word in ("at", "for") if name == "shut" else ("at",):
        if len(left) > 1 and left[0] == word:
            try:
                times[word] = _time_s(left[1])
            except ValueError as error:
                wrong.append(str(error))
            del left[:2]
    if wrong:
        raise ValueError("\n".join(wrong))
    if left or not (link or is_all):
        raise _wrong_words(name)
    return link, times


def _time_s(text: str) -> float:
    time_s = TIME.parse(text)
    if time_s < 0.0:
        raise ValueError(f"a time must not be negative: '{text[:20]}'")
    return time_s


def _link_text(link: dict[str, str]) -> str:
    parts = [link.get("channel", "every channel" if link else "every link")]
    parts += [f"from {link['sender']}"] if "sender" in link else []
    parts += [f"to {link['receiver']}"] if "receiver" in link else []
    return " ".join(parts)


def _status(link: dict[str, str], status: str, times: dict[str, float]) -> str:
    if "at" in times:
        text = f"{_link_text(link)} is {status} from {TIME.show(times['at'])} on"
    else:
        text = f"{_link_text(link)} is now {status}"
    return f"{text}, for {TIME.show(times['for'])}" if "for" in times else text


def _message(environment: Environment, words: Words) -> str:
    if len(words) < 2:
        raise _wrong_words("message")
    left, given = list(words[1:-1]), {}
    while len(left) > 1 and left[0] in ("to", "on", "type") and left[0] not in given:
        given[left[0]] = left[1]
        del left[:2]
    if left:
        raise _wrong_words("message")
    options: dict[str, Any] = {}
    if "on" in given:
        options["channel"] = given["on"]
    if "type" in given:
        if not _NUMBER.fullmatch(given["type"]):
            raise ValueError(f"{given['type'][:20]!r} is not a type (expected an integer)")
        options["kind"] = int(given["type"])
    content = words[-1].encode()
    inject(environment, words[0], content, given.get("to"), **options)
    return f"{words[0]} sends {len(content)} bytes to {given.get('to', 'all')}"


def _wrong_words(name: str) -> ValueError:
    return ValueError(f"expected: {name} {_SYNTAX[name]}")


MESSAGES: Final = {
    "shut": Edit(
        _SYNTAX["shut"],
        "Block messages that are sent from now on.",
        'shut all blocks every link. "at TIME" sets the start, "for TIME" the duration.',
        _shut,
    ),
    "open": Edit(
        _SYNTAX["open"],
        "Unblock a link that was blocked with the same arguments.",
        'With "at TIME", it is unblocked at that time.',
        _open,
    ),
    "message": Edit(
        _SYNTAX["message"],
        "Send a message, as if a robot's program had sent it.",
        "By default, it goes to all robots, on the channel radio and with type 0.",
        _message,
    ),
}
"""Changes by name."""
