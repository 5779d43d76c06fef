/* Copies and fills without end: each moves as much memory as there is. */
// ends: running
#include <string.h>

static char a[7000000], b[7000000];
struct large { char bytes[200000]; } c;

static int take(struct large by_value) { return by_value.bytes[7]; }

int main(void)
{
    for (;;) {
        memcpy(a, b, sizeof a);
        memset(b, take(c), sizeof b);
    }
}
