"""GNU C's nested functions: functions inside functions, which use the outer ones' variables.

A function whose variables are used by functions inside it has a *record* in its frame: an array of
the addresses of these variables. A nested function has a hidden first parameter, the *chain*: a
pointer to the record of the function around it. So all state is in memory, and a nested function
is stopped, saved and resumed like any other. `convert_nested` rewrites a checked function to that.

A pointer to a nested function must lead to its chain, too. It points to one of a few *thunks*:
functions that pass on their arguments with a chain that is kept in a static object. The library
(`stdlib/nested.c`) gives a thunk to the frame that takes the function's address, until the function
around it returns.
"""

from __future__ import annotations

from dataclasses import fields
from functools import cache
from typing import Any, Final

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree, vla
from crs_cc.frontend.check.checker import CheckError, FunctionState, Unit
from crs_cc.frontend.check.conversion import convert, decay, is_scalar
from crs_cc.frontend.check.nonlocal_goto import landings
from crs_cc.frontend.check.scope import FunctionSymbol, ObjectSymbol, TypedefName
from crs_cc.frontend.check.tree import Expression, Initialiser, InitialValue
from crs_cc.frontend.check.type_compat import compatible
from crs_cc.ir.types import (
    INT,
    UINT,
    VOID,
    ArrayType,
    CType,
    FunctionType,
    PointerType,
    RecordType,
    VoidType,
)

THUNKS: Final = 256
"""How many frames of a function may hold pointers to a function inside it at the same time."""

_ADDRESS: Final = PointerType(VOID)
_RECORD: Final = PointerType(_ADDRESS)
_TAKE: Final = FunctionType(_ADDRESS, (PointerType(UINT), _RECORD, INT, UINT))
_RELEASE: Final = FunctionType(VOID, (PointerType(UINT), INT, UINT))


def declare_nested(
    unit: Unit, name: str, ctype: FunctionType, location: Location
) -> FunctionSymbol:
    """Declare a function inside a function.

    Raises:
        CheckError: the name has another meaning in this block.
    """
    here = unit.scope.names.get(name)
    if isinstance(here, FunctionSymbol) and here.owner is unit.function:
        if not compatible(here.type, ctype):
            text = f"conflicting types for '{name}' ('{ctype}' vs '{here.type}')"
            raise CheckError(location, text, f"first declared at {here.location}")
        return here
    if here is not None:
        raise CheckError(location, f"redefinition of '{name}'", f"first at {here.location}")
    symbol = FunctionSymbol(name, ctype, location, unit.static_name(name), is_external=False)
    symbol.owner = unit.function
    unit.scope.names[name] = symbol
    return symbol


def enter(unit: Unit, state: FunctionState, location: Location) -> None:
    """Set up the state of a function inside `unit.function`, before its scope is opened."""
    state.outer = unit.function
    state.chain = ObjectSymbol("", _RECORD, location)
    scope = unit.scope
    while scope.outer is not None:
        for symbol in scope.names.values():
            if isinstance(symbol, ObjectSymbol) and symbol.link_name is None:
                state.visible.add(symbol)
            if isinstance(symbol, ObjectSymbol | TypedefName):
                state.visible.update(_extents(symbol.type))
        scope = scope.outer
    around = state.outer
    while around is not None and around.chain is not None:
        state.visible.add(around.chain)
        around = around.outer


def _extents(ctype: CType) -> list[ObjectSymbol]:
    """Return the hidden variables with the variable sizes and offsets of a type."""
    found: list[ObjectSymbol] = []
    while isinstance(ctype, PointerType | ArrayType):
        if isinstance(ctype, ArrayType) and isinstance(ctype.extent, ObjectSymbol):
            found.append(ctype.extent)
        ctype = ctype.target if isinstance(ctype, PointerType) else ctype.element
    if isinstance(ctype, RecordType) and isinstance(ctype.record.extent, ObjectSymbol):
        found.append(ctype.record.extent)
        for member in ctype.record.members or []:
            found += [member.place] if isinstance(member.place, ObjectSymbol) else []
            found += _extents(member.type)
    return found


def convert_nested(unit: Unit, definition: tree.FunctionDefinition, state: FunctionState) -> None:
    """Rewrite a function that is inside another one, or has functions inside it."""
    if state.outer is None and not state.has_nested:
        return
    rewriting = _Rewriting(unit, state)
    location, body = definition.location, definition.body
    rewriting.statements(body)
    filled = [rewriting.expression(each) for each in _filling(state, location)]
    if state.chain is not None:
        definition.parameters.insert(0, state.chain)
        definition.passed.insert(0, _RECORD)
    released = [_release(state, each, location) for each in state.thunks.values()]
    if released:
        for each in state.returns:
            done = [] if each.release is None else [each.release]
            each.release = vla.after([*done, *released[:-1]], released[-1])
        body.extend(tree.ExpressionStatement(definition.end, each) for each in released)
    begin = [*_taking(state, location), *filled]
    if begin:
        body.insert(0, tree.ExpressionStatement(location, vla.after(begin[:-1], begin[-1])))
    body[:0] = landings(state, location)
    body[:0] = [tree.Declare(location, each, None) for each in state.captured.values()]


