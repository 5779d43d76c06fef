"""Check statements (C17 6.8). After an error in one, the following ones are checked."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check import constant, tree, vla
from crs_cc.frontend.check.checker import (
    EXPRESSIONS,
    STATEMENTS,
    CheckError,
    FunctionState,
    SwitchState,
    Unit,
    checks,
    checks_statement,
    expression,
)
from crs_cc.frontend.check.complex_numbers import truth
from crs_cc.frontend.check.conversion import (
    assigned,
    convert,
    decay,
    is_integer,
    is_scalar,
    promote,
)
from crs_cc.frontend.check.expressions import rvalue
from crs_cc.frontend.check.fold import wrap
from crs_cc.frontend.check.nonlocal_goto import nonlocal_goto
from crs_cc.frontend.check.scope import ObjectSymbol, Scope
from crs_cc.frontend.check.suspicious_operands import warn_returned
from crs_cc.frontend.check.tree import Expression, Statement
from crs_cc.frontend.check.unsupported import refused
from crs_cc.frontend.parse.lexer import Span
from crs_cc.frontend.parse.nodes import (
    ComputedGoto,
    LabelAddress,
    LocalLabels,
    Node,
    Range,
    StatementExpression,
)
from crs_cc.frontend.preprocess.options import is_c90
from crs_cc.ir.types import INT, VOID, IntegerType, PointerType, VoidType, qualify


def statement(unit: Unit, node: Node, out: list[Statement]) -> None:
    """Check a statement or a declaration in a block and append the result to `out`."""
    found = STATEMENTS.get(node.__class__)
    if found is not None:
        found(unit, node, out)
        return
    unit.attempt(_expression_statement, node, out)


def _expression_statement(unit: Unit, node: Node, out: list[Statement]) -> None:
    if node.__class__ not in EXPRESSIONS:
        raise refused(unit, node)
    checked = expression(unit, node)
    out.append(tree.ExpressionStatement(checked.location, checked))


def body(unit: Unit, node: Node | None) -> list[Statement]:
    """Check a statement that is part of another, in a scope of its own."""
    out: list[Statement] = []
    if node is not None:
        with unit.new_scope(), vla.block(_function(unit), out, unit.location):
            statement(unit, node, out)
    return out


def _function(unit: Unit) -> FunctionState:
    assert unit.function is not None
    return unit.function


@checks_statement(c_ast.Compound)
def compound(unit: Unit, node: Node, out: list[Statement]) -> None:
    """Check `{ ... }`."""
    first, entries = len(out), _entries(_function(unit))
    with _block(unit, node, out):
        for each in node.block_items or []:
            statement(unit, each, out)
    if _entries(_function(unit)) == entries:
        _limit(out, first, unit.at(node), out[first:])


def _limit(out: list[Statement], first: int, location: Location, declared: list[Statement]) -> None:
    """Limit the lifetimes of declared objects to the statements from number `first` on."""
    symbols = [each.symbol for each in declared if isinstance(each, tree.Declare)]
    out.insert(first, tree.Lifetimes(location, symbols, begins=True))
    out.append(tree.Lifetimes(location, symbols, begins=False))


def _entries(state: FunctionState) -> tuple[int, int]:
    """Return the number of labels so far: those through which a block can be entered."""
    return len(state.labels), len(state.switches[-1].labels) if state.switches else 0


@contextmanager
def _names(unit: Unit, node: Node) -> Iterator[None]:
    """Open a block's scope of names, and record its start and end, in its variables, too."""
    with unit.new_scope() as scope:
        yield
    ends = record_block(unit, scope, node)
    if ends is not None:
        for symbol in scope.names.values():
            if isinstance(symbol, ObjectSymbol) and not symbol.is_external:
                symbol.block = ends


def record_block(unit: Unit, scope: Scope, node: Node) -> tuple[Location, Location] | None:
    """Keep the names of a block for debuggers; return its start and end, if they are known."""
    if not isinstance(node.coord, Span):
        return None
    ends = node.coord.first.location, node.coord.last.location
    unit.blocks.append((scope, ends))
    return ends


@contextmanager
def _block(unit: Unit, node: Node, out: list[Statement]) -> Iterator[None]:
    """Open a block's scope of names, local labels and variables' memory."""
    state = _function(unit)
    state.label_names.append({})
    try:
        with _names(unit, node), vla.block(state, out, unit.at(node)):
            yield
    finally:
        state.label_names.pop()


