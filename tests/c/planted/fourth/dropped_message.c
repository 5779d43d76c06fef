/* Messages of a queue; one is dropped without being freed. */
#include <stdio.h>
#include <stdlib.h>

struct message {
    struct message *next;
    int number;
};

int main(void)
{
    struct message *queue = NULL;

    for (int i = 0; i < 3; i++) {
        struct message *message = malloc(sizeof *message); // leak: 1

        message->next = queue;
        message->number = i;
        queue = message;
    }
    while (queue) {
        struct message *next = queue->next;

        PLANT(if (queue->number != 1), )
            free(queue);
        queue = next;
    }
    puts("done");
    return 0;
}