def _filling(state: FunctionState, location: Location) -> list[Expression]:
    """Return the assignments of the addresses in the record."""
    found: list[Expression] = []
    for index, symbol in enumerate(state.shared):
        variable = tree.ObjectName(symbol.type, location, symbol)
        address = tree.AddressOf(PointerType(symbol.type), location, variable)
        place = _element(_own_record(state, location), index, location)
        found.append(tree.Assign(_ADDRESS, location, place, convert(address, _ADDRESS)))
    if state.record is not None:
        state.record.type = ArrayType(_ADDRESS, max(1, len(state.shared)))
    return found


def _taking(state: FunctionState, location: Location) -> list[Expression]:
    """Return the assignments of the addresses in the outer record to variables."""
    found: list[Expression] = []
    for symbol, local in state.captured.items():
        assert state.outer is not None
        assert state.chain is not None
        chain = tree.ObjectName(_RECORD, location, state.chain)
        address = _element(chain, state.outer.shared.index(symbol), location)
        name = tree.ObjectName(local.type, location, local)
        found.append(tree.Assign(local.type, location, name, convert(address, local.type)))
    return found


def _element(record: Expression, index: int, location: Location) -> Expression:
    at = tree.PointerAdd(_RECORD, location, record, tree.integer(index, INT, location))
    return tree.Dereference(_ADDRESS, location, at)


def _own_record(state: FunctionState, location: Location) -> Expression:
    """Return a pointer to a function's own record."""
    if state.record is None:
        state.record = ObjectSymbol("", ArrayType(_ADDRESS, 1), location, in_memory=True)
    first = tree.ObjectName(_ADDRESS, location, state.record)  # its length is not known yet
    return tree.AddressOf(_RECORD, location, first)


def _global(symbol: ObjectSymbol, location: Location) -> Expression:
    """Return a pointer to the first element of a static array."""
    return decay(tree.ObjectName(symbol.type, location, symbol))


def _library(
    name: str, ctype: FunctionType, operands: list[Expression], at: Location
) -> Expression:
    callee = tree.FunctionName(ctype, at, FunctionSymbol(name, ctype, at, name))
    return tree.Call(ctype.result, at, callee, operands)


def _release(
    state: FunctionState, thunks: tuple[ObjectSymbol, ObjectSymbol], location: Location
) -> Expression:
    """Return the call that frees the thunks of a function's frame."""
    chains, _ = thunks
    frame = convert(_own_record(state, location), UINT)
    operands = [_global(chains, location), tree.integer(THUNKS, INT, location), frame]
    return _library("__crs_release_thunks", _RELEASE, operands, location)


@cache
def _fields(kind: type) -> tuple[str, ...]:
    left_out = {"type", "location", "symbol", "labels", "member", "computed", "numbers"}
    return tuple(each.name for each in fields(kind) if each.name not in left_out)


