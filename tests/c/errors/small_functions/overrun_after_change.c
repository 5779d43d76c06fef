/* A small function changes memory before it fails: it is stopped with its frame on the stack. */
#include <stdio.h>

struct stack { int count, numbers[3]; };

static struct stack stack;

static void push(struct stack *to, int number)
{
    to->numbers[to->count++] = number;  // error: out of bounds
}

int main(void)
{
    int i;
    for (i = 0; i < 5; i++)
        push(&stack, i);
    printf("%d\n", stack.count);
    return 0;
}
