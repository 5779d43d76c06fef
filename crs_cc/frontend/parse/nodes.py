"""Nodes of the syntax tree that pycparser has no class for: GNU C's, and broken code."""

from __future__ import annotations

from typing import Any, Final, TypeAlias

from pycparser import c_ast

Node: TypeAlias = Any
"""A node of pycparser's tree."""

TYPE_ARGUMENTS: Final = frozenset({"__builtin_types_compatible_p"})
"""Functions whose arguments are types."""

AUTO_TYPE: Final = "__auto_type"
"""The type specifier for the type of a variable's initial value."""

PREDECLARED_TYPES: Final = ("__builtin_va_list", AUTO_TYPE)
"""Type names that every file knows."""


class OwnNode(c_ast.Node):  # type: ignore[misc]
    """A node whose children are not visited by pycparser's visitors."""

    __slots__ = ("coord",)

    def __init__(self, coord: Any) -> None:
        self.coord = coord

    def children(self) -> tuple[()]:
        """Return no nodes."""
        return ()


class Broken(OwnNode):
    """A declaration or statement with a syntax error.

    Attributes:
        names: the names in it, which it may have declared.
    """

    __slots__ = ("names",)

    def __init__(self, names: list[str], coord: Any) -> None:
        super().__init__(coord)
        self.names = names


class LabelAddress(OwnNode):
    """`&&name`."""

    __slots__ = ("name",)

    def __init__(self, name: str, coord: Any) -> None:
        super().__init__(coord)
        self.name = name


class ComputedGoto(OwnNode):
    """`goto *target;`."""

    __slots__ = ("target",)

    def __init__(self, target: Any, coord: Any) -> None:
        super().__init__(coord)
        self.target = target


class LocalLabels(OwnNode):
    """`__label__ names;`: labels that are local to the block."""

    __slots__ = ("names",)

    def __init__(self, names: list[str], coord: Any) -> None:
        super().__init__(coord)
        self.names = names


class StatementExpression(OwnNode):
    """`({ ... })`."""

    __slots__ = ("body",)

    def __init__(self, body: Any, coord: Any) -> None:
        super().__init__(coord)
        self.body = body


class Range(OwnNode):
    """`first ... last`, in a `case` or a designator."""

    __slots__ = ("first", "last")

    def __init__(self, first: Any, last: Any, coord: Any) -> None:
        super().__init__(coord)
        self.first = first
        self.last = last


class Prototype(OwnNode):
    """The declaration of a function in one of our headers, which several programs share.

    Attributes:
        declaration: the declaration.
        known: the type of the function and those of the type names in it, in an earlier program,
            if they can be the same in another one.
        is_checked: whether an earlier program had it.
    """

    __slots__ = ("declaration", "is_checked", "known")

    def __init__(self, declaration: Any) -> None:
        super().__init__(declaration.coord)
        self.declaration = declaration
        self.known: tuple[Any, dict[str, Any]] | None = None
        self.is_checked = False
