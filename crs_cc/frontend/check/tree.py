"""The checked tree: C with explicit types and conversions.

This package builds it from pycparser's tree and reports all errors; lowering turns it into IR and
cannot fail. Names are resolved to symbols, conversions are `Convert` nodes, `a[i]` is a
`Dereference` of a `PointerAdd`, and constant operands are folded into a `Literal`.

>>> from crs_cc.ir.types import DOUBLE, INT
>>> from crs_cc.core.source import Location
>>> here = Location("half.c", 1, 1)
>>> Convert(DOUBLE, here, Literal(INT, here, 3)).operand.value
3
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, TypeAlias

from crs_cc.core.source import Location
from crs_cc.ir.types import CType, IntegerType, Member

if TYPE_CHECKING:
    from crs_cc.frontend.check.scope import FunctionSymbol, ObjectSymbol


@dataclass(slots=True, eq=False)
class Expression:
    """The base of all expressions: the type of the value, and the location in the source."""

    type: CType
    location: Location


@dataclass(slots=True, eq=False)
class Literal(Expression):
    """An arithmetic or pointer constant; an integer is in the range of its type.

    Attributes:
        is_truncated: whether it is the quotient of two integers, without a remainder that is not 0.
    """

    value: int | float
    is_truncated: bool = False


@dataclass(slots=True, eq=False)
class StringLiteral(Expression):
    """An array of characters, the terminating zero included."""

    content: bytes


@dataclass(slots=True, eq=False)
class ObjectName(Expression):
    """A variable; `is_constant` if its value, when it is read here, is a constant."""

    symbol: ObjectSymbol
    is_constant: bool = False


@dataclass(slots=True, eq=False)
class FunctionName(Expression):
    """A function, before it turns into a pointer."""

    symbol: FunctionSymbol


@dataclass(slots=True, eq=False)
class Unary(Expression):
    """`-`, `~` or `!` of an operand; for `!` of any scalar type, else of this node's type."""

    op: str
    operand: Expression


@dataclass(slots=True, eq=False)
class Binary(Expression):
    """Arithmetic or a comparison of two operands of one type.

    The right operand of a shift has a type of its own.
    """

    op: str
    left: Expression
    right: Expression


@dataclass(slots=True, eq=False)
class Logical(Expression):
    """`&&` or `||` of two scalars."""

    op: str
    left: Expression
    right: Expression


@dataclass(slots=True, eq=False)
class PointerAdd(Expression):
    """`pointer + index`, or `pointer - index` when `minus`; the index has 32 bits."""

    pointer: Expression
    index: Expression
    minus: bool = False


@dataclass(slots=True, eq=False)
class PointerDifference(Expression):
    """`left - right` in elements of `size` bytes."""

    left: Expression
    right: Expression
    size: int


@dataclass(slots=True, eq=False)
class AddressOf(Expression):
    """`&operand`, or the pointer that an array or function turns into (C17 6.3.2.1)."""

    operand: Expression


@dataclass(slots=True, eq=False)
class Dereference(Expression):
    """`*pointer`, an object."""

    pointer: Expression


@dataclass(slots=True, eq=False)
class MemberAccess(Expression):
    """`record.member`; the record may be an object or the result of a call."""

    record: Expression
    member: Member


@dataclass(slots=True, eq=False)
class Assign(Expression):
    """`target = value`, with the value converted; its value is that of the target afterwards."""

    target: Expression
    value: Expression


@dataclass(slots=True, eq=False)
class CompoundAssign(Expression):
    """`target op= value`: `op` is computed in type `computed`, the target is evaluated once.

    For a pointer target, `computed` is its type and the value is an index as in `PointerAdd`.
    """

    op: str
    target: Expression
    value: Expression
    computed: CType


@dataclass(slots=True, eq=False)
class Increment(Expression):
    """`++` (step 1) or `--` (step -1), prefix or postfix."""

    target: Expression
    step: int
    is_postfix: bool


@dataclass(slots=True, eq=False)
class Conditional(Expression):
    """`condition ? then : otherwise`, both converted to this node's type."""

    condition: Expression
    then: Expression
    otherwise: Expression


@dataclass(slots=True, eq=False)
class Comma(Expression):
    """`first, second`."""

    first: Expression
    second: Expression


@dataclass(slots=True, eq=False)
class Convert(Expression):
    """The operand converted to this node's type; `void` drops it."""

    operand: Expression


@dataclass(slots=True, eq=False)
class Call(Expression):
    """A call of a `FunctionName` or of a pointer to a function; the arguments are converted."""

    callee: Expression
    arguments: list[Expression]


@dataclass(slots=True, eq=False)
class Intrinsic(Expression):
    """A call of a builtin, see `builtins`."""

    name: str
    arguments: list[Expression]
    kind: str = ""


@dataclass(slots=True, eq=False)
class VarArg(Expression):
    """`__builtin_va_arg`: the next argument of this node's type from a list."""

    list: Expression


