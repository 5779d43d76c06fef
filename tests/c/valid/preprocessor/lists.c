/* Tables written once and used several times, as programs with many commands do. */
#include <stdio.h>
#include <string.h>

#define COMMANDS(X) \
    X(GO,   "go",   2, distance * 1.5) \
    X(TURN, "turn", 1, angle / 2)      \
    X(STOP, "stop", 0, 0)

#define AS_ENUM(name, text, count, value) CMD_##name,
#define AS_TEXT(name, text, count, value) [CMD_##name] = text,
#define AS_PROTOTYPE(name, text, count, value) static double do_##name(double, double);
#define AS_FUNCTION(name, text, count, value) \
    static double do_##name(double distance, double angle) \
    { (void) distance, (void) angle; return value; }
#define AS_ROW(name, text, count, value) { text, count, do_##name },

enum command { COMMANDS(AS_ENUM) CMD_COUNT };
static const char *const texts[] = { COMMANDS(AS_TEXT) };
COMMANDS(AS_PROTOTYPE)

static const struct row { const char *text; int count; double (*call)(double, double); } rows[] = {
    COMMANDS(AS_ROW)
};

COMMANDS(AS_FUNCTION)

#define EACH_2(m, a) m(a) m((a) + 1)
#define EACH_4(m, a) EACH_2(m, a) EACH_2(m, (a) + 2)
#define PLUS(n) + (n)

int main(void)
{
    for (int i = 0; i < CMD_COUNT; i++)
        printf("%s %d %g %d\n", texts[i], rows[i].count, rows[i].call(10, 90),
               strcmp(rows[i].text, texts[i]));
    printf("%d %d\n", CMD_STOP, 0 EACH_4(PLUS, 10));
    return 0;
}
