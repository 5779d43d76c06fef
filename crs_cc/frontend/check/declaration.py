"""Declarations: the object or function that a name designates (C17 6.2.2, 6.7, 6.9).

Declarations of one name are merged: `extern int State[];` and `int State[45];` are one object, a
call of an unknown function and its later definition are one function.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree, vla
from crs_cc.frontend.check.alignment import (
    alignment,
    attribute_alignment,
    attributes,
    has_attribute,
    natural_alignment,
)
from crs_cc.frontend.check.asm_label import alias, asm_label
from crs_cc.frontend.check.checker import (
    Automatic,
    Checked,
    CheckError,
    Unit,
    checks_statement,
    expression,
)
from crs_cc.frontend.check.conversion import decay
from crs_cc.frontend.check.declarator import declared_type, require_complete
from crs_cc.frontend.check.function_attributes import apply_attributes
from crs_cc.frontend.check.initializer import initialise, known_value
from crs_cc.frontend.check.local_object import declare_local
from crs_cc.frontend.check.mode import with_mode
from crs_cc.frontend.check.nested import declare_nested
from crs_cc.frontend.check.scope import (
    BrokenName,
    FunctionSymbol,
    ObjectSymbol,
    Symbol,
    Tag,
    TypedefName,
)
from crs_cc.frontend.check.tag import static_assert
from crs_cc.frontend.check.type_compat import compatible, composite
from crs_cc.frontend.parse.nodes import AUTO_TYPE, Broken, Node
from crs_cc.ir.types import (
    ArrayType,
    CType,
    EnumType,
    FunctionType,
    Record,
    RecordType,
    is_complete,
    is_variably_modified,
    qualify,
)

_STORAGE_CLASSES: Final = {"static", "extern", "auto", "register"}


def declare(unit: Unit, node: Node, out: list[tree.Statement] | None = None) -> None:
    """Check a declaration; append its actions at run time to `out`.

    Raises:
        CheckError: it has an error.
    """
    with vla.effects(unit) as effects:
        ctype = None if node.name is None else declared_or_broken(unit, node)
        if ctype is None:
            _declare_tag(unit, node)
    _do(effects, out)
    if ctype is not None:
        declare_as(unit, node, ctype, out)


def declare_as(
    unit: Unit, node: Node, ctype: CType, out: list[tree.Statement] | None = None
) -> None:
    """Check a declaration whose declarator has a type; see `declare`."""
    storage = set(node.storage or []) - ({"auto"} if _is_auto(node.type) else set())
    location = unit.at_name(node)
    if len(_STORAGE_CLASSES & storage) > 1:  # C17 6.7.1p2
        raise CheckError(location, f"multiple storage classes in the declaration of '{node.name}'")
    if "constexpr" in storage:
        ctype = qualify(ctype, const=True, volatile=False)
    if isinstance(ctype, FunctionType):
        _declare_function(unit, node, ctype, location)
    elif unit.function is None or "extern" in storage:
        _declare_global(unit, node, ctype, location)
    else:
        declare_local(unit, node, ctype, location, out)


def _do(effects: list[tree.Expression], out: list[tree.Statement] | None) -> None:
    """Append the side effects of a declaration's type to the statements."""
    if out is not None:
        out.extend(tree.ExpressionStatement(each.location, each) for each in effects)


def declared_or_broken(unit: Unit, node: Node) -> CType:
    """Return the type of a declaration.

    Raises:
        CheckError: it has an error; its name is declared nevertheless, to avoid further errors.
    """
    try:
        if _is_auto(node.type):
            return _inferred(unit, node)
        return with_mode(node, declared_type(unit, node.type))
    except CheckError:
        unit.scope.names.setdefault(node.name, BrokenName(node.name, unit.at(node)))
        raise


def _is_auto(node: Node) -> bool:
    """Return whether a declarator is a name with GNU C's `__auto_type`, or C23's `auto`."""
    specifier = node.type if isinstance(node, c_ast.TypeDecl) else None
    is_named = isinstance(specifier, c_ast.IdentifierType) and specifier.names == [AUTO_TYPE]
    return is_named or isinstance(specifier, c_ast.InferredType)