@checks_statement(c_ast.EmptyStatement, c_ast.Pragma)
def null_statement(_unit: Unit, _node: Node, _out: list[Statement]) -> None:
    """Check `;`, and ignore `#pragma`."""


def _own_scope(unit: Unit) -> AbstractContextManager[object]:
    """Open the scope of an `if`, `switch` or loop, which is a block since C99 (6.8.4p3)."""
    return nullcontext() if is_c90(unit.standard) else unit.new_scope()


def _condition(unit: Unit, node: Node) -> Expression:
    """Check a controlling expression; report an invalid one and replace it."""
    found = unit.attempt(_scalar, node)
    return tree.integer(1, INT, unit.at(node)) if found is None else found


def _scalar(unit: Unit, node: Node) -> Expression:
    value = truth(rvalue(unit, node))
    if not is_scalar(value.type):
        text = f"statement requires an expression of scalar type ('{value.type}' invalid)"
        raise CheckError(value.location, text)
    return value


@checks_statement(c_ast.If)
def if_(unit: Unit, node: Node, out: list[Statement]) -> None:
    """Check `if`."""
    with _own_scope(unit):
        condition = _condition(unit, node.cond)
        then = body(unit, node.iftrue)
        otherwise = body(unit, node.iffalse)
    out.append(tree.If(unit.at(node), condition, then, otherwise))


@checks_statement(c_ast.While, c_ast.DoWhile)
def while_(unit: Unit, node: Node, out: list[Statement]) -> None:
    """Check `while` and `do`."""
    location = unit.at(node)
    is_while = isinstance(node, c_ast.While)
    with _own_scope(unit):
        if is_while:
            condition = _condition(unit, node.cond)
        inner = _loop_body(unit, node.stmt)
        if not is_while:
            condition = _condition(unit, node.cond)
    out.append(tree.Loop(location, [], condition, None, inner, tests_first=is_while))


@checks_statement(c_ast.For)
def for_(unit: Unit, node: Node, out: list[Statement]) -> None:
    """Check `for`."""
    location = unit.at(node)
    start: list[Statement] = []
    first, entries = len(out), _entries(_function(unit))
    with _names(unit, node), vla.block(_function(unit), out, location):
        if isinstance(node.init, c_ast.DeclList):
            for each in node.init.decls:
                statement(unit, each, start)
        elif node.init is not None:
            statement(unit, node.init, start)
        condition = None if node.cond is None else _condition(unit, node.cond)
        step = None if node.next is None else unit.attempt(rvalue, node.next)
        inner = _loop_body(unit, node.stmt)
        out.append(tree.Loop(location, start, condition, step, inner))
    if isinstance(node.init, c_ast.DeclList) and _entries(_function(unit)) == entries:
        _limit(out, first, location, start)


def _loop_body(unit: Unit, node: Node) -> list[Statement]:
    state = _function(unit)
    state.loops.append(len(state.automatics))
    state.breakable.append(len(state.automatics))
    inner = body(unit, node)
    state.loops.pop()
    state.breakable.pop()
    return inner


@checks_statement(c_ast.Break)
def break_(unit: Unit, node: Node, out: list[Statement]) -> None:
    """Check `break`."""
    state, location = _function(unit), unit.at(node)
    if not state.breakable:
        unit.error(location, "'break' statement not in loop or switch statement")
        return
    vla.leave(state, state.breakable[-1], out, location)
    out.append(tree.Break(location))


@checks_statement(c_ast.Continue)
def continue_(unit: Unit, node: Node, out: list[Statement]) -> None:
    """Check `continue`."""
    state, location = _function(unit), unit.at(node)
    if not state.loops:
        unit.error(location, "'continue' statement not in loop statement")
        return
    vla.leave(state, state.loops[-1], out, location)
    out.append(tree.Continue(location))


@checks_statement(c_ast.Goto)
def goto(unit: Unit, node: Node, out: list[Statement]) -> None:
    """Check `goto`; its label is checked at the function's end."""
    made = tree.Goto(unit.at(node), _label_name(unit, node.name))
    state = _function(unit)
    state.gotos.append((made, list(state.automatics)))
    out.append(made)


