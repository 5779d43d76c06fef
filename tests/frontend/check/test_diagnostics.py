"""The text and location of messages for single mistakes."""

from __future__ import annotations

import pytest

from tests.frontend.compiling import messages

ONE_ERROR = {
    # Names
    "int speed; int f(void) { return sped; }":
        "1:33 error: use of undeclared identifier 'sped' [did you mean 'speed'?]",
    "int f(void) { sped = 1; sped = 2; return sped; }":
        "1:15 error: use of undeclared identifier 'sped'",
    "int f(void) { goto end; }": "1:15 error: use of undeclared label 'end'",
    "int f(void) { a: a: return 1; }": "1:18 error: redefinition of label 'a' [first at a.c:1:15]",
    "int x = 3; int x = 4;": "1:16 error: redefinition of 'x' [first at a.c:1:5]",
    "int f(void) { int x; char x; return 0; }":
        "1:27 error: redefinition of 'x' [first at a.c:1:19]",
    "int f(void) { return 1; } int f(void) { return 2; }":
        "1:31 error: redefinition of 'f' [first at a.c:1:5]",
    "int x; int x(void);":
        "1:12 error: redefinition of 'x' as a different kind of symbol, previously an object "
        "[first at a.c:1:5]",
    "struct s { int a; }; struct s { int b; };":
        "1:29 error: redefinition of 'struct s' [first defined at a.c:1:8]",
    "enum { A }; enum { A };": "1:20 error: redefinition of 'A' [first at a.c:1:8]",
    "struct s { int a, b, a; };": "1:8 error: duplicate member 'a'",
    "int f(int a, int a) { return a; }": "1:18 error: redefinition of parameter 'a'",
    "string s;":
        "1:1 error: unknown type name 'string'"
        " [C has no string type: use 'char *' or an array of char]",
    "Boolean on;": "1:1 error: unknown type name 'Boolean' [use 'bool' from <stdbool.h>]",
    # What is no C
    "class robot { int x; };":
        "1:1 error: unknown type name 'class' [this is C++, but crs compiles C]",
    "using namespace std;":
        "1:16 error: expected ';' after 'namespace' [this is C++, but crs compiles C]",
    "int *f(void) { return new int[4]; }":
        "1:26 error: expected ';' after 'new' [this is C++, but crs compiles C]",
    "void g(void); void f(void) { try { g(); } }":
        "1:34 error: function definition is not allowed here"
        " [this is C++, but crs compiles C]",
    "int f(void) { int this = 1\n int y; return this; }": "1:27 error: expected ';' after '1'",
    "int f(void) { int new = 1; new new; return 0; }": "1:31 error: expected ';' after 'new'",
    # Names again
    "#define STATE_X 34\nint f(int *s) { return s[state_x]; }":
        "2:26 error: use of undeclared identifier 'state_x' [did you mean 'STATE_X'?]",
    "speed_t fast; int f(speed_t s) { return s + fast; }":
        "1:1 error: unknown type name 'speed_t'",
    "typedef int speed_t; int f(const sped_t *s);":
        "1:34 error: unknown type name 'sped_t' [did you mean 'speed_t'?]",
    "static int g(int); int f(void) { return g(1); }":
        "1:41 error: static function 'g' is used, but defined nowhere",
    # Semicolons that are missing at the end of a line
    "struct p { int x; }\nint f(void) { return 1; }": "1:20 error: expected ';' after '}'",
    "struct p { int x; }\nstruct q { int y; }; struct q v;": "1:20 error: expected ';' after '}'",
    "typedef struct { int x; } P\nstatic P a; int f(void) { return a.x; }":
        "1:28 error: expected ';' after 'P'",
    "void turn(int a)\nint f(void) { turn(1); return 0; }": "1:17 error: expected ';' after ')'",
    # What a word processor makes of a string
    "int puts(char *); int f(void) { return puts(\u201chello, %d\u201d); }":
        "1:45 error: unexpected character '\u201c' [write \"]",
    # Misspelt keywords
    "viod f(unsigned n) { }": "1:1 error: unknown type name 'viod' [did you mean 'void'?]",
    "int f(unsinged n) { return n; }":
        "1:7 error: unknown type name 'unsinged' [did you mean 'unsigned'?]",
    "int f(int n) { whlie (n) { n--; } return n; }":
        "1:16 error: use of undeclared identifier 'whlie' [did you mean 'while'?]",
    "int f(int n) { if (n) n--; esle n++; return n; }":
        "1:28 error: use of undeclared identifier 'esle' [did you mean 'else'?]",
    # Members
    "struct p { int x, y; } v; int f(void) { return v.z; }":
        "1:50 error: no member named 'z' in 'struct p' [its members are x, y]",
    "struct p { int x; }; int f(struct p *v) { return v.x; }":
        "1:52 error: member reference type 'struct p *' is not a structure or union [use '->']",
    "struct p { int x; }; int f(struct p v) { return v->x; }":
        "1:52 error: member reference type 'struct p' is not a pointer [use '.']",
    "struct p; int f(struct p *v) { return v->x; }":
        "1:42 error: incomplete definition of type 'struct p'",
    # Calls
    "int g(int, int); int f(void) { return g(1); }":
        "1:39 error: too few arguments to function call, expected 2, have 1 "
        "['g' is declared at a.c:1:5, as 'int g(int, int)']",
    "int g(int, int); int f(void) { return g(1, 2, 3); }":
        "1:39 error: too many arguments to function call, expected 2, have 3 "
        "['g' is declared at a.c:1:5, as 'int g(int, int)']",
    "int g(int, ...); int f(void) { return g(); }":
        "1:39 error: too few arguments to function call, expected at least 1, have 0 "
        "['g' is declared at a.c:1:5, as 'int g(int, ...)']",
    "struct s { int a; } v; int g(int); int f(void) { return g(v); }":
        "1:59 error: passing 'struct s' to parameter of incompatible type 'int'",
    "int x; int f(void) { return x(1); }":
        "1:29 error: called object type 'int' is not a function or function pointer",
    # Operators
    'int f(void) { return "a" * 2; }':
        "1:22 error: invalid operands to binary expression ('char *' and 'int')",
    "float f(float x) { return x % 2; }":
        "1:27 error: invalid operands to binary expression ('float' and 'int')",
    "struct { int a; } v; int f(void) { return !v; }":
        "1:43 error: invalid argument type 'struct <anonymous>' to unary expression",
    "int f(int x) { return *x; }":
        "1:23 error: indirection requires pointer operand ('int' invalid)",
    "int f(int x) { return &x + &x; }":
        "1:23 error: invalid operands to binary expression ('int *' and 'int *')",
    "int f(int *x) { return x[1.5]; }": "1:26 error: array subscript is not an integer ('double')",
    "int f(int x) { return x[0]; }": "1:23 error: subscripted value is not an array or pointer",
    "struct s *p; struct s *f(void) { return p + 1; }":
        "1:41 error: arithmetic on a pointer to incomplete type 'struct s'",
    "int *f(void) { return &3; }": "1:23 error: cannot take the address of an rvalue of type 'int'",
    "int f(void) { return sizeof(struct s); }":
        "1:22 error: invalid application of 'sizeof' to incomplete type 'struct s'",
    "struct s { int a; } v; int f(void) { return 1 ? v : 2; }":
        "1:49 error: incompatible operand types ('struct s' and 'int')",
    # Assignments
    "int f(void) { 3 = 4; return 0; }": "1:15 error: expression is not assignable",
    "struct r { char name[8]; } r; void f(void) { r.name = \"left\"; }":
        "1:46 error: array type 'char[8]' is not assignable [copy the text into it, with strcpy]",
    "int f(int *b) { int a[3]; a = b; return 0; }":
        "1:27 error: array type 'int[3]' is not assignable"
        " [copy its elements one by one, or all with memcpy]",
    "int f(void) { char a[3]; a = \"up\"; return 0; }":
        "1:26 error: array type 'char[3]' is not assignable"
        " [copy the text into it: strcpy(a, ...)]",
    "typedef struct __f FILE; int fgets(char *, int, FILE *); int f(FILE *g) { fgets(0, g); }":
        "1:75 error: too few arguments to function call, expected 3, have 2"
        " ['fgets' is declared at a.c:1:30, as 'int fgets(char *, int, FILE *)']",
    "int f(void) { int a[3]; a = 0; return 0; }":
        "1:25 error: array type 'int[3]' is not assignable",
    "int f(void) { const int x = 3; x = 4; return x; }":
        "1:32 error: cannot assign to variable 'x' with const-qualified type 'const int'",
    "int f(const int *p) { *p = 3; return 0; }":
        "1:23 error: cannot assign to read-only location with const-qualified type 'const int'",
    "int f(void) { double d = 1; int *p; p = d; return 0; }":
        "1:41 error: assigning to 'int *' from incompatible type 'double'",
    "struct a { int x; } v; struct b { int x; } w; void f(void) { v = w; }":
        "1:66 error: assigning to 'struct a' from incompatible type 'struct b'",
    "struct a { int x; } v; int f(void) { return v; }":
        "1:45 error: returning 'struct a' from a function with incompatible result type 'int'",
    "struct a { int x; } v; int f(void) { int i = v; return i; }":
        "1:46 error: initializing 'int' with an expression of incompatible type 'struct a'",
    # Statements
    "int f(void) { break; }": "1:15 error: 'break' statement not in loop or switch statement",
    "int f(int x) { switch (x) { default: continue; } return 0; }":
        "1:38 error: 'continue' statement not in loop statement",
    "int f(int x) { switch (x) { case 1: case 2 - 1: ; } return 0; }":
        "1:37 error: duplicate case value '1' [first at a.c:1:29]",
    "int f(int x) { switch (x) { default: default: ; } return 0; }":
        "1:38 error: multiple default labels in one switch [first at a.c:1:29]",
    "int f(void) { case 1: return 0; }": "1:15 error: 'case' statement not in switch statement",
    "int f(double x) { switch (x) { } return 0; }":
        "1:27 error: statement requires expression of integer type ('double' invalid)",
    "struct { int a; } v; void f(void) { if (v) ; }":
        "1:41 error: statement requires an expression of scalar type "
        "('struct <anonymous>' invalid)",
    # Declarations
    "int f(void) { void x; return 0; }": "1:20 error: variable 'x' has incomplete type 'void'",
    "struct s v;": "1:10 error: variable 'v' has incomplete type 'struct s'",
    "int f(void), a[3](void);": "1:14 error: array of functions of type 'int (void)'",
    "int f(void)[3];": "1:5 error: function cannot return an array of type 'int[3]'",
    "int f(int); float f(int);":
        "1:19 error: conflicting types for 'f' ('float (int)' vs 'int (int)') "
        "[first declared at a.c:1:5]",
    "extern int x; float x;":
        "1:21 error: redefinition of 'x' with a different type: 'float' and 'int' "
        "[first declared at a.c:1:12]",
    "struct { int a : 33; } v;":
        "1:14 error: width of bit-field 'a' (33 bits) exceeds that of its type",
    "struct s { struct s a; };": "1:21 error: member 'a' has incomplete type 'struct s'",
    "int a[3] = {[5] = 1};": "1:13 error: array designator index (5) exceeds array bounds",
    "struct { int a; } v = {.b = 1};":
        "1:25 error: field designator 'b' does not refer to any field in type "
        "'struct <anonymous>'",
    # Not supported, by name
    "__int128 z;": "1:1 error: type '__int128' is not supported "
    "[use 'long long', or a struct of two of them]",
    # Syntax
    "int f(void) { return 1 }": "1:23 error: expected ';' after '1'",
    "int a = 3\nint b = 4;": "1:10 error: expected ';' after '3'",
    "int f(int x) { while (x { x--; } return x; }":
        "1:25 error: expected ')' before '{' [to close the '(' at a.c:1:22]",
    "int f(void) { return (1 + ); }": "1:27 error: expected an expression before ')'",
    "int f(void) { }}": "1:16 error: expected a declaration before '}'",
    "int f(void) { else return 1; }": "1:15 error: 'else' without a previous 'if'",
    "int f(void) {": "1:13 error: unexpected end of file [to close the '{' at a.c:1:13]",
    "struct { int a } v;": "1:15 error: expected ';' after 'a'",
}  # fmt: skip


