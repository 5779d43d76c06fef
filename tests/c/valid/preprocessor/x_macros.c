/* X macros: one list makes an enum, a table, a switch and a sum. */
#include <stdio.h>

#define COMMANDS(X) \
    X(VM, 3, "velocity") \
    X(PR, 3, "relative") \
    X(ST, 0, "stop") \
    X(WS, 4, "wait")

#define AS_ENUM(name, args, text) CMD_##name,
enum command { COMMANDS(AS_ENUM) CMD_COUNT };

#define AS_ROW(name, args, text) { #name, args, text },
static const struct { const char *name; int args; const char *text; } table[] = { COMMANDS(AS_ROW) };

#define AS_FUNCTION(name, args, text) static int run_##name(int n) { return n * args; }
COMMANDS(AS_FUNCTION)

static int run(enum command c, int n)
{
    switch (c) {
#define AS_CASE(name, args, text) case CMD_##name: return run_##name(n);
    COMMANDS(AS_CASE)
#undef AS_CASE
    default: return -1;
    }
}

#define PLUS_ARGS(name, args, text) + args
enum { TOTAL = 0 COMMANDS(PLUS_ARGS) };

int main(void)
{
    int i;

    for (i = 0; i < CMD_COUNT; i++)
        printf("%d %s %d %s %d\n", i, table[i].name, table[i].args, table[i].text, run(i, 10));
    printf("%d %d\n", TOTAL, run(CMD_COUNT, 1));
    return 0;
}