def _inferred(unit: Unit, node: Node) -> CType:
    """Return the type of the initialiser, which is checked only once."""
    if getattr(node, "init", None) is None or isinstance(node.init, c_ast.InitList):
        text = f"'{AUTO_TYPE}' requires exactly one initializer"
        raise CheckError(unit.at_name(node), text)
    value = decay(expression(unit, node.init))
    node.init = Checked(value, node.init.coord)
    quals = node.type.quals
    return qualify(value.type, "const" in quals, "volatile" in quals)


def _declare_tag(unit: Unit, node: Node) -> None:
    specifier = node.type
    is_tag = isinstance(specifier, c_ast.Struct | c_ast.Union | c_ast.Enum)
    if is_tag and specifier.name is not None and specifier.name not in unit.scope.tags:
        # `struct s;` declares a new struct even if there is one in an outer scope (6.7.2.3p7).
        is_bare = not isinstance(specifier, c_ast.Enum) and specifier.decls is None
        if is_bare:
            is_struct = isinstance(specifier, c_ast.Struct)
            ctype = RecordType(Record("struct" if is_struct else "union", specifier.name))
            unit.scope.tags[specifier.name] = Tag(ctype, unit.at(specifier))
    ctype_ = declared_type(unit, specifier)
    has_tag = isinstance(ctype_, RecordType) and ctype_.record.tag is not None
    if not has_tag and not isinstance(ctype_, EnumType):
        unit.warning(
            unit.at(node), "declaration does not declare anything", flag="missing-declarations"
        )


def typedef(unit: Unit, node: Node, out: list[tree.Statement] | None = None) -> None:
    """Check a typedef; append its actions at run time to `out`."""
    with vla.effects(unit) as effects:
        ctype = declared_or_broken(unit, node)
    _do(effects, out)
    location = unit.at_name(node)
    if is_variably_modified(ctype) and unit.function is not None:
        unit.function.automatics.append(Automatic(node.name, location, None))
    known = unit.scope.names.get(node.name)
    if known is not None and not (isinstance(known, TypedefName) and compatible(known.type, ctype)):
        raise _redefinition(known, node.name, location)
    if known is None:
        align = attribute_alignment(unit, attributes(node)) or natural_alignment(unit, node)
        unit.scope.names[node.name] = TypedefName(node.name, ctype, location, align)
    if isinstance(ctype, RecordType):
        ctype.record.alias = ctype.record.alias or node.name
        ctype.record.is_transparent |= has_attribute(node, "transparent_union")


def _redefinition(known: Symbol, name: str, location: Location) -> CheckError:
    if isinstance(known, BrokenName):
        return CheckError(location, "")
    same = {ObjectSymbol: "object", FunctionSymbol: "function", TypedefName: "type"}
    what = same.get(type(known), "enumerator")
    text = f"redefinition of '{name}' as a different kind of symbol, previously a {what}"
    return CheckError(location, text.replace("a object", "an object"), f"first at {known.location}")


# Functions


def _declare_function(unit: Unit, node: Node, ctype: FunctionType, location: Location) -> None:
    if node.init is not None:
        raise CheckError(location, f"function '{node.name}' is initialized like a variable")
    storage = node.storage or []
    if unit.function is not None and "auto" in storage:  # a nested function, before its definition
        declare_nested(unit, node.name, ctype, location)
        return
    if unit.function is not None and "static" in storage:
        raise CheckError(location, "function declared in block scope cannot be 'static'")
    symbol = declare_function(unit, node.name, ctype, location, "static" in storage)
    apply_attributes(unit, symbol, node)


def declare_function(
    unit: Unit, name: str, ctype: FunctionType, location: Location, is_static: bool
) -> FunctionSymbol:
    """Declare a function, merging it with earlier declarations.

    Raises:
        CheckError: they conflict.
    """
    here = unit.scope.names.get(name)
    if here is not None and not isinstance(here, FunctionSymbol):
        raise _redefinition(here, name, location)
    known = here or unit.externals.get(name) or _visible_function(unit, name)
    if isinstance(known, ObjectSymbol):
        raise _redefinition(known, name, location)
    if known is None:
        link_name = unit.static_name(name) if is_static else name
        known = FunctionSymbol(name, ctype, location, link_name, is_external=not is_static)
        if not is_static:
            unit.add_external(known)
    else:
        _merge_function(unit, known, ctype, location, is_static)
    unit.scope.names[name] = known
    return known