class _Rewriting:
    """A walk through a checked function."""

    def __init__(self, unit: Unit, state: FunctionState) -> None:
        self.unit = unit
        self.state = state
        self.done: set[int] = set()
        self.kept: list[Any] = []

    def statements(self, body: list[tree.Statement]) -> None:
        """Rewrite statements in place."""
        for each in body:
            self._inside(each)

    def expression(self, node: Expression) -> Expression:
        """Return an expression with its parts rewritten, or another one in its place."""
        if isinstance(node, tree.ObjectName):
            return self._variable(node)
        if isinstance(node, tree.AddressOf) and isinstance(node.operand, tree.FunctionName):
            owner = node.operand.symbol.owner
            return node if owner is None else self._pointer(node, node.operand.symbol, owner)
        if id(node) not in self.done:
            self._inside(node)
            if isinstance(node, tree.Call) and isinstance(node.callee, tree.FunctionName):
                owner = node.callee.symbol.owner
                if owner is not None:
                    node.arguments.insert(0, self._chain(owner, node.location))
        return node

    def _inside(self, node: Any) -> None:
        """Rewrite the parts of a node; parts may be shared, and are rewritten once."""
        if id(node) in self.done:
            return
        self.done.add(id(node))
        self.kept.append(node)  # so that no other node gets its number
        for name in _fields(node.__class__):
            value = getattr(node, name)
            if isinstance(value, Expression):
                setattr(node, name, self.expression(value))
            elif isinstance(value, list):
                value[:] = [self._element(each) for each in value]
            elif isinstance(value, Initialiser):
                for each in value.values:
                    each.value = self.expression(each.value)

    def _element(self, each: Any) -> Any:
        if isinstance(each, Expression):
            return self.expression(each)
        if not isinstance(each, ObjectSymbol | InitialValue):
            self._inside(each)
        return each

    def _variable(self, node: tree.ObjectName) -> Expression:
        """Return a variable of an outer function through its address."""
        symbol, state = node.symbol, self.state
        if symbol not in state.visible:
            return node
        local = state.captured.get(symbol)
        if local is None:
            assert state.outer is not None
            location = state.symbol.location
            is_plain = bool(symbol.name) and not symbol.is_indirect
            local = ObjectSymbol(symbol.name, PointerType(symbol.type), location)
            local.is_indirect, local.is_used = is_plain, True
            state.captured[symbol] = local
            symbol.in_memory = True
            if symbol not in state.outer.shared:
                state.outer.shared.append(symbol)
            _own_record(state.outer, location)
        pointer = tree.ObjectName(local.type, node.location, local)
        return tree.Dereference(node.type, node.location, pointer)

    def _chain(self, owner: FunctionState, location: Location) -> Expression:
        """Return a pointer to the record of a function around this place."""
        state = self.state
        if state is owner:
            return _own_record(state, location)
        while state.outer is not owner:
            assert state.outer is not None
            state = state.outer
        assert state.chain is not None
        _own_record(owner, location)
        return self.expression(tree.ObjectName(_RECORD, location, state.chain))

    def _pointer(
        self, node: tree.AddressOf, symbol: FunctionSymbol, owner: FunctionState
    ) -> Expression:
        """Return a pointer to a nested function."""
        location = node.location
        chains, thunks = owner.thunks.get(symbol) or self._thunks(symbol, owner)
        chain = convert(self._chain(owner, location), UINT)
        count = tree.integer(THUNKS, INT, location)
        operands = [_global(chains, location), _global(thunks, location), count, chain]
        return convert(_library("__crs_take_thunk", _TAKE, operands, location), node.type)

    def _thunks(
        self, symbol: FunctionSymbol, owner: FunctionState
    ) -> tuple[ObjectSymbol, ObjectSymbol]:
        """Define the thunks of a nested function, and the static objects for them."""
        unit, location = self.unit, symbol.location
        if symbol.type.variadic:
            text = f"the address of nested function '{symbol.name}' cannot be taken"
            raise CheckError(location, text, "its number of arguments varies; call it by its name")
        made = []
        for name, ctype in (("chains", UINT), ("thunks", _ADDRESS)):
            link_name = unit.static_name(f"{symbol.name}.{name}")
            array = ArrayType(ctype, THUNKS)
            made.append(ObjectSymbol("", array, location, link_name, is_defined=True))
        chains, thunks = owner.thunks[symbol] = made[0], made[1]
        values = []
        for index in range(THUNKS):
            thunk = _thunk(unit, symbol, chains, index)
            unit.functions.append(thunk)
            called = tree.FunctionName(symbol.type, location, thunk.symbol)
            pointer = tree.AddressOf(_ADDRESS, location, called)
            values.append(InitialValue(index * _ADDRESS.size, _ADDRESS, pointer))
        unit.objects.append(tree.ObjectDefinition(chains, None))
        filled = Initialiser(values, is_braced=True)
        unit.objects.append(tree.ObjectDefinition(thunks, filled))
        return chains, thunks


def _thunk(
    unit: Unit, symbol: FunctionSymbol, chains: ObjectSymbol, index: int
) -> tree.FunctionDefinition:
    """Return a function that calls a nested function with the chain of a number."""
    location, ctype = symbol.location, symbol.type
    own = FunctionSymbol(symbol.name, ctype, location, unit.static_name(f"{symbol.name}.thunk"))
    own.is_external, own.is_defined, own.is_used = False, True, True
    passed = list(ctype.parameters or ())
    parameters = [
        ObjectSymbol("", each, location, in_memory=not is_scalar(each)) for each in passed
    ]
    at = tree.PointerAdd(
        PointerType(UINT), location, _global(chains, location), tree.integer(index, INT, location)
    )
    chain = convert(tree.Dereference(UINT, location, at), _RECORD)
    operands = [chain, *(tree.ObjectName(each.type, location, each) for each in parameters)]
    callee = tree.FunctionName(ctype, location, symbol)
    call = tree.Call(ctype.result, location, callee, operands)
    if isinstance(ctype.result, VoidType):
        body: list[tree.Statement] = [tree.ExpressionStatement(location, call)]
    else:
        body = [tree.Return(location, call)]
    return tree.FunctionDefinition(location, own, location, parameters, passed, body)
