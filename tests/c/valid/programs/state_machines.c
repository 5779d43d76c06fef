/* A vending machine, a debouncer and a traffic light as state machines with timers. */
#include <stdio.h>

typedef enum { IDLE, HAS_COIN, VENDING, OUT } Vending;
typedef struct { Vending state; int coins, stock, sold; } Machine;

static const char *feed(Machine *m, char event)
{
    switch (m->state) {
    case IDLE:
        if (event == 'c') { m->coins++; m->state = HAS_COIN; return "thanks"; }
        if (event == 'b') return "insert coin";
        break;
    case HAS_COIN:
        if (event == 'c') { m->coins++; return "more"; }
        if (event == 'r') { m->coins = 0; m->state = IDLE; return "returned"; }
        if (event == 'b') {
            if (m->coins < 2) return "not enough";
            m->coins -= 2;
            m->state = VENDING;
            return "vending";
        }
        break;
    case VENDING:
        if (event == 't') {
            m->sold++;
            m->state = --m->stock ? m->coins ? HAS_COIN : IDLE : OUT;
            return "take it";
        }
        return "wait";
    case OUT:
        return "empty";
    }
    return "?";
}

struct light { const char *name; int seconds; const struct light *next; };
extern const struct light green;
static const struct light red = { "red", 4, &green };
static const struct light yellow = { "yellow", 1, &red };
const struct light green = { "green", 3, &yellow };

static int debounce(unsigned *history, int level)
{
    *history = *history << 1 | (level & 1);
    return (*history & 0xF) == 0xF ? 1 : (*history & 0xF) == 0 ? 0 : -1;
}

int main(void)
{
    Machine m = { IDLE, 0, 2, 0 };
    const char *events = "bcbcbtccrccbctbtcb", *bounce = "0110111100101111110000";
    const struct light *l = &red;
    unsigned history = 0;
    int t, left;

    for (; *events; events++)
        printf("%c:%s ", *events, feed(&m, *events));
    printf("\n%d %d %d\n", m.state, m.coins, m.sold);
    for (t = 0, left = l->seconds; t < 18; t++) {
        printf("%c", *l->name);
        if (--left == 0)
            l = l->next, left = l->seconds;
    }
    printf("\n");
    for (; *bounce; bounce++)
        printf("%d", debounce(&history, *bounce - '0') + 1);
    printf("\n");
    return 0;
}
