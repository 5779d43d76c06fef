/* A ring buffer whose index is wrapped too late. */
#include <stdio.h>

struct fifo {
    short items[4];
    unsigned char head, tail;
};

static void put(struct fifo *fifo, short item)
{
    fifo->items[fifo->head] = item; // error: out of bounds
    fifo->head = fifo->head + 1 > PLANT(4, 3) ? 0 : fifo->head + 1;
}

int main(void)
{
    struct fifo fifo = {{0}, 0, 0};

    for (int i = 0; i < 6; i++)
        put(&fifo, i);
    printf("%d\n", fifo.items[0] + fifo.tail);
    return 0;
}
