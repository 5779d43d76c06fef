/* Duff's device, and a coroutine made from a switch that jumps into a loop. */
#include <stdio.h>

static void send(char *to, const char *from, int count)
{
    int n = (count + 7) / 8;

    switch (count % 8) {
    case 0: do { *to++ = *from++;
    case 7:      *to++ = *from++;
    case 6:      *to++ = *from++;
    case 5:      *to++ = *from++;
    case 4:      *to++ = *from++;
    case 3:      *to++ = *from++;
    case 2:      *to++ = *from++;
    case 1:      *to++ = *from++;
            } while (--n > 0);
    }
}

#define BEGIN switch (line) { case 0:
#define YIELD(v) do { line = __LINE__; return v; case __LINE__:; } while (0)
#define END } line = 0; return -1

static int generate(void)
{
    static int line, i, j;

    BEGIN;
    for (i = 0; i < 3; i++) {
        for (j = 0; j <= i; j++)
            YIELD(i * 10 + j);
        if (i == 1)
            YIELD(99);
    }
    END;
}

int main(void)
{
    char buffer[40] = { 0 };
    const char *text = "the quick brown fox jumps over it";
    int n;

    for (n = 1; n < 34; n += 5) {
        send(buffer, text, n);
        buffer[n] = 0;
        printf("%s\n", buffer);
    }
    for (n = 0; n < 10; n++)
        printf("%d ", generate());
    printf("\n");
    return 0;
}
