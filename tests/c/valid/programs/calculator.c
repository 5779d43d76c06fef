/* An expression parser with variables, functions and errors. */
#include <stdio.h>
#include <string.h>
#include <ctype.h>
#include <stdlib.h>
#include <math.h>

static const char *p;
static const char *error;
static double variables[26];

static double expression(void);

static void skip(void)
{
    while (isspace((unsigned char) *p))
        p++;
}

static int accept(char c)
{
    skip();
    if (*p != c)
        return 0;
    p++;
    return 1;
}

static double call(const char *name, double x)
{
    static const struct { const char *name; double (*f)(double); } functions[] = {
        { "sqrt", sqrt }, { "floor", floor }, { "fabs", fabs },
    };
    unsigned i;

    for (i = 0; i < sizeof functions / sizeof *functions; i++)
        if (strcmp(functions[i].name, name) == 0)
            return functions[i].f(x);
    error = "unknown function";
    return 0;
}

static double primary(void)
{
    char name[16], *end;
    int n = 0;
    double x;

    skip();
    if (accept('(')) {
        x = expression();
        if (!accept(')'))
            error = "missing )";
        return x;
    }
    if (accept('-'))
        return -primary();
    if (isalpha((unsigned char) *p)) {
        while (isalpha((unsigned char) *p) && n < 15)
            name[n++] = *p++;
        name[n] = 0;
        if (accept('(')) {
            x = call(name, expression());
            if (!accept(')'))
                error = "missing )";
            return x;
        }
        if (n > 1)
            error = "unknown name";
        return variables[tolower((unsigned char) *name) - 'a'];
    }
    x = strtod(p, &end);
    if (end == p)
        error = "number expected";
    p = end;
    return x;
}

static double power(void)
{
    double x = primary();
    return accept('^') ? pow(x, power()) : x;
}

static double term(void)
{
    double x = power(), y;

    for (;;) {
        if (accept('*'))
            x *= power();
        else if (accept('/')) {
            y = power();
            if (y == 0)
                error = "division by zero";
            x = y ? x / y : 0;
        } else
            return x;
    }
}

static double expression(void)
{
    double x = term();

    for (;;)
        if (accept('+'))
            x += term();
        else if (accept('-'))
            x -= term();
        else
            return x;
}

static void evaluate(const char *text)
{
    int target = -1;
    double x;

    error = 0;
    p = text;
    if (isalpha((unsigned char) text[0]) && text[1] == '=') {
        target = text[0] - 'a';
        p += 2;
    }
    x = expression();
    skip();
    if (!error && *p)
        error = "unexpected text";
    if (error)
        printf("%s: %s at %d\n", text, error, (int) (p - text));
    else
        printf("%s: %g\n", text, x);
    if (!error && target >= 0)
        variables[target] = x;
}

int main(void)
{
    const char *lines[] = { "1 + 2 * 3", "(1+2)*3", "2^3^2", "-2^2", "x=10/4", "x*x - sqrt(x*x)", "1/0",
                            "(1", "2 3", "floor(-2.5)+fabs(-3)", "nosuch(1)", "y", "", "1e3/.5" };
    unsigned i;

    for (i = 0; i < sizeof lines / sizeof *lines; i++)
        evaluate(lines[i]);
    return 0;
}
