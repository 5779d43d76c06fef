"""C types with the layout of the target: ILP32, little-endian, natural alignment.

`char` is signed and has 8 bits, `short` 16, `int`, `long` and pointers 32, `long long` 64, `float`
32, `double` and `long double` 64. Types are values: two types are equal if they are the same type
in C. Structs, unions and enums are compared by the identity of their definition, which is filled in
when the source completes it.

>>> array_of_pointers = ArrayType(PointerType(CHAR), 3)
>>> print(array_of_pointers, array_of_pointers.size)
char *[3] 12
>>> point = Record("struct", "point")
>>> point.complete([Member("tag", CHAR), Member("x", DOUBLE), Member("on", INT, bit_width=1)])
>>> [(each.name, each.offset) for each in point.members], point.size, point.align
([('tag', 0), ('x', 8), ('on', 16)], 24, 8)
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import dataclass, field, replace
from typing import ClassVar, Final, Literal, TypeAlias

from crs_cc.ir.record_layout import lay_out
from crs_cc.ir.value_type import MemoryType


class _Type:
    """The base of all types, which are printed as in C."""

    __slots__ = ()

    def __str__(self) -> str:
        return spell(self)  # type: ignore[arg-type]


@dataclass(frozen=True, slots=True)
class VoidType(_Type):
    """`void`. Its size is 1, for arithmetic on pointers to it (a GNU extension)."""

    size: ClassVar = 1
    align: ClassVar = 1
    const: bool = False
    volatile: bool = False


@dataclass(frozen=True, slots=True)
class IntegerType(_Type):
    """An integer type, including `_Bool` and `char`.

    Attributes:
        name: its usual name.
        size: its size and alignment [bytes].
        rank: its rank in the usual arithmetic conversions (C17 6.3.1.1).
        memory: its memory type.
        width: the width of its values [bits], if it is less than the size (see `bit_field`).
    """

    name: str
    size: int
    signed: bool
    rank: int
    memory: MemoryType
    const: bool = False
    volatile: bool = False
    width: int | None = None

    @property
    def align(self) -> int:
        """Return the alignment [bytes]."""
        return self.size

    @property
    def bits(self) -> int:
        """Return the width of a value [bits]."""
        return 8 * self.size if self.width is None else self.width

    @property
    def smallest(self) -> int:
        """Return the smallest value."""
        return -(1 << self.bits - 1) if self.signed else 0

    @property
    def largest(self) -> int:
        """Return the largest value."""
        if self.name == "_Bool":
            return 1
        return (1 << self.bits - self.signed) - 1


@dataclass(frozen=True, slots=True)
class FloatType(_Type):
    """A floating type; attributes as for `IntegerType`."""

    name: str
    size: int
    rank: int
    memory: MemoryType
    const: bool = False
    volatile: bool = False

    @property
    def align(self) -> int:
        """Return the alignment [bytes]."""
        return self.size


@dataclass(slots=True, eq=False)
class Enumeration:
    """The definition of an enum: its tag and its constants; None until they are known.

    Attributes:
        integer: its integer type: `unsigned int` unless constants are negative or do not fit, as
            in gcc.
    """

    tag: str | None
    constants: dict[str, int] | None = None
    integer: IntegerType = field(default_factory=lambda: UINT)

    def complete(self, constants: dict[str, int], packed: bool = False) -> None:
        """Set the constants, and the integer type that can represent them.

        Args:
            constants: the value of each constant.
            packed: whether it is the smallest type, and not at least as large as `int`.
        """
        self.constants = constants
        low, high = min(constants.values(), default=0), max(constants.values(), default=0)
        types = (SCHAR, SHORT, INT, LLONG) if low < 0 else (UCHAR, USHORT, UINT, ULLONG)
        allowed = types if packed else types[2:]
        fitting = (each for each in allowed if each.smallest <= low and high <= each.largest)
        self.integer = next(fitting, types[-1])


@dataclass(frozen=True, slots=True)
class EnumType(_Type):
    """An enum: a distinct type that behaves as an integer type."""

    definition: Enumeration
    const: bool = False
    volatile: bool = False

    @property
    def name(self) -> str:
        """Return the name of the integer type."""
        return self.definition.integer.name

    @property
    def size(self) -> int:
        """Return the size [bytes]."""
        return self.definition.integer.size

    @property
    def align(self) -> int:
        """Return the alignment [bytes]."""
        return self.definition.integer.size

    @property
    def bits(self) -> int:
        """Return the width of a value [bits]."""
        return self.definition.integer.bits

    @property
    def signed(self) -> bool:
        """Return whether the integer type is signed."""
        return self.definition.integer.signed

    @property
    def rank(self) -> int:
        """Return the rank of the integer type."""
        return self.definition.integer.rank

    @property
    def memory(self) -> MemoryType:
        """Return its memory type."""
        return self.definition.integer.memory


@dataclass(frozen=True, slots=True)
class PointerType(_Type):
    """A pointer to `target`."""

    size: ClassVar = 4
    align: ClassVar = 4
    memory: ClassVar[MemoryType] = "i32"
    target: CType
    const: bool = False
    volatile: bool = False


@dataclass(frozen=True, slots=True)
class ArrayType(_Type):
    """An array of `length` elements; the length is None while unknown (`int a[]`).

    Attributes:
        extent: the front end's description of a variable length.
    """

    element: CType
    length: int | None = None
    extent: Hashable = None

    @property
    def size(self) -> int:
        """Return the size [bytes], 0 while the length is unknown."""
        assert self.extent is None, "the program must compute this size"
        return self.element.size * (self.length or 0)

    @property
    def align(self) -> int:
        """Return the alignment [bytes]."""
        return self.element.align

    @property
    def const(self) -> bool:
        """Return whether the elements are const (C17 6.7.3p9)."""
        return self.element.const

    @property
    def volatile(self) -> bool:
        """Return whether the elements are volatile."""
        return self.element.volatile


@dataclass(frozen=True, slots=True)
class FunctionType(_Type):
    """A function; `parameters` is None when it was declared without a prototype.

    Its size is 1, as with gcc; it has no qualifiers.
    """

    size: ClassVar = 1
    align: ClassVar = 1
    const: ClassVar = False
    volatile: ClassVar = False
    result: CType
    parameters: tuple[CType, ...] | None = None
    variadic: bool = False


@dataclass(slots=True)
class Member:
    """A member of a struct or union.

    Attributes:
        name: its name, None for an anonymous struct or union and for an unnamed bit-field.
        offset: its offset [bytes]; that of its storage unit for a bit-field.
        bit_offset: the offset of a bit-field in its unit [bits].
        bit_width: the width of a bit-field [bits]; None for other members.
        align: the alignment from `_Alignas` [bytes], 0 if there is none.
        natural: the alignment without that [bytes], 0 for the type's own.
        packed: whether it has no alignment.
        spread: the number of bytes, from `offset` on, of a bit-field for which there is no
            storage unit of its type in the struct; else 0.
        place: the front end's description of an offset that only the running program knows.
    """

    name: str | None
    type: CType
    offset: int = 0
    bit_offset: int = 0
    bit_width: int | None = None
    align: int = 0
    natural: int = 0
    packed: bool = False
    spread: int = 0
    place: Hashable = None


@dataclass(slots=True, eq=False)
class Record:
    """The definition of a struct or union.

    Attributes:
        tag: its tag, None when it has none.
        alias: its first typedef name; it is printed if there is no tag, or one of the library.
        is_complex: whether it is a complex number, a struct of its real and imaginary part.
        is_transparent: whether a parameter of this union takes values of its members' types.
        members: the members in the order of the source; None until they are known.
        named: all members with names, including those of anonymous members, with their offsets
            from the start of the whole.
        size: the size [bytes].
        align: the alignment [bytes].
        extent: the front end's description of a size that only the running program knows.
    """

    kind: Literal["struct", "union"]
    tag: str | None = None
    alias: str | None = None
    is_complex: bool = False
    is_transparent: bool = False
    members: list[Member] | None = None
    named: dict[str, Member] = field(default_factory=dict)
    size: int = 0
    align: int = 1
    extent: Hashable = None

    def complete(self, members: Iterable[Member], align: int = 1, pack: int = 0) -> None:
        """Set the members and lay them out.

        Args:
            members: the members; those of a packed struct are packed.
            align: the minimum alignment of the whole [bytes].
            pack: the maximum alignment of members [bytes], from `#pragma pack`; 0 if none.
        """
        self.members = list(members)
        self.size, self.align = lay_out(self.members, self.kind == "union", align, pack)
        for member in self.members:
            self._name(member)

    def _name(self, member: Member) -> None:
        if member.name is not None:
            self.named[member.name] = member
        elif isinstance(member.type, RecordType):
            for name, inner in member.type.record.named.items():
                self.named[name] = replace(inner, offset=member.offset + inner.offset)


@dataclass(frozen=True, slots=True)
class RecordType(_Type):
    """A struct or union."""

    record: Record
    const: bool = False
    volatile: bool = False

    @property
    def size(self) -> int:
        """Return the size [bytes], 0 while incomplete."""
        return self.record.size

    @property
    def align(self) -> int:
        """Return the alignment [bytes]."""
        return self.record.align


CType: TypeAlias = (
    VoidType
    | IntegerType
    | FloatType
    | EnumType
    | PointerType
    | ArrayType
    | FunctionType
    | RecordType
)

VOID: Final = VoidType()
BOOL: Final = IntegerType("_Bool", 1, False, 0, "u8")
CHAR: Final = IntegerType("char", 1, True, 1, "i8")
SCHAR: Final = IntegerType("signed char", 1, True, 1, "i8")
UCHAR: Final = IntegerType("unsigned char", 1, False, 1, "u8")
SHORT: Final = IntegerType("short", 2, True, 2, "i16")
USHORT: Final = IntegerType("unsigned short", 2, False, 2, "u16")
INT: Final = IntegerType("int", 4, True, 3, "i32")
UINT: Final[IntegerType] = IntegerType("unsigned int", 4, False, 3, "i32")
LONG: Final = IntegerType("long", 4, True, 4, "i32")
ULONG: Final = IntegerType("unsigned long", 4, False, 4, "i32")
LLONG: Final = IntegerType("long long", 8, True, 64, "i64")
ULLONG: Final = IntegerType("unsigned long long", 8, False, 64, "i64")
FLOAT: Final = FloatType("float", 4, 65, "f32")
DOUBLE: Final = FloatType("double", 8, 66, "f64")
LDOUBLE: Final = FloatType("long double", 8, 67, "f64")

NULLPTR: Final = PointerType(RecordType(Record("struct", "nullptr_t", "nullptr_t's target")))
"""The type of C23's `nullptr`, a pointer to what nothing else points to."""