@checks_statement(c_ast.Label)
def label(unit: Unit, node: Node, out: list[Statement]) -> None:
    """Check a label and the statement after it."""
    location, state = unit.at(node), _function(unit)
    name = _label_name(unit, node.name)
    if name in state.labels:
        hint = f"first at {state.labels[name][0]}"
        unit.error(location, f"redefinition of label '{node.name}'", hint)
    state.labels[name] = location, list(state.automatics)
    out.append(tree.Label(location, name))
    if node.stmt is not None:
        statement(unit, node.stmt, out)


def _label_name(unit: Unit, name: str) -> str:
    """Return a label's name in its function; a local label gets a unique one."""
    for names in reversed(_function(unit).label_names):
        if name in names:
            return names[name]
    return name


@checks_statement(LocalLabels)
def local_labels(unit: Unit, node: LocalLabels, _out: list[Statement]) -> None:
    """Check `__label__`."""
    names = _function(unit).label_names
    if not names:
        raise CheckError(unit.at(node), "'__label__' outside of a block")
    names[-1].update((name, f"{name}.{unit.at(node)}") for name in node.names)


@checks(LabelAddress)
def label_address(unit: Unit, node: LabelAddress) -> Expression:
    """Check `&&label`, whose value is a unique number of the label in its function."""
    location = unit.at(node)
    if unit.function is None:
        raise CheckError(location, "address of a label used outside of a function body")
    name, known = _label_name(unit, node.name), unit.function.addresses
    number, _ = known.setdefault(name, (len(known) + 1, location))
    return tree.Literal(PointerType(VOID), location, number)


@checks_statement(ComputedGoto)
def computed_goto(unit: Unit, node: ComputedGoto, out: list[Statement]) -> None:
    """Check `goto *target`."""
    unit.attempt(_computed_goto, node, out)


def _computed_goto(unit: Unit, node: ComputedGoto, out: list[Statement]) -> None:
    anything = PointerType(qualify(VOID, const=True, volatile=False))
    target = assigned(unit, rvalue(unit, node.target), anything, "assign")
    out.append(tree.ComputedGoto(unit.at(node), target, _function(unit).addresses))


def check_labels(unit: Unit) -> None:
    """Report every `goto` whose label does not exist or must not be jumped to."""
    state = _function(unit)
    for name, (_, location) in state.addresses.items():
        if name not in state.labels:
            unit.error(location, f"use of undeclared label '{name}'")
    for each, automatics in state.gotos:
        if each.name not in state.labels:
            each.nonlocal_goto = nonlocal_goto(state, each)
            if each.nonlocal_goto is None:
                unit.error(each.location, f"use of undeclared label '{each.name}'")
            continue
        there = state.labels[each.name][1]
        each.release = vla.jump(unit, "'goto'", each.location, automatics, there)


@checks_statement(c_ast.Switch)
def switch(unit: Unit, node: Node, out: list[Statement]) -> None:
    """Check `switch`."""
    location = unit.at(node)
    state = _function(unit)
    with _own_scope(unit):
        value = unit.attempt(_switch_value, node.cond)
        if value is None:
            value = tree.integer(0, INT, location)
        opened = SwitchState(value.type, len(state.automatics))
        state.switches.append(opened)
        state.breakable.append(len(state.automatics))
        inner = body(unit, node.stmt)
        state.breakable.pop()
        state.switches.pop()
    out.append(tree.Switch(location, value, inner, opened.labels))


def _switch_value(unit: Unit, node: Node) -> Expression:
    value = rvalue(unit, node)
    if not is_integer(value.type):
        text = f"statement requires expression of integer type ('{value.type}' invalid)"
        raise CheckError(value.location, text)
    return promote(value)


@checks_statement(c_ast.Case, c_ast.Default)
def case(unit: Unit, node: Node, out: list[Statement]) -> None:
    """Check a `case` or `default` label and the statements after it."""
    made = unit.attempt(_case_label, node)
    if made is not None:
        out.append(made)
    for each in node.stmts or []:
        statement(unit, each, out)


