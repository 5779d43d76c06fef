/* Enums as array indexes, table sizes and bit masks. */
#include <stdio.h>

typedef enum { STOP, GO, TURN, STATES } State;
typedef enum { NONE, SEEN, TIMEOUT, EVENTS } Event;

static const State table[STATES][EVENTS] = {
    [STOP] = { STOP, TURN, GO },
    [GO] = { [SEEN] = STOP, [NONE] = GO, [TIMEOUT] = TURN },
    [TURN] = { TURN, TURN, GO },
};
static const char *const names[STATES] = { "stop", "go", "turn" };

enum flag { READ = 1, WRITE = 2, RUN = 4 };

static void permissions(unsigned flags)
{
    printf("%c%c%c ", flags & READ ? 'r' : '-', flags & WRITE ? 'w' : '-', flags & RUN ? 'x' : '-');
}

int main(void)
{
    Event events[] = { NONE, TIMEOUT, NONE, SEEN, SEEN, TIMEOUT, SEEN };
    State s = STOP;
    int i, visits[STATES] = { 0 };
    unsigned f;

    for (i = 0; i < (int) (sizeof events / sizeof events[0]); i++) {
        s = table[s][events[i]];
        visits[s]++;
        printf("%s ", names[s]);
    }
    printf("\n%d %d %d\n", visits[STOP], visits[GO], visits[TURN]);
    for (f = 0; f < 8; f += 3)
        permissions(f);
    permissions(READ | RUN & ~WRITE);
    printf("\n");
    return 0;
}