BASIC_TYPES: Final[dict[str, IntegerType | FloatType]] = {
    each.name: each
    for each in (
        BOOL, CHAR, SCHAR, UCHAR, SHORT, USHORT, INT, UINT, LONG, ULONG, LLONG, ULLONG,
        FLOAT, DOUBLE, LDOUBLE,
    )
}  # fmt: skip
"""The arithmetic types by name."""


def bit_field(ctype: IntegerType | EnumType, width: int) -> IntegerType:
    """Return the type of the value of a bit-field of 33 to 63 bits, as in gcc."""
    name = f"{'long long' if ctype.signed else 'unsigned long long'}:{width}"
    return IntegerType(name, 8, ctype.signed, width, "i64", width=width)


def _complex(base: IntegerType | FloatType) -> RecordType:
    record = Record("struct", None, f"_Complex {base.name}", is_complex=True)
    record.complete([Member("__real__", base), Member("__imag__", base)])
    return RecordType(record)


COMPLEX: Final = {
    each.name: _complex(each)
    for each in (
        CHAR, SCHAR, UCHAR, SHORT, USHORT, INT, UINT, LONG, ULONG, LLONG, ULLONG,
        FLOAT, DOUBLE, LDOUBLE,
    )
}  # fmt: skip
"""The complex types, by the name of their parts' type; GNU C has those of integers."""


