/* Writes its own "code", function pointers and stack, then calls what it wrote. */
// ends: bad function pointer
#include <string.h>

typedef int (*function)(void);
static function table[16];

int main(void)
{
    unsigned seed = 99;
    int i, n = 0;

    for (;;) {
        for (i = 0; i < (int) sizeof table; i++)
            ((unsigned char *) table)[i] = (seed = seed * 1664525u + 1013904223u) >> 26;
        memset((char *) table + 1, 0, 3);
        n += table[seed & 15]();
    }
}
