"""Find the point at which parsing can continue after a syntax error."""

from __future__ import annotations

from crs_cc.frontend.parse.nodes import Broken
from crs_cc.frontend.parse.token_stream import NAMES, TokenStream


def skip_broken(stream: TokenStream, start: int, *, is_in_block: bool) -> Broken:
    """Move after the end of a declaration or statement with an error.

    Args:
        stream: the tokens, at the error.
        start: the position where the declaration or statement starts.
        is_in_block: whether it is in a block, whose `}` is not skipped.

    Returns:
        A node for the skipped tokens.
    """
    stop, stream.index, depth = stream.index, start, 0
    broken = Broken([], stream.buffer[start])
    while (token := stream.buffer[stream.index]) is not None:
        if token.type == "RBRACE" and depth == 0 and is_in_block:
            break
        stream.index += 1
        if token.type in NAMES and depth == 0:
            broken.names.append(token.value)
        depth += {"LBRACE": 1, "RBRACE": -1}.get(token.type, 0)
        is_end = token.type in {"SEMI", "RBRACE"} and depth <= 0
        if is_end and stream.index >= stop:
            following = stream.buffer[stream.index]
            if token.type == "SEMI" or following is None or following.type != "SEMI":
                break
    return broken
