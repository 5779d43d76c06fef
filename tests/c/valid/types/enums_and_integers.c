/* Enumerations are integers: constants, arithmetic, negative values, in switches and bit-fields. */
#include <stdio.h>

enum level { LOW = -1, MIDDLE, HIGH = 5, HIGHER, SAME = HIGH };
enum flag { A = 1 << 0, B = 1 << 1, C = 1 << 2, ALL = A | B | C };
enum { SIZE = sizeof(int) * 4, LETTER = 'x', LAST = SIZE - 1 };
typedef enum { OFF, ON } power;
struct state { enum flag flags : 3; power power : 2; unsigned char level; };

static const char *const names[] = { [OFF] = "off", [ON] = "on" };
static enum level up(enum level l) { return l + 1; }

static const char *word(enum level l)
{
    switch (l) {
    case LOW: return "low";
    case MIDDLE: return "middle";
    case HIGH: return "high";
    default: return "other";
    }
}

int main(void)
{
    enum level level = LOW;
    enum flag flags = A | C;
    struct state state = { ALL, ON, HIGHER };
    char buffer[SIZE];
    power p = !OFF;

    printf("%d %d %d %d\n", LOW, MIDDLE, HIGHER, SAME);
    printf("%s %s %s\n", word(level), word(up(level)), word(SAME));
    level++;
    level += 5;
    printf("%d %d %d\n", level, level == HIGH, level > LOW);
    flags &= ~A;
    flags |= B;
    printf("%d %d\n", flags, (flags & C) != 0);
    printf("%d %d %d %s\n", state.flags, state.power & 1, state.level, names[p]);
    printf("%u %d %c\n", (unsigned) sizeof buffer, LAST, LETTER);
    enum { LOCAL = HIGH * 2 };
    printf("%d %u\n", LOCAL, (unsigned) sizeof(enum level));
    return 0;
}