@pytest.mark.parametrize("source", ONE_ERROR)
def test_errors(source: str) -> None:
    assert [each for each in messages(source) if "warning" not in each] == [ONE_ERROR[source]]


ONE_WARNING = {
    "main() { return 0; }": "1:1 warning: type specifier missing, defaults to 'int'",
    "static count;": "1:1 warning: type specifier missing, defaults to 'int'",
    "int f(void) { register i = 3; return i; }":
        "1:15 warning: type specifier missing, defaults to 'int'",
    "int f(void) { return g(1); }": "1:22 warning: implicit declaration of function 'g'",
    "int printf(); int f(void) { return prinft(1); }":
        "1:36 warning: implicit declaration of function 'prinft' [did you mean 'printf'?]",
    "int f(void) { return g(1); } void g(int n) { }":
        "1:22 warning: implicit declaration of function 'g'",
    "int *f(void) { return 3; }":
        "1:23 warning: incompatible integer to pointer conversion returning 'int' from a function "
        "with result type 'int *'",
    "int f(char *s) { return s; }":
        "1:25 warning: incompatible pointer to integer conversion returning 'char *' from a "
        "function with result type 'int'",
    "int g(int *); int f(double *d) { return g(d); }":
        "1:43 warning: incompatible pointer types passing 'double *' to parameter of type 'int *'",
    "int g(int *); int f(const int *p) { return g(p); }":
        "1:46 warning: passing 'const int *' to parameter of type 'int *' discards qualifiers",
    "int f(int *p, char *q) { return p == q; }":
        "1:33 warning: comparison of distinct pointer types ('int *' and 'char *')",
    "int f(int *p) { return p == 3; }":
        "1:24 warning: comparison between pointer and integer ('int *' and 'int')",
    "int f(int n) { return; }": "1:16 warning: non-void function 'f' should return a value",
    "void f(int n) { return n; }": "1:17 warning: void function 'f' should not return a value",
    "int f(int n) { return n / 0; }": "1:23 warning: division by zero is undefined",
    "int f(int n) { return n << 32; }": "1:28 warning: shift count is >= width of type",
    "int a[2] = {1, 2, 3};": "1:19 warning: excess elements in initializer",
    'char s[2] = "abc";': "1:13 warning: initializer string for char array is too long",
    "int a[];": "1:5 warning: array 'a' assumed to have one element",
    "extern int x = 3;": "1:12 warning: 'x' initialized and declared 'extern'",
    "int f(int n, ...) { __builtin_va_list a; __builtin_va_start(a, n); "
    "return __builtin_va_arg(a, char); }":
        "1:75 warning: 'char' is promoted to 'int' when passed through '...' "
        "[so pass 'int' not 'char' to 'va_arg']",
}  # fmt: skip


