/* Bit-fields: widths, signs, packing, assignment, arithmetic. */
#include <stdio.h>

struct status { unsigned left : 1, right : 1; int speed : 5; unsigned mode : 3; unsigned : 0; unsigned rest : 20; };
struct signs { int a : 3; unsigned b : 3; signed char c : 4; _Bool d : 1; };
union view { struct { unsigned low : 4, middle : 8, high : 20; } f; unsigned word; };

int main(void)
{
    struct status s = { 1, 0, -3, 5, 1000000 };
    struct signs g = { 3, 7, -8, 1 };
    union view v;
    struct status *p = &s;

    printf("%d %d %d %d %d\n", s.left, s.right, s.speed, s.mode, s.rest);
    s.speed += 10;
    s.mode++;
    p->right = 3;
    p->rest -= 1;
    printf("%d %d %d %d\n", s.speed, s.mode, s.right, p->rest);
    s.mode += 5;
    printf("%d\n", s.mode);
    printf("%d %d %d %d\n", g.a, g.b, g.c, g.d);
    g.a = 5;
    g.b = -1;
    printf("%d %d\n", g.a, g.b);
    printf("%d\n", (g.a = 12));
    v.word = 0x12345678;
    printf("%x %x %x\n", v.f.low, v.f.middle, v.f.high);
    v.f.middle = 0xff;
    printf("%x\n", v.word);
    printf("%d %d\n", (int) sizeof(struct status), (int) sizeof v);
    printf("%d\n", s.left << 4 | s.right);
    return 0;
}
