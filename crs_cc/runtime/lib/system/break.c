/* The end of the data segment (BSD; POSIX.1 until 2001), which allocators of old programs move: a
   block of the heap that is set aside at the first call. */
#include <errno.h>
#include <stdlib.h>
#include <unistd.h>

#define ROOM 0x200000

static char *start, *end;

static void *move(int increment)
{
    if (start == NULL)
        start = end = calloc(ROOM, 1);
    if (start == NULL || increment < start - end || increment > start + ROOM - end) {
        errno = ENOMEM;
        return (void *) -1;
    }
    end += increment;
    return end - increment;
}

void *sbrk(int increment)
{
    return move(increment);
}

int brk(void *address)
{
    char *now = move(0);

    if (now == (char *) -1)
        return -1;
    return move((char *) address - now) == (void *) -1 ? -1 : 0;
}
