/* State machines as tables: states, events, guards and actions as functions. */
#include <stdio.h>

enum state { RED, RED_YELLOW, GREEN, YELLOW, BLINK, STATES };
enum event { TICK, BUTTON, FAULT, REPAIRED, EVENTS };
struct light { enum state state; int seconds, waiting, cycles; };

typedef int guard(const struct light *);
typedef void action(struct light *);

static guard always, long_enough, green_may_end;
static action reset, remember, count, nothing;

static const struct rule {
    enum state from;
    enum event on;
    guard *if_so;
    action *act;
    enum state to;
} rules[] = {
    { RED, TICK, long_enough, reset, RED_YELLOW },
    { RED_YELLOW, TICK, always, reset, GREEN },
    { GREEN, BUTTON, always, remember, GREEN },
    { GREEN, TICK, green_may_end, reset, YELLOW },
    { YELLOW, TICK, always, count, RED },
    { BLINK, REPAIRED, always, reset, RED },
    { BLINK, TICK, always, nothing, BLINK },
};

static int always(const struct light *l) { (void) l; return 1; }
static int long_enough(const struct light *l) { return l->seconds >= 3; }
static int green_may_end(const struct light *l) { return l->seconds >= (l->waiting ? 2 : 5); }
static void nothing(struct light *l) { (void) l; }
static void reset(struct light *l) { l->seconds = 0; }
static void remember(struct light *l) { l->waiting = 1; }
static void count(struct light *l) { reset(l); l->cycles++; l->waiting = 0; }

static const char *const names[STATES] = { "red", "red-yellow", "green", "yellow", "blink" };

static void handle(struct light *l, enum event e)
{
    if (e == TICK)
        l->seconds++;
    if (e == FAULT) {
        l->state = BLINK;
        return;
    }
    for (const struct rule *r = rules; r < rules + sizeof rules / sizeof *rules; ++r)
        if (r->from == l->state && r->on == e && r->if_so(l)) {
            r->act(l);
            if (r->to != r->from)
                printf("%s -> %s\n", names[r->from], names[r->to]);
            l->state = r->to;
            return;
        }
}

int main(void)
{
    struct light light = { .state = RED };
    const char *events = "tttttbtttttttttttttttbFttRttttt";

    for (; *events; events++)
        switch (*events) {
        case 't': handle(&light, TICK); break;
        case 'b': handle(&light, BUTTON); break;
        case 'F': handle(&light, FAULT); break;
        case 'R': handle(&light, REPAIRED);
        }
    printf("%s after %d cycles, %d s\n", names[light.state], light.cycles, light.seconds);
    return 0;
}