@dataclass(slots=True, eq=False)
class CompoundLiteral(Expression):
    """`(type){...}`: an unnamed object."""

    symbol: ObjectSymbol
    initialiser: Initialiser


@dataclass(slots=True, eq=False)
class StatementExpression(Expression):
    """`({ ... })`: statements, then the value of the last of them unless it is void."""

    body: list[Statement]
    value: Expression | None


@dataclass(slots=True, eq=False)
class InitialValue:
    """A value for the subobject at `offset` [bytes]; `member` if it is a bit-field."""

    offset: int
    type: CType
    value: Expression
    member: Member | None = None


@dataclass(slots=True, eq=False)
class Initialiser:
    """The values of an object's parts in the order of the source.

    Attributes:
        is_braced: whether the remaining parts become zero.
        extent: the end of the last value [bytes]; beyond the object for a flexible array member.
    """

    values: list[InitialValue] = field(default_factory=list)
    is_braced: bool = False
    extent: int = 0


@dataclass(slots=True, eq=False)
class ExpressionStatement:
    """An expression, for its effects."""

    location: Location
    expression: Expression


@dataclass(slots=True, eq=False)
class Declare:
    """The declaration of a local variable."""

    location: Location
    symbol: ObjectSymbol
    initialiser: Initialiser | None


@dataclass(slots=True, eq=False)
class Lifetimes:
    """The start, without values, or end of the lifetime of a block's variables (C17 6.2.4p6).

    There is none for a block with a label, through which it could be entered; so every `goto`
    inside a block that has them leaves it.
    """

    location: Location
    symbols: list[ObjectSymbol]
    begins: bool


@dataclass(slots=True, eq=False)
class If:
    """`if`."""

    location: Location
    condition: Expression
    then: list[Statement]
    otherwise: list[Statement]


@dataclass(slots=True, eq=False)
class Loop:
    """`while`, `do` and `for`.

    Attributes:
        start: the statements before the loop.
        condition: the condition; None for an endless loop.
        tests_first: False for `do`.
    """

    location: Location
    start: list[Statement]
    condition: Expression | None
    step: Expression | None
    body: list[Statement]
    tests_first: bool = True


@dataclass(slots=True, eq=False)
class Switch:
    """`switch`; the labels may be anywhere in the body."""

    location: Location
    value: Expression
    body: list[Statement]
    labels: list[CaseLabel]


@dataclass(slots=True, eq=False)
class CaseLabel:
    """`case first ... last:`, twice the same for a single value; `default:` if they are None."""

    location: Location
    first: int | None
    last: int | None = None


@dataclass(slots=True, eq=False)
class Label:
    """A label for `goto`."""

    location: Location
    name: str


@dataclass(slots=True, eq=False)
class Goto:
    """`goto`.

    Attributes:
        release: frees the memory of arrays whose scope it leaves.
        nonlocal_goto: for a label of a function around this one, the jump there.
    """

    location: Location
    name: str
    release: Expression | None = None
    nonlocal_goto: Expression | None = None


@dataclass(slots=True, eq=False)
class ComputedGoto:
    """`goto *target`: a jump to the label with a number.

    Attributes:
        numbers: the numbers of the function's labels that have one, by name.
    """

    location: Location
    target: Expression
    numbers: dict[str, tuple[int, Location]]


@dataclass(slots=True, eq=False)
class Break:
    """`break`."""

    location: Location


@dataclass(slots=True, eq=False)
class Continue:
    """`continue`."""

    location: Location


@dataclass(slots=True, eq=False)
class Return:
    """`return`; `release`, as in `Goto`, is evaluated after the value."""

    location: Location
    value: Expression | None
    release: Expression | None = None


Statement: TypeAlias = (
    ExpressionStatement
    | Declare
    | Lifetimes
    | If
    | Loop
    | Switch
    | CaseLabel
    | Label
    | Goto
    | ComputedGoto
    | Break
    | Continue
    | Return
)


@dataclass(slots=True, eq=False)
class FunctionDefinition:
    """A function with its body.

    Attributes:
        parameters: in order; a parameter without a name has the name "".
        passed: the types in which callers pass them (a K&R `float` is passed as `double`).
        returns_implicit_int: whether the result type is left out, so that `return` needs no value.
        end: the location of its closing brace.
    """

    location: Location
    symbol: FunctionSymbol
    end: Location
    parameters: list[ObjectSymbol]
    passed: list[CType]
    body: list[Statement]
    returns_implicit_int: bool = False


@dataclass(slots=True, eq=False)
class ObjectDefinition:
    """A global or static object."""

    symbol: ObjectSymbol
    initialiser: Initialiser | None


def integer(value: int, ctype: IntegerType, location: Location) -> Literal:
    """Return an integer constant."""
    return Literal(ctype, location, value)
