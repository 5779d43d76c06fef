/* A language of its own: tokens, a parser that makes code for a stack machine, the machine. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum op { PUSH, LOAD, STORE, ADD, SUB, MUL, DIV, LESS, EQUAL, JUMP, JUMP_ZERO, PRINT, HALT };

static const char *const op_names[] = {
    "push", "load", "store", "add", "sub", "mul", "div", "less", "equal", "jump", "jump0", "print",
    "halt",
};

static struct { enum op op; int value; } code[200];
static int length;
static const char *text;
static char token[16];

static void fail(const char *why)
{
    printf("error: %s at '%s'\n", why, token);
    exit(1);
}

static void next(void)
{
    int n = 0;
    while (isspace((unsigned char) *text))
        text++;
    if (isalnum((unsigned char) *text))
        while (isalnum((unsigned char) *text) && n < 15)
            token[n++] = *text++;
    else if (*text) {
        token[n++] = *text++;
        if (*text == '=' && strchr("=<", token[0]))
            token[n++] = *text++;
    }
    token[n] = 0;
}

static int is(const char *what) { return strcmp(token, what) == 0; }
static int accept(const char *what) { return is(what) ? (next(), 1) : 0; }
static void expect(const char *what) { if (!accept(what)) fail(what); }

static int emit(enum op op, int value)
{
    code[length].op = op;
    code[length].value = value;
    return length++;
}

static int variable(void)
{
    if (!isalpha((unsigned char) token[0]) || token[1])
        fail("variable");
    int v = token[0] - 'a';
    next();
    return v;
}

static void expression(void);

static void primary(void)
{
    if (isdigit((unsigned char) token[0])) {
        emit(PUSH, atoi(token));
        next();
    } else if (accept("(")) {
        expression();
        expect(")");
    } else if (accept("-")) {
        emit(PUSH, 0);
        primary();
        emit(SUB, 0);
    } else
        emit(LOAD, variable());
}

static void level(int rank)
{
    static const struct { const char *text; int rank; enum op op; } table[] = {
        { "<", 0, LESS }, { "==", 0, EQUAL }, { "+", 1, ADD }, { "-", 1, SUB },
        { "*", 2, MUL }, { "/", 2, DIV },
    };
    if (rank > 2) {
        primary();
        return;
    }
    level(rank + 1);
again:
    for (unsigned i = 0; i < sizeof table / sizeof *table; i++)
        if (table[i].rank == rank && accept(table[i].text)) {
            level(rank + 1);
            emit(table[i].op, 0);
            goto again;
        }
}

static void expression(void) { level(0); }

static void statement(void)
{
    if (accept("{")) {
        while (!accept("}"))
            statement();
    } else if (accept("while")) {
        int start = length, out;
        expression();
        out = emit(JUMP_ZERO, 0);
        statement();
        emit(JUMP, start);
        code[out].value = length;
    } else if (accept("if")) {
        int out, end;
        expression();
        out = emit(JUMP_ZERO, 0);
        statement();
        end = emit(JUMP, 0);
        code[out].value = length;
        if (accept("else"))
            statement();
        code[end].value = length;
    } else if (accept("print")) {
        expression();
        expect(";");
        emit(PRINT, 0);
    } else {
        int v = variable();
        expect("=");
        expression();
        expect(";");
        emit(STORE, v);
    }
}

static long run(void)
{
    int stack[50], *top = stack, variables[26] = { 0 };
    long steps = 0;
    for (int pc = 0;; steps++) {
        int value = code[pc].value;
        switch (code[pc++].op) {
        case PUSH: *top++ = value; break;
        case LOAD: *top++ = variables[value]; break;
        case STORE: variables[value] = *--top; break;
        case ADD: top--; top[-1] += *top; break;
        case SUB: top--; top[-1] -= *top; break;
        case MUL: top--; top[-1] *= *top; break;
        case DIV: top--; top[-1] = *top ? top[-1] / *top : 0; break;
        case LESS: top--; top[-1] = top[-1] < *top; break;
        case EQUAL: top--; top[-1] = top[-1] == *top; break;
        case JUMP: pc = value; break;
        case JUMP_ZERO: if (!*--top) pc = value; break;
        case PRINT: printf("%d ", *--top); break;
        case HALT: printf("\n"); return steps;
        }
    }
}

int main(void)
{
    text = "n = 2; while n < 60 { d = 2; p = 1; while d * d < n + 1 {"
           " if n / d * d == n p = 0; d = d + 1; } if p print n; else f = f + -1; n = n + 1; }"
           " print f; print (1 + 2) * 3 - 4 / 2;";
    next();
    while (token[0])
        statement();
    emit(HALT, 0);
    for (int i = 0; i < length; i += 6)
        printf("%d: %s %d\n", i, op_names[code[i].op], code[i].value);
    printf("%ld steps\n", run());
    return 0;
}
