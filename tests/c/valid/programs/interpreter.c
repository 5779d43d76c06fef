/* A line-numbered BASIC in a hundred lines: LET, PRINT, IF, GOTO, FOR and NEXT, GOSUB. */
#include <stdio.h>
#include <string.h>
#include <stdlib.h>
#include <ctype.h>

struct line { int number; const char *text; };
static int vars[26], loop_line[8], loop_end[8], loop_var[8], loops, gosub[8], calls;
static const char *p;

static int expr(void);
static void skip(void) { while (*p == ' ') p++; }

static int word(const char *w)
{
    int n = strlen(w);

    skip();
    if (strncmp(p, w, n))
        return 0;
    p += n;
    return 1;
}

static int atom(void)
{
    skip();
    if (isupper((unsigned char) *p))
        return vars[*p++ - 'A'];
    if (*p == '(') {
        int n;
        p++;
        n = expr();
        word(")");
        return n;
    }
    return strtol(p, (char **) &p, 10);
}

static int product(void)
{
    int n = atom();

    for (;;)
        if (word("*"))
            n *= atom();
        else if (word("/"))
            n /= atom();
        else if (word("%"))
            n %= atom();
        else
            return n;
}

static int sum(void)
{
    int n = product();

    for (;;)
        if (word("+"))
            n += product();
        else if (word("-"))
            n -= product();
        else
            return n;
}

static int expr(void)
{
    int n = sum();

    if (word("<"))
        return n < sum();
    if (word(">"))
        return n > sum();
    if (word("="))
        return n == sum();
    return n;
}

static int find(const struct line *program, int number)
{
    int i;

    for (i = 0; program[i].text; i++)
        if (program[i].number == number)
            return i;
    return -1;
}

static void print(void)
{
    do {
        skip();
        if (*p == '"') {
            for (p++; *p != '"'; p++)
                putchar(*p);
            p++;
        } else {
            printf("%d", expr());
        }
    } while (word(","));
    if (!word(";"))
        putchar('\n');
}

static void run(const struct line *program)
{
    int at = 0, v;

    while (at >= 0 && program[at].text) {
        p = program[at++].text;
    statement:
        if (word("PRINT")) {
            print();
        } else if (word("IF")) {
            int yes = expr();
            word("THEN");
            if (yes)
                goto statement;
        } else if (word("GOTO")) {
            at = find(program, expr());
        } else if (word("GOSUB")) {
            gosub[calls++] = at;
            at = find(program, expr());
        } else if (word("RETURN")) {
            at = gosub[--calls];
        } else if (word("FOR")) {
            skip();
            v = loop_var[loops] = *p++ - 'A';
            word("=");
            vars[v] = sum();
            word("TO");
            loop_end[loops] = sum();
            loop_line[loops++] = at;
        } else if (word("NEXT")) {
            if (++vars[loop_var[loops - 1]] <= loop_end[loops - 1])
                at = loop_line[loops - 1];
            else
                loops--;
        } else if (word("END")) {
            return;
        } else {
            word("LET");
            skip();
            v = *p++ - 'A';
            word("=");
            vars[v] = expr();
        }
    }
}

int main(void)
{
    static const struct line program[] = {
        { 10, "LET N = 13" }, { 20, "FOR I = 2 TO N" }, { 30, "GOSUB 100" },
        { 40, "IF P = 1 THEN PRINT I, \" \";" }, { 50, "NEXT" }, { 60, "PRINT \"\"" },
        { 65, "A = 1" }, { 70, "PRINT A, \" \", A * A, \" \", (A + 1) * -2;" }, { 75, "PRINT \";\"" },
        { 80, "A = A + 1" }, { 85, "IF A < 4 THEN GOTO 70" }, { 90, "END" },
        { 100, "LET P = 1" }, { 110, "D = 2" }, { 120, "IF D * D > I THEN RETURN" },
        { 130, "IF I % D = 0 THEN P = 0" }, { 140, "D = D + 1" }, { 150, "GOTO 120" }, { 0, 0 },
    };

    run(program);
    printf("%d %d\n", loops, calls);
    return 0;
}
