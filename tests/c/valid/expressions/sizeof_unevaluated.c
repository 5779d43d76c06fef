/* The operand of sizeof is not evaluated, and not converted. */
#include <stdio.h>

static int calls;
static int call(void) { return ++calls; }
static double halves[6];

int main(void)
{
    int i = 5;
    char text[] = "four", *p = text;
    int table[3][7];

    printf("%u %u\n", (unsigned) sizeof(i++), (unsigned) sizeof call());
    printf("%u %u %u\n", (unsigned) sizeof text, (unsigned) sizeof p, (unsigned) sizeof *p);
    printf("%u %u\n", (unsigned) sizeof "text", (unsigned) sizeof("a" "b"));
    printf("%u %u %u\n", (unsigned) sizeof table, (unsigned) sizeof table[0],
           (unsigned) sizeof(table + 0));
    printf("%u %u\n", (unsigned) (sizeof halves / sizeof halves[0]), (unsigned) sizeof *halves);
    printf("%u %u\n", (unsigned) sizeof(char) * 3, (unsigned) sizeof(struct { int a; char b; }));
    printf("%u\n", (unsigned) sizeof(((struct { char a[9]; } *) 0)->a));
    printf("%u %u\n", (unsigned) sizeof(0, text), (unsigned) sizeof(+text[0]));
    printf("%u\n", (unsigned) sizeof(int (*)(int[100])));
    printf("%u\n", (unsigned) sizeof 1 + 1);
    printf("%u\n", (unsigned) sizeof(i) - 1);
    printf("%d %d\n", i, calls);
    return 0;
}
