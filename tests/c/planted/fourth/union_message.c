/* A message is filled in part, copied into a queue, and its other member read. */
#include <stdio.h>
#include <string.h>

struct message {
    int kind;
    union {
        short angle;
        int distance;
    } value;
};

static struct message queue[4];

int main(void)
{
    struct message message;

    message.kind = 1;
    message.value.PLANT(angle, distance) = 7;
    memcpy(&queue[2], &message, sizeof message);
    printf("%d\n", queue[2].kind + queue[2].value.distance); // error: uninitialised read
    return 0;
}
