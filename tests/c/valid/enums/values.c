/* Enumeration constants are ints; values may repeat and be negative. */
#include <stdio.h>

enum colour { RED, GREEN = 5, BLUE, CYAN = BLUE, DARK = -3, DARKER };
enum { BIT0 = 1 << 0, BIT1 = 1 << 1, BIT2 = 1 << 2, ALL = BIT0 | BIT1 | BIT2 };
enum letter { A = 'a', B, SIZE = sizeof(int), LAST = B + SIZE * 2 };
typedef enum weekday { MON = 1, TUE, WED, THU, FRI, SAT, SUN, } Weekday;

static const char *name(enum colour c)
{
    switch (c) {
    case RED: return "red";
    case GREEN: return "green";
    case BLUE: return "blue";
    case DARK: return "dark";
    default: return "other";
    }
}

static Weekday after(Weekday d)
{
    return d == SUN ? MON : d + 1;
}

int main(void)
{
    enum colour c = BLUE, *p = &c;
    int counts[SUN + 1] = { [SAT] = 2, [SUN] = 3 }, i;
    enum local { X = GREEN + 1 } x = X;
    Weekday d = FRI;

    printf("%d %d %d %d %d %d\n", RED, GREEN, BLUE, CYAN, DARK, DARKER);
    printf("%d %d %d\n", ALL, B, LAST);
    printf("%s %s %s\n", name(c), name(DARK), name(100));
    *p = RED;
    printf("%d %d\n", c, x == CYAN);
    for (i = 0; i < 4; i++, d = after(d))
        printf("%d ", d);
    printf("\n%d %d\n", counts[SAT], counts[MON]);
    printf("%d\n", (int) sizeof c);
    c = 1234;
    c++;
    printf("%d\n", c);
    printf("%d\n", DARK < RED ? 1 : 2);
    {
        enum { RED = 77 };
        printf("%d\n", RED);
    }
    printf("%d\n", RED);
    return 0;
}
