"""The checked program: what C source means, with every type and conversion spelled out.

The checker (`check_*.py`, `declare.py`, ...) makes this tree of pycparser's, and tells the user of
every mistake on the way; lowering (`lower_*.py`) turns it into IR and can no longer fail. Names
are resolved to symbols, conversions are `Convert` nodes, `a[i]` is a `Dereference` of a
`PointerAdd`, and constant operands are folded into a `Literal`.

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
    """What all expressions have: the type of the value, and the place in the source."""

    type: CType
    location: Location


@dataclass(slots=True, eq=False)
class Literal(Expression):
    """An arithmetic or pointer constant; an integer lies in the range of its type."""

    value: int | float


@dataclass(slots=True, eq=False)
class StringLiteral(Expression):
    """An array of characters, the terminating zero included."""

    content: bytes


@dataclass(slots=True, eq=False)
class ObjectName(Expression):
    """A variable."""

    symbol: ObjectSymbol


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
    """`record.member`; the record may be an object or a value that a call gave."""

    record: Expression
    member: Member


@dataclass(slots=True, eq=False)
class Assign(Expression):
    """`target = value`, the value already converted; gives what the target then holds."""

    target: Expression
    value: Expression


@dataclass(slots=True, eq=False)
class CompoundAssign(Expression):
    """`target op= value`: `op` is done in type `computed`, the target is evaluated once.

    For a pointer target `computed` is its type and the value is an index as in `PointerAdd`.
    """

    op: str
    target: Expression
    value: Expression
    computed: CType


@dataclass(slots=True, eq=False)
class Increment(Expression):
    """`++` (step 1) or `--` (step -1), before or behind the target."""

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
    """A call that becomes instructions in place, see `builtins`."""

    name: str
    arguments: list[Expression]
    kind: str = ""


@dataclass(slots=True, eq=False)
class VarArg(Expression):
    """`__builtin_va_arg`: takes the next argument of this node's type from a list."""

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
    """A value for the part of an object at `offset` [bytes]; `member` when it is a bit-field."""

    offset: int
    type: CType
    value: Expression
    member: Member | None = None


@dataclass(slots=True, eq=False)
class Initialiser:
    """The values of an object's parts in the order of the source.

    Attributes:
        is_braced: whether the parts that are not named become zero.
        extent: where the last value ends [bytes], after the object if it fills a flexible array.
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
    """A local variable begins to exist."""

    location: Location
    symbol: ObjectSymbol
    initialiser: Initialiser | None


@dataclass(slots=True, eq=False)
class Lifetimes:
    """The variables of a block begin to exist, without values, or end with it (C17 6.2.4p6)."""

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
        start: what comes before the loop.
        condition: None for an endless one.
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
    """`switch`; the labels lie anywhere in the body."""

    location: Location
    value: Expression
    body: list[Statement]
    labels: list[CaseLabel]


@dataclass(slots=True, eq=False)
class CaseLabel:
    """`case first ... last:`, for a single value twice the same; `default:` when it is None."""

    location: Location
    first: int | None
    last: int | None = None


@dataclass(slots=True, eq=False)
class Label:
    """A place that `goto` goes to."""

    location: Location
    name: str


@dataclass(slots=True, eq=False)
class Goto:
    """`goto`; `release` gives back the memory of arrays whose scope it leaves."""

    location: Location
    name: str
    release: Expression | None = None


@dataclass(slots=True, eq=False)
class ComputedGoto:
    """`goto *target`: goes to the label of that number.

    Attributes:
        numbers: the number of each label of the function that has one, by its name.
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
    """`return`; `release` is done when the value is known, as in `Goto`."""

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
        passed: the types in which callers pass them (a K&R `float` comes as `double`).
        returns_implicit_int: no result type was written, so that no value need be returned.
        end: where its closing brace is.
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
    """Build an integer constant."""
    return Literal(ctype, location, value)