def _visible_function(unit: Unit, name: str) -> FunctionSymbol | None:
    found = unit.scope.find(name)
    return found if isinstance(found, FunctionSymbol) else None


def _merge_function(
    unit: Unit, known: FunctionSymbol, ctype: FunctionType, location: Location, is_static: bool
) -> None:
    differs = (is_static and known.is_external) or not compatible(known.type, ctype)
    if differs and _is_library_function(unit, known) and not _in_headers(unit, location):
        _override_library_function(unit, known, ctype, location, is_static)
        return
    if is_static and known.is_external:
        text = f"static declaration of '{known.name}' follows non-static declaration"
        if not known.is_implicit:
            raise CheckError(location, text, f"first declared at {known.location}")
        unit.warning(
            location, text, f"first called at {known.location}", flag="static-follows-non-static"
        )
        unit.externals.pop(known.name, None)
        known.is_external, known.link_name = False, unit.static_name(known.name)
    if compatible(known.type, ctype):
        known.type = composite(known.type, ctype)  # type: ignore[assignment]
    elif known.is_implicit:
        text = f"conflicting types for '{known.name}'"
        unit.warning(
            location,
            text,
            f"first called at {known.location}, without a declaration",
            flag="conflicting-types",
        )
        known.type = ctype
    elif _differs_in_promotion(known.type, ctype):
        if known.type.parameters is None and not known.is_defined:
            known.type = ctype
    else:
        text = f"conflicting types for '{known.name}' ('{ctype}' vs '{known.type}')"
        raise CheckError(location, text, f"first declared at {known.location}")
    if known.is_implicit or not known.is_defined:
        known.location = location
    known.is_implicit = False


def _in_headers(unit: Unit, location: Location) -> bool:
    return any(Path(location.file).is_relative_to(folder) for folder in unit.headers)


def _is_library_function(unit: Unit, known: FunctionSymbol) -> bool:
    """Return whether a function is declared in the library's headers only."""
    return not known.is_implicit and not known.is_defined and _in_headers(unit, known.location)


def _override_library_function(
    unit: Unit, known: FunctionSymbol, ctype: FunctionType, location: Location, is_static: bool
) -> None:
    """Replace a library function by the program's own, as a `getline` older than POSIX's."""
    text = f"incompatible redeclaration of library function '{known.name}'"
    unit.warning(
        location,
        text,
        f"its type is '{known.type}', see {known.location}",
        flag="library-redeclaration",
    )
    if is_static:
        unit.externals.pop(known.name, None)
        known.is_external, known.link_name = False, unit.static_name(known.name)
    known.type, known.location = ctype, location


def _differs_in_promotion(left: FunctionType, right: FunctionType) -> bool:
    """Return whether old-style and new-style declarations differ only in promoted parameters."""
    one_is_old = (left.parameters is None) != (right.parameters is None)
    return one_is_old and compatible(left.result, right.result)


# Objects with linkage


def _declare_global(unit: Unit, node: Node, ctype: CType, location: Location) -> None:
    storage = node.storage or []
    is_automatic = "auto" in storage and not _is_auto(node.type)
    if unit.function is None and ("register" in storage or is_automatic):
        raise CheckError(location, f"illegal storage class on file-scoped variable '{node.name}'")
    if is_variably_modified(ctype):
        text = f"object '{node.name}' with variably modified type must have no linkage"
        raise CheckError(location, text)
    is_extern = "extern" in storage
    symbol = _global_symbol(unit, node, ctype, location, is_static=_is_internal(storage))
    align = max(alignment(unit, node), natural_alignment(unit, node))
    symbol.align = max(symbol.align, align)
    symbol.is_weak = symbol.is_weak or any(each.name == "weak" for each in attributes(node))
    symbol.link_name = asm_label(node) or symbol.link_name
    symbol.alias = alias(node) or symbol.alias
    if node.init is not None:
        _initialise_global(unit, symbol, node, ctype, location)
    elif not is_extern and not symbol.alias:
        if isinstance(ctype, RecordType) and not is_complete(ctype):
            pass  # C17 6.9.2p3: it may be completed later; checked at the end of the file.
        elif not is_complete(ctype) and not isinstance(ctype, ArrayType):
            raise CheckError(location, f"variable '{node.name}' has incomplete type '{ctype}'")
        if not symbol.is_tentative and not symbol.is_defined:
            symbol.is_tentative = True
            unit.objects.append(tree.ObjectDefinition(symbol, None))


