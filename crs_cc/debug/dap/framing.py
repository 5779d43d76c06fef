"""Message framing: a header with `Content-Length`, an empty line, JSON.

After a malformed header the stream is unusable, as the start of the next message is
unknown: `BrokenStreamError`. If a message is not valid JSON the next can still be read:
`BadMessageError`.

>>> import io
>>> stream = io.BytesIO(encode({"seq": 1, "type": "request", "command": "threads"}))
>>> read_message(stream)
{'seq': 1, 'type': 'request', 'command': 'threads'}
>>> read_message(stream) is None
True
"""

from __future__ import annotations

import json
from typing import Any, BinaryIO, Final, NoReturn

MAX_LINE_LENGTH: Final = 1024  # of a header [bytes]; chosen by us, real ones have 25
MAX_LINES: Final = 16  # of a header; chosen by us, real ones have one
MAX_MESSAGE_BYTES: Final = 8 * 2**20  # that is read [bytes]; chosen by us, real ones have some kB

Message = dict[str, Any]


class BrokenStreamError(Exception):
    """The stream violates the protocol; nothing that follows can be read."""


class BadMessageError(Exception):
    """A message is malformed."""


def encode(message: Message) -> bytes:
    """Return the encoded message.

    JSON is restricted to ASCII, so that any output or file name can be sent.
    """
    body = json.dumps(message, separators=(",", ":")).encode("ascii")
    return b"Content-Length: %d\r\n\r\n%b" % (len(body), body)


def read_message(stream: BinaryIO, most: int = MAX_MESSAGE_BYTES) -> Message | None:
    """Read the next message; return None at the end of the stream.

    Args:
        stream: what it is read from.
        most: the most bytes of a message.

    Raises:
        BrokenStreamError: the header is not the protocol's, or the stream ends within a message.
        BadMessageError: the message is not a JSON object.
    """
    size = _read_size(stream, most)
    if size is None:
        return None
    body = stream.read(size)
    if len(body) < size:
        raise BrokenStreamError(f"the stream ended {size - len(body)} bytes before its message did")
    return _decode(body)


def _read_size(stream: BinaryIO, most: int) -> int | None:
    """Read a header; return its `Content-Length`, or None at the end of the stream."""
    size: int | None = None
    for number in range(MAX_LINES):
        line = stream.readline(MAX_LINE_LENGTH)
        if not line and number == 0:
            return None
        if not line.endswith(b"\n"):
            raise BrokenStreamError("the stream ended in a header, or has none")
        field = line.strip()
        if not field:
            if size is None:
                raise BrokenStreamError("a header has no Content-Length")
            return size
        name, colon, value = field.partition(b":")
        if not colon:
            raise BrokenStreamError("a line of a header has no colon")
        if name.strip().lower() == b"content-length":
            size = _size(value.strip(), most)
    raise BrokenStreamError(f"a header has more than {MAX_LINES} lines")


def _size(digits: bytes, most: int) -> int:
    if not digits.isdigit() or len(digits) > 10 or int(digits) > most:
        raise BrokenStreamError(f"Content-Length must be a number up to {most}")
    return int(digits)


def _decode(body: bytes) -> Message:
    try:
        message = json.loads(body.decode("utf-8"), parse_constant=_refuse_constant)
    except (ValueError, RecursionError) as error:  # of decoding bytes, JSON, or too many digits
        raise BadMessageError(f"a message is not valid JSON: {error}") from None
    if not isinstance(message, dict):
        raise BadMessageError("a message is not a JSON object")
    return message


def _refuse_constant(name: str) -> NoReturn:
    raise ValueError(f"{name} is not a number in JSON")
