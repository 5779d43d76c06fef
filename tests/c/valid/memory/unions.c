/* A union is read as another member, and a number by its bytes. */
#include <stdio.h>
#include <string.h>

union word { int number; unsigned char bytes[4]; float real; short halves[2]; };

int main(void)
{
    union word w;
    double d = 1.0;
    unsigned char *p = (unsigned char *) &d;
    int i;

    w.real = 1.0f;
    printf("%x %x %d\n", w.number, w.bytes[3], w.halves[0]);
    w.halves[0] = 1;
    w.halves[1] = 2;
    printf("%x\n", w.number);
    for (i = 0; i < 8; i++)
        printf("%02x", p[i]);
    printf("\n");
    memset(&w, 0, sizeof w);
    w.bytes[1] = 1;
    printf("%d\n", w.number);
    return 0;
}