def is_complex(ctype: CType) -> bool:
    """Return whether a type is a complex type (C17 6.2.5p11)."""
    return isinstance(ctype, RecordType) and ctype.record.is_complex


def qualify(ctype: CType, const: bool, volatile: bool) -> CType:
    """Add qualifiers to a type; those of an array belong to its elements (C17 6.7.3p9)."""
    if not (const or volatile) or isinstance(ctype, FunctionType):
        return ctype
    if isinstance(ctype, ArrayType):
        return replace(ctype, element=qualify(ctype.element, const, volatile))
    return replace(ctype, const=ctype.const or const, volatile=ctype.volatile or volatile)


def unqualified(ctype: CType) -> CType:
    """Return the type without its outermost qualifiers."""
    if not (ctype.const or ctype.volatile) or isinstance(ctype, FunctionType):
        return ctype
    if isinstance(ctype, ArrayType):
        return replace(ctype, element=unqualified(ctype.element))
    if isinstance(ctype, IntegerType | FloatType) and ctype.name in BASIC_TYPES:
        return BASIC_TYPES[ctype.name]
    return replace(ctype, const=False, volatile=False)


def is_complete(ctype: CType) -> bool:
    """Return whether an object can have this type (C17 6.2.5p1)."""
    if isinstance(ctype, ArrayType):
        is_known = ctype.length is not None or ctype.extent is not None
        return is_known and is_complete(ctype.element)
    if isinstance(ctype, RecordType):
        return ctype.record.members is not None
    return not isinstance(ctype, VoidType | FunctionType)


