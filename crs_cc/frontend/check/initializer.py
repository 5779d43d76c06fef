"""Check initialisers (C17 6.7.9): braces, omitted braces, designators, strings.

The result is a flat list of values with their offsets. Nested aggregates are filled with a stack
of places, one for each open aggregate.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check import constant, tree
from crs_cc.frontend.check.checker import CheckError, Unit, expression
from crs_cc.frontend.check.conversion import assigned
from crs_cc.frontend.check.declarator import LARGEST_OBJECT
from crs_cc.frontend.check.scope import ObjectSymbol
from crs_cc.frontend.check.tree import Initialiser, InitialValue
from crs_cc.frontend.check.type_compat import compatible
from crs_cc.frontend.parse.nodes import Node, Range
from crs_cc.frontend.preprocess.options import is_c23
from crs_cc.ir.types import (
    INT,
    ArrayType,
    CType,
    IntegerType,
    Member,
    RecordType,
    is_complete,
    is_complex,
    unqualified,
)

MAX_VALUES: Final = 1 << 20
"""The maximum number of values from designated ranges: each takes memory in the compiler."""

LARGEST_INITIALISED: Final = 1 << 26
"""The maximum size of an initialised object [bytes]: the compiler keeps its image in memory."""


@dataclass(slots=True, eq=False)
class _Part:
    """A subobject: its offset, type and bit-field."""

    type: CType
    offset: int
    member: Member | None = None


@dataclass(slots=True, eq=False)
class _Place:
    """An aggregate that is being filled, and the index of its next part."""

    type: ArrayType | RecordType
    offset: int
    index: int = 0
    is_chosen: bool = False

    def part(self) -> _Part | None:
        """Return the next part, None after the last."""
        if isinstance(self.type, ArrayType):
            if self.type.length is not None and self.index >= self.type.length:
                return None
            element = self.type.element
            return _Part(element, self.offset + self.index * element.size)
        members = self.type.record.members or []
        while self.index < len(members) and _is_padding(members[self.index]):
            self.index += 1
        first = next((i for i, member in enumerate(members) if not _is_padding(member)), 0)
        is_full = self.type.record.kind == "union" and self.index > first
        if self.index >= len(members) or (is_full and not self.is_chosen):
            return None
        member = members[self.index]
        is_field = member.bit_width is not None
        return _Part(member.type, self.offset + member.offset, member if is_field else None)

    def choose(self, index: int) -> None:
        """Select the part that a designator denotes."""
        self.index = index
        self.is_chosen = True

    def advance(self) -> None:
        """Select the next part."""
        self.index += 1
        self.is_chosen = False


def _compute_once(each: InitialValue) -> None:
    """Store a value that is needed several times in a variable, unless it is constant."""
    value = each.value
    if isinstance(value, tree.Literal | tree.StringLiteral):
        return
    if constant.constant_address(value) is None:
        is_record = isinstance(value.type, RecordType)
        kept = ObjectSymbol("", value.type, value.location, in_memory=is_record)
        name = tree.ObjectName(value.type, value.location, kept)
        each.value = tree.Assign(value.type, value.location, name, value)


def _reused(value: tree.Expression) -> tree.Expression:
    """Return a value of `_compute_once` for another element."""
    return value.target if isinstance(value, tree.Assign) else value


def _is_padding(member: Member) -> bool:
    return member.name is None and member.bit_width is not None


def initialise(unit: Unit, ctype: CType, node: Node, is_static: bool) -> tuple[Initialiser, CType]:
    """Check an initialiser.

    Args:
        unit: receives warnings.
        ctype: the object's type; the length of an array may be unknown.
        node: the initialiser.
        is_static: whether every value must be constant.

    Returns:
        The values, and the type with its length.

    Raises:
        CheckError: it has an error.
    """
    unit.static_initialisers += is_static
    try:
        return _initialise(unit, ctype, node, is_static)
    finally:
        unit.static_initialisers -= is_static


def known_value(initialiser: Initialiser, ctype: CType) -> int | float | None:
    """Return the value of a `const` scalar with an initialiser, None if it is not a constant."""
    if not ctype.const or ctype.volatile or len(initialiser.values) != 1:
        return None
    value = initialiser.values[0].value
    is_plain = isinstance(value, tree.Literal) and not isinstance(ctype, ArrayType | RecordType)
    return value.value if is_plain and isinstance(value, tree.Literal) else None


def _initialise(unit: Unit, ctype: CType, node: Node, is_static: bool) -> tuple[Initialiser, CType]:
    filler = _Filler(unit, is_static)
    if isinstance(node, c_ast.InitList):
        filler.braced(_Part(ctype, 0), node)
        result = Initialiser(filler.values, True, filler.reached)
    else:
        value = expression(unit, node)
        if not filler.whole(_Part(ctype, 0), value):
            if isinstance(ctype, ArrayType):
                raise CheckError(
                    unit.at(node), "array initializer must be an initializer list or string"
                )
            filler.scalar(_Part(ctype, 0), value)
        result = Initialiser(filler.values, filler.has_gaps)
    if isinstance(ctype, ArrayType) and ctype.length is None:
        ctype = ArrayType(ctype.element, filler.length)
    if ctype.size > (LARGEST_INITIALISED if is_static else LARGEST_OBJECT):
        raise CheckError(unit.at(node), "initialized object is too large")
    if is_static:
        _need_constants(result)
    return result, ctype


def _need_constants(initialiser: Initialiser) -> None:
    for each in initialiser.values:
        value = each.value
        if isinstance(value, tree.Literal):
            continue
        if isinstance(each.type, ArrayType) and isinstance(value, tree.StringLiteral):
            continue
        if constant.constant_address(value) is None:
            raise CheckError(value.location, "initializer element is not a compile-time constant")


class _Filler:
    """A walk through an initialiser that collects its values.

    Attributes:
        length: the number of elements so far of an outermost array without length.
        reached: the end of the furthest value [bytes]; nothing after it can be overridden.
        has_gaps: whether the rest must become zero although there are no braces.
    """

    def __init__(self, unit: Unit, is_static: bool) -> None:
        self.unit = unit
        self.is_static = is_static
        self.has_gaps = False
        self.values: list[InitialValue] = []
        self.length = 0
        self.reached = 0

    def braced(self, part: _Part, node: Node) -> None:
        """Initialise a part with `{...}`."""
        ctype = part.type
        if not isinstance(ctype, ArrayType | RecordType) or is_complex(ctype):
            self._braced_scalar(part, node)
            return
        if not is_complete(ctype) and not isinstance(ctype, ArrayType):
            raise CheckError(self.unit.at(node), f"initializer for incomplete type '{ctype}'")
        self._override(part)
        if self._braced_string(part, node):
            return
        places = [_Place(ctype, part.offset)]
        for item in node.exprs:
            if not isinstance(item, c_ast.NamedInitializer):
                self._item(places, item)
                self._measure(places[0])
                continue
            del places[1:]
            ranges = self._designate(places, item.name)
            self._item_for_all(places, item.expr, ranges)
            self._measure(places[0])

    def _item_for_all(
        self, places: list[_Place], node: Node, ranges: list[tuple[_Place, int]]
    ) -> None:
        """Initialise the next part, and all others in designated ranges."""
        if not ranges:
            self._item(places, node)
            return
        shifts, part, before = [0], places[-1].part(), set(map(id, self.values))
        for place, count in ranges:
            if len(shifts) * count > MAX_VALUES:
                raise CheckError(self.unit.at(node), "designated range is too large")
            assert isinstance(place.type, ArrayType)
            size = place.type.element.size
            shifts = [shift + number * size for shift in shifts for number in range(count)]
        self._item(places, node)
        values = [each for each in self.values if id(each) not in before]
        if len(values) * len(shifts) > MAX_VALUES:
            raise CheckError(self.unit.at(node), "designated range is too large")
        for each in values:
            _compute_once(each)
        for shift in shifts[1:]:
            if part is not None and isinstance(node, c_ast.InitList):
                self._override(_Part(part.type, part.offset + shift))
            for each in values:
                offset, value = shift + each.offset, _reused(each.value)
                self._take(InitialValue(offset, each.type, value, each.member))
        for place, count in ranges:
            place.index += count - 1

    def _override(self, part: _Part) -> None:
        """Drop the earlier values of an aggregate that is initialised again (C17 6.7.9p19)."""
        end = part.offset + part.type.size
        if part.offset < self.reached:
            self.values = [each for each in self.values if not part.offset <= each.offset < end]

    def _take(self, value: InitialValue) -> None:
        self.values.append(value)
        self.reached = max(self.reached, value.offset + value.type.size)

    def _braced_scalar(self, part: _Part, node: Node) -> None:
        location = self.unit.at(node)
        if not node.exprs and is_c23(self.unit.standard):
            self.scalar(part, tree.integer(0, INT, location))
            return
        if not node.exprs:
            raise CheckError(location, "scalar initializer cannot be empty")
        if len(node.exprs) > 1:
            self.unit.warning(
                location, "excess elements in scalar initializer", flag="excess-initializers"
            )
        first = node.exprs[0]
        if isinstance(first, c_ast.InitList):
            self.braced(part, first)
        elif isinstance(first, c_ast.NamedInitializer):
            raise CheckError(location, "designator in initializer for scalar type")
        else:
            self.scalar(part, expression(self.unit, first))

    def _braced_string(self, part: _Part, node: Node) -> bool:
        """Initialise an array of characters with `{"text"}`."""
        if not isinstance(part.type, ArrayType) or len(node.exprs) != 1:
            return False
        first = node.exprs[0]
        if not isinstance(first, c_ast.Constant) or first.type != "string":
            return False
        return self.whole(part, expression(self.unit, first))

    def _measure(self, place: _Place) -> None:
        if place.type.size == 0 or (
            isinstance(place.type, ArrayType) and place.type.length is None
        ):
            self.length = max(self.length, place.index)

    def _item(self, places: list[_Place], node: Node) -> None:
        """Initialise the next part, opening aggregates whose braces are omitted."""
        while (part := places[-1].part()) is None and len(places) > 1:
            places.pop()
        if part is None:
            self.unit.warning(
                self.unit.at(node), "excess elements in initializer", flag="excess-initializers"
            )
            if not isinstance(node, c_ast.InitList):
                expression(self.unit, node)
            return
        places[-1].advance()
        self._limit(part, node)
        if isinstance(node, c_ast.InitList):
            self.braced(part, node)
            return
        value = expression(self.unit, node)
        while not self.whole(part, value):
            if not isinstance(part.type, ArrayType | RecordType):
                self.scalar(part, value)
                return
            place = _Place(part.type, part.offset)
            inner = place.part()
            if inner is None:
                text = f"'{part.type}' has no member that can be initialized"
                raise CheckError(self.unit.at(node), text)
            place.advance()
            places.append(place)
            part = inner

    def _limit(self, part: _Part, node: Node) -> None:
        if part.offset + part.type.size > LARGEST_OBJECT:
            raise CheckError(self.unit.at(node), "initialized object is too large")
        is_flexible = isinstance(part.type, ArrayType) and part.type.length is None
        if is_flexible and not self.is_static:
            text = "flexible array member of a local variable cannot be initialized"
            raise CheckError(self.unit.at(node), text)

    def whole(self, part: _Part, value: tree.Expression) -> bool:
        """Initialise a whole array with a string, or a whole struct with a struct, if it is one."""
        ctype = part.type
        if isinstance(ctype, ArrayType) and isinstance(value, tree.StringLiteral):
            return self._string(part, ctype, value)
        if is_complex(ctype):
            self.scalar(part, value)
            return True
        if isinstance(value, tree.CompoundLiteral) and self._expand(part, value):
            return True
        if isinstance(ctype, RecordType) and unqualified(value.type) == unqualified(ctype):
            self._take(InitialValue(part.offset, ctype, value))
            return True
        return False

    def _expand(self, part: _Part, literal: tree.CompoundLiteral) -> bool:
        """Use the parts of a compound literal where its value cannot be copied (as gcc does)."""
        if isinstance(part.type, ArrayType):
            if not compatible(part.type, literal.type):
                return False
            assert isinstance(literal.type, ArrayType)
            self.length = literal.type.length or 0
        elif not self.is_static or part.type != literal.type:
            return False
        self.has_gaps = True
        for each in literal.initialiser.values:
            self._take(InitialValue(part.offset + each.offset, each.type, each.value, each.member))
        return True

    def _string(self, part: _Part, ctype: ArrayType, value: tree.StringLiteral) -> bool:
        assert isinstance(value.type, ArrayType)
        element, given = unqualified(ctype.element), value.type.element
        if not isinstance(element, IntegerType) or not isinstance(given, IntegerType):
            return False
        if element.size != given.size or element.name == "_Bool":
            return False
        content = value.content
        if ctype.length is None:
            self.length = len(content) // element.size
            ctype = ArrayType(ctype.element, self.length)
        elif len(content) > ctype.size + element.size:
            self.unit.warning(
                value.location,
                "initializer string for char array is too long",
                flag="excess-initializers",
            )
        content = content[: ctype.size]
        string = tree.StringLiteral(ctype, value.location, content)
        self._override(_Part(ctype, part.offset))
        self._take(InitialValue(part.offset, ctype, string))
        return True

    def scalar(self, part: _Part, value: tree.Expression) -> None:
        """Initialise a scalar part."""
        converted = assigned(self.unit, value, part.type, "initialise")
        if isinstance(converted, tree.CompoundLiteral) and is_complex(part.type):
            self._expand(_Part(unqualified(part.type), part.offset), converted)
            if self.is_static:
                return
        self._take(InitialValue(part.offset, part.type, converted, part.member))

    # Designators (C17 6.7.9p6, p7)

    def _designate(self, places: list[_Place], designators: list[Node]) -> list[tuple[_Place, int]]:
        """Select the part that designators denote.

        Returns:
            The arrays with a designated range, of which the first element is selected, and the
            number of elements in it.
        """
        ranges = []
        for number, designator in enumerate(designators):
            if number > 0:
                self._open(places, self.unit.at(designator))
            place = places[-1]
            if isinstance(designator, c_ast.ArrayDesignator):
                count = self._choose_elements(place, designator)
                if count > 1:
                    ranges.append((place, count))
            else:
                self._choose_member(places, designator.name, self.unit.at(designator))
        return ranges

    def _open(self, places: list[_Place], location: Location) -> None:
        """Open the aggregate that is selected."""
        part = places[-1].part()
        if part is None or not isinstance(part.type, ArrayType | RecordType):
            raise CheckError(location, "designator in initializer for scalar type")
        places[-1].advance()
        places.append(_Place(part.type, part.offset))
        # As in gcc, the rest of a struct that was copied as a whole becomes zero.
        copied = [each for each in self.values if each.offset == part.offset]
        if any(each.type == part.type and isinstance(each.type, RecordType) for each in copied):
            self._override(part)

    def _choose_elements(self, place: _Place, designator: Node) -> int:
        """Select an element, or the first of a range; return the number of elements in it."""
        location = self.unit.at(designator)
        if not isinstance(place.type, ArrayType):
            raise CheckError(
                location, f"array designator cannot initialize non-array type '{place.type}'"
            )
        chosen = designator.expr
        first, last = chosen, chosen
        if isinstance(chosen, Range):
            first, last = chosen.first, chosen.last
        index = constant.integer(self.unit, first, "array designator")
        end = index if last is first else constant.integer(self.unit, last, "array designator")
        if end < index:
            raise CheckError(location, f"array designator range [{index}, {end}] is empty")
        length = place.type.length
        if index < 0 or (length is not None and end >= length):
            wrong = end if index >= 0 else index
            raise CheckError(location, f"array designator index ({wrong}) exceeds array bounds")
        place.choose(index)
        return end - index + 1

    def _choose_member(self, places: list[_Place], name: str, location: Location) -> None:
        ctype = places[-1].type
        if not isinstance(ctype, RecordType):
            raise CheckError(location, f"field designator cannot initialize a '{ctype}'")
        for index, member in enumerate(ctype.record.members or []):
            if member.name == name:
                places[-1].choose(index)
                return
            is_anonymous = member.name is None and isinstance(member.type, RecordType)
            if (
                is_anonymous
                and isinstance(member.type, RecordType)
                and name in member.type.record.named
            ):
                places[-1].choose(index)
                self._open(places, location)
                self._choose_member(places, name, location)
                return
        text = f"field designator '{name}' does not refer to any field in type '{ctype}'"
        raise CheckError(location, text)