@pytest.mark.parametrize("source", ONE_WARNING)
def test_warnings(source: str) -> None:
    found = messages(source)
    assert ONE_WARNING[source] in found
    assert all("warning" in each for each in found)


QUIET = [
    "int f(a, b) char *b; { return a + *b; }",
    "int f(); int g(void) { return f(1, 2) + f(); } int f(a) int a; { return a; }",
    "extern int State[]; int State[45]; int State[45];",
    "int x; int x; extern int x; static int y; static int y;",
    "typedef int T; typedef int T; T f(T T) { return T; }",
    "char *s = (void *)0; int *p = 0; void *v; int *f(void) { return v; }",
    "unsigned char *f(char *s) { return (unsigned char *)s; }",
    "struct s; struct s *f(void); struct s { struct s *next; }; struct s v;",
    "void f(void) { int g = 3; { extern int g; g = 2; } g = 4; }",
    "int f(void); int (*table[])(void) = {f, &f, *f}; int g(void) { return (*table[1])(); }",
    "int f(short); int f(s) short s; { return s; }",
    "int f(double); int f(x) float x; { return x; }",
    "enum e { A, B }; int f(enum e); int g(void) { return f(1) + A; }",
]


@pytest.mark.parametrize("source", QUIET)
def test_valid_code_has_no_messages(source: str) -> None:
    assert messages(source) == []


def test_all_errors_of_a_file_are_reported() -> None:
    source = """int f(void) { int x = ; return x; }
int g(void) { return undefined1 + undefined2; }
int h(void) { while (g() { } return 3 }
struct s { int x; } v;
int i(void) { v.y = 1; if (v) v.z = 2; return k; }
"""
    assert [each.partition(" ")[0] for each in messages(source)] == [
        "1:23", "2:22", "3:26", "3:38", "5:17", "5:28", "5:33", "5:47",
    ]  # fmt: skip


def test_number_of_reported_errors_is_limited() -> None:
    found = messages("\n".join(f"int f{n}(void) {{ return u{n}; }}" for n in range(100)))
    assert len(found) == 21
    assert found[-1] == "21:0 error: and 80 more errors from here on"
