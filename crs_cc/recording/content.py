r"""Bytes in JSON: as text if they are UTF-8, otherwise in base64.

>>> content_of({"text": "bump"}), content_of({"base64": "/w=="})
(b'bump', b'\xff')
"""

from __future__ import annotations

import binascii
from base64 import b64decode, b64encode
from collections.abc import Mapping
from typing import Any


def as_fields(content: bytes) -> dict[str, str]:
    """Return the field that holds bytes."""
    try:
        return {"text": content.decode("utf-8")}
    except UnicodeDecodeError:
        return {"base64": b64encode(content).decode("ascii")}


def content_of(data: Mapping[str, Any]) -> bytes:
    """Return the bytes in a message; raise ValueError if it has none."""
    text, coded = data.get("text"), data.get("base64")
    if isinstance(text, str):
        return text.encode("utf-8", "replace")
    if isinstance(coded, str):
        try:
            return b64decode(coded, validate=True)
        except binascii.Error:
            raise ValueError("a message is not valid base 64") from None
    raise ValueError("a message has neither text nor base64")
