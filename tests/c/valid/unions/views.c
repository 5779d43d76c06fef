/* The same memory accessed as different types: bytes, halves, floats, nested members. */
#include <stdio.h>
#include <string.h>

union number { float f; unsigned u; unsigned char bytes[4]; short halves[2]; };
union wide { double d; long long q; unsigned words[2]; };
struct message { int kind; union { int i; double d; char text[8]; struct { short x, y; } at; }; };

static void show(struct message m)
{
    switch (m.kind) {
    case 0: printf("int %d\n", m.i); break;
    case 1: printf("double %g\n", m.d); break;
    case 2: printf("text %s\n", m.text); break;
    default: printf("at %d %d\n", m.at.x, m.at.y);
    }
}

static union number swapped(union number n)
{
    unsigned char spare = n.bytes[0];
    n.bytes[0] = n.bytes[3];
    n.bytes[3] = spare;
    return n;
}

int main(void)
{
    union number n = { 1.5f }, *p = &n;
    union wide w = { .q = 0x4009 << 16 };
    struct message list[] = { { 0, { 7 } }, { 1, .d = 2.5 }, { 2, .text = "hi" }, { 3, .at = { -1, 4 } } };

    printf("%08x %d %d\n", n.u, p->halves[1], n.bytes[2]);
    n.u |= 0x80000000u;
    printf("%g\n", p->f);
    printf("%08x\n", swapped(n).u);
    w.words[1] = 0x40091eb8;
    w.words[0] = 0x51eb851f;
    printf("%.2f %llx\n", w.d, w.q);
    w.d = -0.0;
    printf("%x %x %d\n", w.words[0], w.words[1], w.q < 0);
    for (int i = 0; i < 4; i++)
        show(list[i]);
    list[1] = list[2];
    strcat(list[1].text, "!!");
    show(list[1]);
    show(list[2]);
    printf("%u %u\n", (unsigned) sizeof n, (unsigned) sizeof(struct message));
    return 0;
}