def is_variably_modified(ctype: CType) -> bool:
    """Return whether the size of the type, or of what it points to, is computed at run time."""
    while isinstance(ctype, PointerType | ArrayType):
        if isinstance(ctype, ArrayType) and ctype.extent is not None:
            return True
        ctype = ctype.target if isinstance(ctype, PointerType) else ctype.element
    return isinstance(ctype, RecordType) and ctype.record.extent is not None


def spell(ctype: CType, declarator: str = "") -> str:
    """Return a type in C syntax, around a declarator if one is given.

    >>> spell(PointerType(FunctionType(INT, (PointerType(CHAR, const=True),), True)), "f")
    'int (*f)(char *const, ...)'
    """
    if isinstance(ctype, PointerType) and ctype.target == NULLPTR.target:
        return f"nullptr_t {declarator}".strip()
    if isinstance(ctype, PointerType):
        text = f"*{_qualifiers(ctype)}"
        gap = " " if text[-1].isalpha() and declarator[:1] not in {"", "[", "("} else ""
        text += gap + declarator
        if isinstance(ctype.target, ArrayType | FunctionType):
            text = f"({text})"
        return spell(ctype.target, text)
    if isinstance(ctype, ArrayType):
        length = "" if ctype.length is None else str(ctype.length)
        if ctype.extent is not None:
            length = "*"
        return spell(ctype.element, f"{declarator}[{length}]")
    if isinstance(ctype, FunctionType):
        return spell(ctype.result, f"{declarator}({_parameters(ctype)})")
    name = " ".join(part for part in (_qualifiers(ctype), _name(ctype)) if part)
    if not declarator or declarator.startswith("["):
        return name + declarator
    return f"{name} {declarator}"


def _qualifiers(ctype: CType) -> str:
    words = (("const", ctype.const), ("volatile", ctype.volatile))
    return " ".join(word for word, is_set in words if is_set)


def _parameters(function: FunctionType) -> str:
    if function.parameters is None:
        return ""
    names = [spell(each) for each in function.parameters] + ["..."] * function.variadic
    return ", ".join(names) or "void"


def _name(ctype: VoidType | IntegerType | FloatType | EnumType | RecordType) -> str:
    if isinstance(ctype, VoidType):
        return "void"
    if isinstance(ctype, EnumType):
        return f"enum {ctype.definition.tag or '<anonymous>'}"
    if isinstance(ctype, RecordType):
        record = ctype.record
        if record.alias is not None and (record.tag or "__").startswith("__"):
            return record.alias
        return f"{record.kind} {record.tag or '<anonymous>'}"
    return ctype.name
