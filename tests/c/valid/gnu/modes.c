/* Types specified by their size, with the attribute mode. */
#include <stdio.h>

typedef int tiny __attribute__((mode(QI)));
typedef unsigned int half __attribute__((__mode__(__HI__)));
typedef unsigned wide __attribute__((mode(DI)));
typedef int word __attribute__((mode(__word__)));
typedef float twice __attribute__((mode(DF)));

struct packet {
    int kind __attribute__((mode(HI)));
    unsigned long at __attribute__((mode(pointer)));
    signed stamp __attribute__((mode(DI)));
};
typedef int small __attribute__((mode(HI)));
static small table[3] = {1, -2, 70000};

int main(void)
{
    tiny t = 200;
    half h = 70000;
    wide w = ~(wide)0;
    twice d = 0.1;
    int local __attribute__((mode(byte))) = 300;

    printf("%d %d %d %d %d\n", (int)sizeof t, (int)sizeof h, (int)sizeof w, (int)sizeof(word),
           (int)sizeof d);
    printf("%d %u %llu %.17g %d\n", t, h, w, d, local);
    printf("%d %d\n", (int)sizeof(struct packet), (int)sizeof table);
    printf("%d %d %d\n", table[0], table[1], table[2]);
    return 0;
}