def _is_internal(storage: list[str]) -> bool:
    """Return whether storage classes give internal linkage to an object at file scope."""
    return "static" in storage or "constexpr" in storage


def _global_symbol(
    unit: Unit, node: Node, ctype: CType, location: Location, is_static: bool
) -> ObjectSymbol:
    name = node.name
    here = unit.scope.names.get(name)
    if here is not None and (not isinstance(here, ObjectSymbol) or here.link_name is None):
        raise _redefinition(here, name, location)
    known = here or unit.externals.get(name) or _visible_object(unit, name)
    if isinstance(known, FunctionSymbol):
        raise _redefinition(known, name, location)
    if known is None:
        link_name = unit.static_name(name) if is_static else name
        known = ObjectSymbol(name, ctype, location, link_name, is_external=not is_static)
        if not is_static:
            unit.add_external(known)
    else:
        if is_static and known.is_external:
            text = f"static declaration of '{name}' follows non-static declaration"
            raise CheckError(location, text, f"first declared at {known.location}")
        if not compatible(known.type, ctype):
            text = f"redefinition of '{name}' with a different type: '{ctype}' and '{known.type}'"
            raise CheckError(location, text, f"first declared at {known.location}")
        known.type = composite(known.type, ctype)
    unit.scope.names[name] = known
    return known


def _visible_object(unit: Unit, name: str) -> ObjectSymbol | None:
    found = unit.scope.find(name)
    return found if isinstance(found, ObjectSymbol) and found.link_name is not None else None


def _initialise_global(
    unit: Unit, symbol: ObjectSymbol, node: Node, ctype: CType, location: Location
) -> None:
    if "extern" in (node.storage or []):
        if unit.function is not None:
            raise CheckError(location, f"'{node.name}' has both 'extern' and an initializer")
        unit.warning(
            location, f"'{node.name}' initialized and declared 'extern'", flag="extern-initializer"
        )
    if symbol.is_defined:
        raise CheckError(location, f"redefinition of '{node.name}'", f"first at {symbol.location}")
    symbol.is_defined = True
    symbol.location = location
    made, completed = initialise(unit, ctype, node.init, True)
    symbol.constant = known_value(made, completed)
    symbol.is_constexpr = "constexpr" in (node.storage or [])
    symbol.type = composite(symbol.type, completed)
    require_complete(symbol.type, location, node.name)
    unit.objects.append(tree.ObjectDefinition(symbol, made))


def finish_objects(unit: Unit) -> None:
    """Complete tentative definitions at the end of the file (C17 6.9.2p2)."""
    defined = [each for each in unit.objects if each.initialiser is None]
    for each in defined:
        symbol = each.symbol
        if isinstance(symbol.type, ArrayType) and symbol.type.length is None:
            if symbol.is_defined:
                continue
            text = f"array '{symbol.name}' assumed to have one element"
            unit.warning(symbol.location, text, flag="tentative-array")
            symbol.type = ArrayType(symbol.type.element, 1)
        if not is_complete(symbol.type):
            text = f"variable '{symbol.name}' has incomplete type '{symbol.type}'"
            unit.error(symbol.location, text)
    unit.objects = [
        each
        for each in unit.objects
        if each.initialiser is not None
        or not each.symbol.is_tentative
        or not each.symbol.is_defined
    ]


# Declarations in blocks


def declare_broken(unit: Unit, node: Node) -> None:
    """Declare the names in a declaration with a syntax error."""
    for name in node.names:
        if unit.scope.find(name) is None:
            unit.scope.names[name] = BrokenName(name, unit.at(node))


@checks_statement(Broken)
def _local_broken(unit: Unit, node: Node, _out: list[tree.Statement]) -> None:
    declare_broken(unit, node)


@checks_statement(c_ast.Decl)
def _local_declaration(unit: Unit, node: Node, out: list[tree.Statement]) -> None:
    unit.attempt(declare, node, out)


@checks_statement(c_ast.Typedef)
def _local_typedef(unit: Unit, node: Node, out: list[tree.Statement]) -> None:
    unit.attempt(typedef, node, out)


@checks_statement(c_ast.StaticAssert)
def _local_assertion(unit: Unit, node: Node, _out: list[tree.Statement]) -> None:
    unit.attempt(static_assert, node)
