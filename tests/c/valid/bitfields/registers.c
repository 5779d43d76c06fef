/* A device's registers as bit-fields: read, changed, passed by value, in arrays and unions. */
#include <stdio.h>

struct motor {
    unsigned enabled : 1, direction : 1;
    unsigned speed : 10;
    signed current : 6;
    unsigned : 2;
    unsigned char fault : 4;
    unsigned long long ticks : 40;
};

union word {
    struct { unsigned b0 : 1, b1 : 1, b2 : 1, b3 : 1, rest : 28; } bit;
    unsigned all;
};

static struct motor motors[2] = { { 1, 0, 1000, -3, .fault = 9 }, { .ticks = 1ull << 39 } };

static struct motor faster(struct motor m, int by)
{
    m.speed += by;
    m.current--;
    m.ticks *= 3;
    return m;
}

static int count(union word w)
{
    return w.bit.b0 + w.bit.b1 + w.bit.b2 + w.bit.b3;
}

static void show(const struct motor *m)
{
    printf("%d %d %d %d %d %llu\n", m->enabled, m->direction, m->speed, m->current, m->fault,
           (unsigned long long) m->ticks);
}

int main(void)
{
    struct motor *p = motors, copy;
    union word w = { .all = 0xF0000005 };
    int i;

    show(p);
    copy = faster(motors[0], 50);
    show(&copy);
    copy.current = 31;
    copy.current++;
    copy.fault = ~copy.fault;
    copy.enabled = 2;
    copy.direction |= 5;
    show(&copy);
    motors[1] = copy;
    p[1].ticks -= 1;
    (p + 1)->speed >>= 2;
    show(&motors[1]);
    printf("%d %x\n", count(w), w.bit.rest);
    for (i = 0; i < 4; i++)
        w.bit.rest = w.bit.rest * 2 + i;
    w.bit.b2 = !w.bit.b2;
    printf("%08x\n", w.all);
    printf("%d %d\n", p->current < 0, p->speed - 2000 < 0);
    printf("%d\n", (p->enabled ? p->speed : 0) + (p->direction, p->fault));
    return 0;
}