def _case_label(unit: Unit, node: Node) -> tree.CaseLabel | None:
    state, location = _function(unit), unit.at(node)
    what = "case" if isinstance(node, c_ast.Case) else "default"
    if not state.switches:
        raise CheckError(location, f"'{what}' statement not in switch statement")
    opened = state.switches[-1]
    outside = state.automatics[: opened.automatics]
    vla.jump(unit, "'switch'", location, outside, state.automatics)
    if isinstance(node, c_ast.Default):
        if opened.default is not None:
            text = "multiple default labels in one switch"
            raise CheckError(location, text, f"first at {opened.default}")
        opened.default = location
        made = tree.CaseLabel(location, None)
    else:
        is_range = isinstance(node.expr, Range)
        first = _case_value(unit, node.expr.first if is_range else node.expr, opened)
        last = _case_value(unit, node.expr.last, opened) if is_range else first
        if first > last:
            unit.warning(
                location, f"empty case range specified: {first} > {last}", flag="empty-case-range"
            )
            return None
        _enter_case(opened, first, last, location)
        made = tree.CaseLabel(location, first, last)
    opened.labels.append(made)
    return made


def _case_value(unit: Unit, node: Node, opened: SwitchState) -> int:
    exact, ctype = constant.integer(unit, node, "case label"), opened.type
    assert isinstance(ctype, IntegerType)
    return wrap(exact, 8 * ctype.size, ctype.signed)


def _enter_case(opened: SwitchState, first: int, last: int, location: Location) -> None:
    """Record a `case`, whose value must be unique (C17 6.8.4.2p3)."""
    number = bisect_left(opened.lows, first)
    before, following = opened.cases[max(0, number - 1) : number], opened.cases[number : number + 1]
    if before and before[0][0] >= first:
        hint = f"first at {before[0][1]}"
        raise CheckError(location, f"duplicate case value '{first}'", hint)
    if following and opened.lows[number] <= last:
        hint = f"first at {following[0][1]}"
        raise CheckError(location, f"duplicate case value '{opened.lows[number]}'", hint)
    opened.lows.insert(number, first)
    opened.cases.insert(number, (last, location))


@checks_statement(c_ast.Return)
def return_(unit: Unit, node: Node, out: list[Statement]) -> None:
    """Check `return`."""
    unit.attempt(_return, node, out)


def _return(unit: Unit, node: Node, out: list[Statement]) -> None:
    state, location = _function(unit), unit.at(node)
    name = state.symbol.name
    if node.expr is None:
        if not isinstance(state.result, VoidType) and not state.returns_implicit_int:
            unit.warning(
                location, f"non-void function '{name}' should return a value", flag="return-type"
            )
        out.append(_leave(state, location, None))
        return
    value = decay(expression(unit, node.expr))
    warn_returned(unit, value)
    if isinstance(state.result, VoidType):
        if not isinstance(value.type, VoidType):
            unit.warning(
                location, f"void function '{name}' should not return a value", flag="return-type"
            )
        out.append(tree.ExpressionStatement(location, convert(value, VOID)))
        out.append(_leave(state, location, None))
        return
    out.append(_leave(state, location, assigned(unit, value, state.result, "return")))


def _leave(state: FunctionState, location: Location, value: Expression | None) -> tree.Return:
    made = tree.Return(location, value, vla.release(state.automatics, 0, location))
    state.returns.append(made)
    return made


@checks(StatementExpression)
def statement_expression(unit: Unit, node: StatementExpression) -> Expression:
    """Check `({ ... })`, a statement used as an expression (GNU C)."""
    location, body_ = unit.at(node), node.body
    if unit.function is None:
        raise CheckError(location, "statement expression not allowed at file scope")
    out: list[Statement] = []
    with _block(unit, body_, out):
        for each in body_.block_items or []:
            statement(unit, each, out)
        value = _last_value(unit.function, out)
    return tree.StatementExpression(VOID if value is None else value.type, location, out, value)


def _last_value(state: FunctionState, out: list[Statement]) -> Expression | None:
    """Remove and return the value at the end of a statement expression, if it has one.

    It is saved in a variable if the memory that it may be in is freed at the end.
    """
    if not out or not isinstance(last := out[-1], tree.ExpressionStatement):
        return None
    out.pop()
    value, location = decay(last.expression), last.location
    if isinstance(value.type, VoidType) or vla.release(state.automatics, 0, location) is None:
        return value
    kept = ObjectSymbol("", value.type, location, in_memory=not is_scalar(value.type))
    name = tree.ObjectName(value.type, location, kept)
    assign = tree.Assign(value.type, location, name, value)
    out.append(tree.ExpressionStatement(location, assign))
    return name
