/* Conversion to a narrower signed type keeps the low bits (gcc's choice, C17 6.3.1.3p3). */
#include <stdio.h>

static signed char as_char(int n) { return n; }
static short as_short(int n) { return n; }
static unsigned char as_uchar(long long n) { return n; }
static int as_int(long long n) { return n; }

static int takes_short(short s) { return s; }
static int takes_uchar(unsigned char c) { return c; }

int main(void)
{
    int values[] = { 0, 127, 128, 255, 256, 32768, 65535, 65536, -1, -129, -32769, 123456789 };
    int i;

    for (i = 0; i < (int) (sizeof values / sizeof *values); i++)
        printf("%d: %d %d %d %d %d\n", values[i], as_char(values[i]), as_short(values[i]),
               as_uchar(values[i]), takes_short(values[i]), takes_uchar(values[i]));
    printf("%d %d\n", as_int(4294967296ll + 5), as_int(-4294967297ll));
    printf("%d\n", (int) 3000000000u);
    return 0;
}
