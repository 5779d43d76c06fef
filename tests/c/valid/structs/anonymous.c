/* Anonymous structs and unions give their members to the one around them (C11 6.7.2.1p13). */
#include <stdio.h>

struct event {
    int kind;
    union {
        struct { int x, y; };
        struct { char *text; int length; };
        double number;
    };
    struct { short a, b; } named;
};

static void show(const struct event *e)
{
    switch (e->kind) {
    case 0: printf("move %d %d\n", e->x, e->y); break;
    case 1: printf("text %.*s\n", e->length, e->text); break;
    default: printf("number %g\n", e->number);
    }
}

int main(void)
{
    struct event events[3] = { { 0 }, { .kind = 1, .text = "bumper hit", .length = 6 }, { 2 } };
    struct { int a; struct { int b; union { int c; char d[4]; }; }; } deep = { 1, { 2, { 3 } } };
    int i;

    events[0].x = 3;
    events[0].y = -4;
    events[2].number = 2.5;
    events[2].named.b = 9;
    for (i = 0; i < 3; i++)
        show(&events[i]);
    deep.d[1] = 1;
    printf("%d %d %d\n", deep.a, deep.b, deep.c);
    printf("%d %d\n", events[2].named.a, events[2].named.b);
    printf("%d\n", (char *) &events[0].x == (char *) &events[0].number);
    return 0;
}
