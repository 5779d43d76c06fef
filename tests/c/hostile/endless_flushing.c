/* One byte at a time, flushed, without end, to both streams. */
// ends: running
#include <stdio.h>

int main(void)
{
    for (;;) {
        putchar('.');
        fflush(stdout);
        fputc('!', stderr);
    }
}
